"""One scene that becomes another: "start from a heap of five, end in a row", "from red on blue to blue on red", as rows
that tell each of them under a heading of its own."""

from __future__ import annotations

from rpg.language.grammar.rows.begun import BRICK, CHAIN, EVENT, HEAP, STARTS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, LINE, MANY, MUST, TOWER

_KIND = f"(?:{LINE}|{HEAP}|pyramid|wall|square|circle|ring)s?"
_ONE = f"(?:an?|one)(?: (?:single|settled|loose))? (?:\\w+ )?{_KIND}"
_LOT = f"(?:{_ONE}|{MANY} (?:\\w+ )?{_KIND})\\b"
_SPREAD = f"{MANY} (?:\\w+ )?{BRICK}s? (?:(?:all |lying |stacked )*in|on) "
_NO_MORE = f"(?:(?! (?:to|into|then|if|when|until) | and (?!{COLOR}\\b|\\w\\b))[^:])*?"
_SCENE = f"(?:(?:{_LOT}|{_SPREAD}){_NO_MORE}|{CHAIN})"
"""Structures that are not spoken of yet, or blocks on each other, and no more."""
_SEVERAL = f"(?!one\\b){MANY} (?:\\w+ )?{_KIND}{_NO_MORE}"
_LINES = f"(?!one\\b){MANY} (?:\\w+ )?(?:row|line|column|{HEAP})s{_NO_MORE}"
_TOWERS = f"(?:an?|{MANY})(?: single)? {TOWER}s?\\b{_NO_MORE}"
_FLAT = f"(?:an?|{MANY})(?: single)? (?:row|line|column)s?"
_AND = "(?: ,| and| , and|)(?: then)?"
_ENDS = "(?:end|finish)(?:s|es)?(?: up)?"
_BECOMES = (
    f"(?:(?:{MUST} )(?:become|turn into|end up as|be (?:turned|made|changed|transformed|rebuilt|merged|combined|joined|"
    "rearranged|converted) (?:into|as|to))|becomes?|turns? into)"
)
_CHANGE = "(?:turn|make|change|transform|rebuild|merge|combine|join|unite|rearrange|convert|restack)"
_TOLD = "start : {1} . goal : {2}"
_OTHERS = (
    (f"{_SEVERAL}|{CHAIN}", f"{_TOWERS}|{CHAIN}"),
    (_LINES, f"{_FLAT}\\b{_NO_MORE}"),
    (_SEVERAL, f"{_FLAT} of {MANY} (?:\\w+ )?{BRICK}s"),
    (f"{_ONE}\\b{_NO_MORE}", _SEVERAL),
)
"""What becomes what: towers may stand in a row, and rows lie in a square, so that these are made of all of them."""

FROM_TO: tuple[Turn, ...] = (
    (f"^(?:start|begin)(?: out)? (?:from|with|in|as) ({_SCENE}){_AND} {_ENDS} (?:in|with|as|at) ({_SCENE})$", _TOLD),
    (f"^(?:the|this|each|every|our|my) {EVENT} {STARTS} (?:with|from|in|as) ({CHAIN}) and (?:it )?(?:{MUST} )?{_ENDS} "
     f"(?:with|in|as) ({CHAIN})$", _TOLD),
    (f"^(?!from {CHAIN} to {CHAIN}$)(?:(?:go|get|move|come|change|rearrange) )?from ({_SCENE}) to ({_SCENE})$", _TOLD),
    *((f"^({old}) {_BECOMES} ({new})$", _TOLD) for old, new in _OTHERS),
    *((f"^{_CHANGE} (?:the )?({old}) (?:in)?to ({new})$", _TOLD) for old, new in _OTHERS[:-1]),
    *((f"^(?:build|make|form) ({new}) (?:out of|from) (?:the )?({old})$", "start : {2} . goal : {1}")
      for old, new in _OTHERS[:-1]),
    *((f"^(?:out of|from) (?:the )?({old})(?: ,)? (?:build|make|form) ({new})$", _TOLD) for old, new in _OTHERS[:-1]),
)  # fmt: skip
"""What is read otherwise as it stands."""
