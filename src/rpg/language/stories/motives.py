"""Why blocks are where they are, in a story: "so that it can see everything", "to keep it company", "because it is the
boss", "for contrast". Their place is told besides; what would follow for it, as from "so that they can see each other",
is kept."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR

_WHO = f"(?:it|they|he|she|everybody|everyone|both(?: of them)?|all of them|the {COLOR}(?: one| block| cube)?)"
_WHOM = "(?:it|them|him|her|each other|one another)"
_MORE = "(?: too| again| any more| anymore| better| well| far| a bit| a little)?"
_SIGHT = (
    "(?:the )?(?:everything|everybody|everyone|view|world|whole (?:world|table|scene|room)|sea|sky|stars|sun|landscape)"
)
_DO = (
    f"(?:(?:see|look|watch|look out)(?: {_SIGHT})?|see over (?:{_WHOM}|everything|the others)|"
    "enjoy the (?:view|sun|peace)|have (?:a|the) (?:\\w+ )?(?:view|chat|look|nap|rest|sleep)|take a (?:nap|rest)|"
    "breathe|sleep|rest|relax|dream|sunbathe|play|chat|talk|say hello|play together|be friends|"
    "(?:feel|be|stay) (?:safe|warm|happy|cosy|cozy|comfortable)|"
    f"keep (?:warm|watch|{_WHOM} (?:company|warm|safe))|talk to {_WHOM}|cheer {_WHOM} up|"
    f"keep an eye on (?:things|everything|everybody|{_WHOM})|(?:look after|protect|comfort|guard) {_WHOM}|"
    f"give {_WHOM} (?:some )?company)"
)
_ILL = (
    "(?:so |too |all )?(?:lonely|alone|cold|bored|sad|afraid|scared|jealous|hungry|left out|tired|"
    "sleepy|shy|cross|lost)"
)
_RANK = "(?:boss|king|queen|star|leader|hero|favorite|best|chief|captain|guest of honor)"
_IS = (
    f"(?:(?:is|are|feels?|gets?) {_ILL}|(?:is|are) (?:the|its|a) {_RANK}|(?:is|are) afraid of the dark|"
    "(?:likes?|loves?|enjoys?) (?:the view|company|heights|peace and quiet|it (?:there|that way|up there)))"
)
_WELL = f"(?:does|do|will|is|are) not (?:(?:be|feel|get) )?{_ILL}"
_END = "(?=$| ,| and (?:put|place|stack|move|then|the|a)\\b)"
_BIT = (
    "(?:an? (?:little )?(?:bit|touch|hint|dash|splash|pinch) of |(?:some |more |extra |added )*)"
    "(?:drama|contrast|effect|elegance|style|flair|charm|interest|emphasis|sparkle|glamour|variety|luck|decoration)"
)

MOTIVES: tuple[Turn, ...] = (
    (f"(?: ,)? (?:so that|so|in order that) {_WHO} (?:(?:can|could|may|might|will) {_DO}|{_WELL}){_MORE}{_END}", ""),
    (f"(?: ,)? (?:because|since|for|as) {_WHO} (?:{_IS}|(?:wants?|likes?|loves?|needs?|would like) to {_DO}){_MORE}"
     f"{_END}", ""),
    (f"(?: ,)? (?:just |in order |so as )?to {_DO}{_MORE}$", ""),
    ("(?: ,)? for (?:some |a (?:little )?)?(?:company|nap|rest|chat|sleep|protection|comfort)$", ""),
    (f"^(?:for|to add|adding) {_BIT} ,", ""),
    (f"(?: ,)? (?:for|to add|adding) {_BIT}$", ""),
    (f"^({THING}) (?:would like|wants|needs|loves|likes|wishes) to {_DO}{_MORE}(?: ,)? so ", "there is {1} . "),
)  # fmt: skip
"""What is left out of a sentence; "the red block wants to see everything, so ..." says that there is one."""
