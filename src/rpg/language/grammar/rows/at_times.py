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
    (f"\\b({_MUST}) {_NEVER}\\b", "{1} never"),
    (f"\\b(is|are) {_NEVER} (on|in|near|next to|touching|above|below|to)\\b", "{1} never {2}"),
    (f"\\b{_NEVER} (touch|touches|lie|lies|put|place|let|move|take|stack|leave|leaves|lift|allow)\\b", "never {1}"),
    ("\\bnot once (may|must|should|can|shall) ", "at no time {1} "),
    (f"\\bat no (?:time|point|moment) ({_MUST}) there be an? {_BLOCK} (on|in) ", "no block {1} ever be {2} "),
    (f"\\bthere ({_MUST}) never be an? {_BLOCK} (on|in) ", "no block {1} ever be {2} "),
    ("\\b(not [^,]+?)(?: ,)? not even (?:temporarily|briefly|momentarily|shortly|in passing|in between|once|"
     "for (?:a|one|a short|a brief|a single) (?:moment|second|time|while|instant))$", "{1} at any time"),
    ("\\b(not (?:touch|be on|be placed on|be put on|lie on|be in|be next to) [^,]+?) in between$", "{1} at any time"),
    ("\\b(?:is|are) (not|never) (?:allowed|permitted|supposed) to\\b", "must {1}"),
    ("\\b(?:is|are) (not|never) (?:allowed|permitted) (on|in)\\b", "must {1} be {2}"),
    (f"\\bavoid (the [^,]+?|\\w+) touching (.+?) {_EVER}$", "{1} must never touch {2}"),
    ("\\bwithout (.+?) ever (?:being|lying|standing) on (.+)$", "and {1} must never be on {2}"),
    ("\\bwithout (the [^,]+?|\\w+) (?:being|lying|standing) on (.+)$", "and {1} must not be on {2}"),
    ("\\bwithout (.+?) ever touching (.+)$", "and {1} must never touch {2}"),
    ("\\bwithout (.+?) ever leaving (.+)$", "and {1} must never leave {2}"),
    ("\\bwithout ever letting (.+?) touch (.+)$", "and {1} must never touch {2}"),
    (f"\\b({MUST}) not at any (?:time|point|moment)\\b", "{1} never"),
    ("\\bnothing is (?:ever )?to be (?:put|placed|stacked|laid) on ", "nothing may ever be on "),
    (f"\\b(?:always keep|keep) (.+?) (?:clear|free)(?: of (?:other )?blocks)?(?: {_EVER})?$", _BARE),
    (f"\\b((?:the [^,]+?|\\w+)) {MUST} always (?:be|stay|remain|be kept) (?:clear|free)$", _BARE),
    (f"\\b((?:the [^,]+?|\\w+)) {MUST} (?:be|stay|remain|be kept) (?:clear|free) {_EVER}$", _BARE),
    (f"\\bthe top of (.+?) {MUST} always (?:be|stay|remain) (?:clear|free|empty)$", _BARE),
    (f"\\b((?:the [^,]+?|\\w+)) {MUST} have nothing on (?:it|top) {_EVER}$", _BARE),
    (f"\\b(?:{MUST}|may) not leave (.+?)(?: {_EVER})?$", "must not leave {1}"),
    (f"\\b((?:the [^,]+?|\\w+)) {MUST} never have (?:a {_BLOCK}|anything) on (?:it|top)(?: of it)?$",
     _BARE),
    # nothing else
    (f"\\b(?:no other {_BLOCK}|nothing else) (?:moves|(?:{_MUST} )?(?:be|is|gets?) {_MOVED}|{_MUST} move)$", _OTHERS),
    (f"\\b(?:do not|never) (?:move|touch|disturb|displace) any other {_BLOCK}s?$", "leave the others where they are"),
    (f"\\bwithout (?:moving|touching|disturbing) (?:any other {_BLOCK}s?|anything else)$", "without moving the others"),
    # one after the other
    (f"^(?:please )?wait (?:until|till) (.+?)(?: ,)? (?:and )?(?:then|before you) ({_STEP} .+)$", "once {1} , {2}"),
    (f"^(.+?)(?: ,)? (?:but )?(?:as soon as|once|only when|but not until) ([^,]+? {_SO} .+)$", "once {2} , {1}"),
    (f"^(.+?) ({MUST}|may) not be (?:put|placed|moved|stacked) (on .+?) (?:before|until) ([^,]+? {_SO} .+)$",
     "once {4} , put {1} {3}"),
    (f"^not until ([^,]+? {_SO} .+?) (?:may|must|should|can) (.+?) be (?:put|placed|moved|stacked) (on .+)$",
     "once {1} , put {2} {3}"),
    ("^(.+?) (first|at first) and (.+?) (?:after that|at last|last of all)$", "first {1} , then {3}"),
    ("^(?:the )?first (?:thing (?:to do )?|step )?is to (.+?) ,(?: and)? (?:the )?(?:second|next|last)"
     "(?: thing| step)? is to (.+)$", "first {1} , then {2}"),
    (f"^({_STEP} .+?) as the (?:second|last|next) (?:step|thing)(?: ,)? and ({_STEP} .+?) as the first$",
     "first {2} , then {1}"),
    (f"^({_STEP} .+?) as the first (?:step|thing)(?: ,)? and ({_STEP} .+?) as the (?:second|last|next)$",
     "first {1} , then {2}"),
    (f"^({_STEP} .+?)(?: ,)? having first ({_STEP} .+)$", "first {2} , then {1}"),
    (f"^({_STEP} .+?)(?: ,)? and(?: ,)? when ([^,]+? {_SO} [^,]+?) , ({_STEP} .+)$", "{1} . once {2} , {3}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("temporarily", "briefly", "momentarily", "permitted", "wait", "instant", "occasion")
"""Words that these take besides those that are read anyway."""
