"""When something is so, in words that stand elsewhere in a plain sentence: "must at no time touch", "not even briefly",
"wait until ..., then ...", as rows that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import MUST

_MUST = f"(?:{MUST}|may|can|might)"
_NEVER = "(?:at no (?:time|point|moment|stage|instant)|on no occasion|not once|never ever|not ever)"
_EVER = "(?:at any (?:time|point|moment)|at all times|the whole time|the entire time|all the time|throughout|always)"
_BLOCK = "(?:block|cube|brick|thing)"
_STEP = "(?:put|place|move|stack|set|bring|lay|take|unstack|swap|build|make|line up|carry|transfer|shift)"
_MOVED = "(?:moved|touched|disturbed|displaced|shifted)"
_OTHERS = "the others stay where they are"
_BARE = "nothing may ever be on {1}"
_SO = "(?:is|are|has been|have been|lies|stands|sits|rests)"
AT_TIMES: tuple[Turn, ...] = (
    # never
    (f"\\b{_NEVER} (touch|touches|lie|lies|put|place|let|move|take|stack|leave|leaves|lift|allow)\\b", "never {1}"),
    ("\\b(not [^,]+?)(?: ,)? not even (?:temporarily|briefly|momentarily|shortly|in passing|in between|once|for (?:a|"
     "one|a short|a brief|a single) (?:moment|second|time|while|instant))$", "{1} at any time"),
    ("\\b(?:is|are) (not|never) (?:allowed|permitted|supposed) to\\b", "must {1}"),
    ("\\bwithout (.+?) ever (?:being|lying|standing) on (.+)$", "and {1} must never be on {2}"),
    ("\\bwithout (.+?) ever touching (.+)$", "and {1} must never touch {2}"),
    (f"\\b((?:the [^,]+?|\\w+)) {MUST} (?:be|stay|remain|be kept) (?:clear|free) {_EVER}$", _BARE),
    (f"\\b(?:{MUST}|may) not leave (.+?)(?: {_EVER})?$", "must not leave {1}"),
    # nothing else
    (f"\\b(?:no other {_BLOCK}|nothing else) (?:moves|(?:{_MUST} )?(?:be|is|gets?) {_MOVED}|{_MUST} move)$", _OTHERS),
    (f"\\bwithout (?:moving|touching|disturbing) (?:any other {_BLOCK}s?|anything else)$", "without moving the others"),
    # one after the other
    (f"^(?:please )?wait (?:until|till) (.+?)(?: ,)? (?:and )?(?:then|before you) ({_STEP} .+)$", "once {1} , {2}"),
    (f"^(.+?)(?: ,)? (?:but )?(?:as soon as|once|only when|but not until) ([^,]+? {_SO} .+)$", "once {2} , {1}"),
    (f"^(.+?) ({MUST}|may) not be (?:put|placed|moved|stacked) (on .+?) (?:before|until) ([^,]+? {_SO} .+)$",
     "once {4} , put {1} {3}"),
    ("^(.+?) (first|at first) and (.+?) (?:after that|at last|last of all)$", "first {1} , then {3}"),
    ("^(?:the )?first (?:thing (?:to do )?|step )?is to (.+?) ,(?: and)? (?:the )?(?:second|next|last)(?: thing| "
     "step)? is to (.+)$", "first {1} , then {2}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("temporarily", "briefly", "momentarily", "permitted", "wait", "instant", "occasion")
"""Words that these take besides those that are read anyway."""
