"""Verbs that tell how things lie to each other: "a red cube crowns the tower", "four green ones encircle it", "they
arrange themselves in a row", as rows that say it with "be"."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE, THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST

_LET = "^(?:let |have |make )?"
_DO = f"(?:{MUST} )?(?:(?:end|finish|wind) up )?"
_WHAT = "((?:the|an?|each|every|all|both|one|it|them) .+|it|them)"
_LOT = f"(?:all )?(?:the )?(?:({MANY}) )?({COLOR}) (?:blocks|cubes|ones)"
_ON = "(?:crown|top|cap|surmount)(?:s|ing)?(?: off)?"
_UNDER = "(?:underpins?|props? up|underlies?|shoulders?)"
_BESIDE = "(?:neighbors?|borders?)"
_AGAINST = (
    "(?:abuts?|contacts?|(?:press|butt|push|nestle|snuggle|cuddle)(?:e?s)? (?:up )?against|"
    "(?:comes?|gets?) (?:in|into) contact with|makes? contact with)"
)
_AWAY = "(?:steers? clear of|shuns?|gives? a wide berth to)"
_AROUND = (
    "(?:surround(?:ing)?|encircl(?:e|ing)|enclos(?:e|ing)|encompass(?:ing)?|envelop(?:ing)?|fram(?:e|ing)|"
    "embrac(?:e|ing)|(?:hem|box|wall) in|(?:gather|stand|sit|huddle|cluster|crowd|lie|go|be|group) (?:all )?"
    "a?round)"
)
_CIRCLE = (
    "(?:ring(?:ing)?|circl(?:e|ing)|(?:form|make|build) a (?:ring|circle) a?round|(?:gather|stand|sit|lie|dance|be) in "
    "a (?:ring|circle) a?round|dance a?round)"
)
_REACH = "(?:arrive (?:at|on|in)|reach|enter|make it to|head (?:to|for)|travel to|dock at|park (?:at|on|in)|inhabit)"
_FORM = "(?:constitutes?|makes? up|yields?|shapes?|amounts? to|results? in|adds? up to)"
_STAY = "(?:ride|roost|squat|recline|lurk|shelter|crouch|linger|dwell|wait|park|dock|loiter)"
_COME = "(?:arrives?|comes?(?: in)?|enters?)"
_LEAVE = "(?:leaves?|exits?|departs?|(?:go|goes|ships?) out)"
_THEMSELVES = (("arrange", "arranged"), ("organize", "organized"), ("line", "lined"), ("sort", "sorted"),
               ("order", "ordered"), ("stack", "stacked"), ("group", "grouped"), ("rearrange", "rearranged"),
               ("pile", "piled"), ("spread", "spread"), ("assemble", "assembled"))  # fmt: skip

VERBS_OF_PLACE: tuple[Turn, ...] = (
    (f"{_LET}({THING}) {_DO}{_ON} {_WHAT}$", "{1} must be on top of {2}"),
    (f"{_LET}({THING}) {_DO}{_UNDER} {_WHAT}$", "{1} must support {2}"),
    (f"{_LET}({THING}) {_DO}{_BESIDE} {_WHAT}$", "{1} must be adjacent to {2}"),
    (f"{_LET}({THING}) {_DO}{_AGAINST} {_WHAT}$", "{1} must touch {2}"),
    (f"{_LET}({THING}) {_DO}{_AWAY} {_WHAT}$", "{1} must be away from {2}"),
    (f"{_LET}({THING}) {_DO}flanks? ({THING}) (?:on|to|at) (?:the|its) (left|right)(?: side)?$",
     "{1} must be directly to the {3} of {2}"),
    (f"{_LET}{_LOT} {_DO}{_AROUND} ({THING})(?: (?:from|on) (?:all|its|all its)(?: four)? sides)?$",
     "{3} must be surrounded by {1} {2} blocks"),
    (f"{_LET}{_LOT} {_DO}{_CIRCLE} ({THING})$", "{3} must be surrounded by {1} {2} blocks in a circle"),
    (f"{_LET}({THING}) {MUST} {_REACH} {_WHAT}$", "{1} must go to {2}"),
    (f"{_LET}(.+?) {_DO}{_FORM} (an? .+)$", "{1} must form {2}"),
    *((f"{_LET}(.+?) (?:{MUST} )?{do} themselves(?: up)? (.+)$", f"{{1}} must be {done} {{2}}")
      for do, done in _THEMSELVES),
    (f"{_LET}({THING}) {MUST} {_STAY} ({PLACE} .+)$", "{1} must be {2}"),
    (f"^let ({THING}) {_STAY} ({PLACE} .+)$", "let {1} be {2}"),
    (f"^({THING}) {_STAY}(?:e?s)? ({PLACE} .+)$", "{1} is {2}"),
    (f"\\b(?:wind|finish|land|turn) up (?={PLACE} )", "end up "),
    (f"^(.+?) {_COME} ((?:in|as) .+?)(?: ,)? (?:and|but) (?:then )?(?:{MUST} )?{_LEAVE} ((?:in|as) .+)$",
     "{1} start {2} and must end up {3}"),
    ("\\b(?:crowned|surmounted) (?:by|with)\\b", "topped by"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = (
    "underpin underpins underlie underlies shoulders abut props prop surmount surmounts encompass encompassing envelop "
    "enveloping embrace embracing hem dance inhabit rides roost roosts squat squats recline reclines lurk lurks "
    "shelters crouch crouches linger lingers dwell dwells loiter loiters wind shun shuns snuggle cuddle constitute "
    "arrives exits depart departs",
)
"""Words that these take besides those that are read anyway."""
