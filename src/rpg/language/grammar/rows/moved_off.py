"""Blocks that lie somewhere and of which some, or all, are moved elsewhere: "move two of the three blocks on the "
"red mat
to the blue one", "off the red mat and onto the blue one", as rows that tell apart where they are and where they go."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import BLOCK
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST, PATCH

_MOVE = "(?:please )?(?:move|bring|take|carry|transfer|shift|relocate|get|push|put)"
_SO_MANY = f"(?:exactly |just |only |at least |at most |no more than |no fewer than )?(?:{MANY}|half)"
_SOME = f"(?:{_SO_MANY} of|all but {MANY} of|all of|both of|each of|any {MANY} of)"
_BLOCKS = f"(?:(?:the |those )(?:{MANY} )?(?:{COLOR} )?(?:{BLOCK}s|bricks|boxes))"
_ALL = f"((?:all|both)(?: the)?(?: {MANY})?(?: {COLOR})? (?:{BLOCK}s|bricks|boxes)|{_BLOCKS})"
_LYING = (
    "(?: (?:(?:that|which) (?:now |currently )?(?:are|lie|sit|stand)|lying|sitting|standing|resting|currently|now))*"
)
_TABLE = "(?: of the table)?"
_HALF = f"the (?:left|right|near|far|front|back|upper|lower|top|bottom) (?:half|side){_TABLE}"
_HERE = f"((?:on|in) (?:the (?:{COLOR} |left |right )?{PATCH}|{_HALF}))"
_FROM = f"(?:(?:away )?from|off(?: of)?) (the (?:{COLOR} |left |right )?{PATCH})"
_TO = (
    f"(?:over |across )?((?:to|onto|into|in|on) (?:the|an?) (?:(?:{COLOR}|left|right|near|far|front|back|other) "
    f"){{0,2}}(?:{PATCH}|half|side|corner|edge|middle|center|one){_TABLE})"
)
_END = "(?=$| ,| (?:at|in) the end| and (?:leave|keep|do not) | without )"

OFF_ONTO: tuple[Turn, ...] = (
    (f"^(?=.*? off(?: of)? the {COLOR} {PATCH}(?: ,)?(?: and)? (?:over )?(?:onto|on|to|into) the (?P<hue>{COLOR}) "
     f"one\\b)"
     f"(?!.*\\b(?P=hue) (?!one\\b|{PATCH}\\b))(.*?) off(?: of)? (the {COLOR} ({PATCH}))(?: ,)?(?: and)? ((?:over )?"
     f"(?:onto|on|to|into) the {COLOR}) one\\b", "{2} from {3} {5} {4}"),
)  # fmt: skip
"""Over a whole text: "onto the blue one" is onto the blue mat where nothing else is called blue."""
MOVED_OFF_AT_ONCE: tuple[Turn, ...] = (
    (f"^{_MOVE} ({_SOME}) ({_BLOCKS}){_LYING} {_HERE} {_TO}{_END}",
     "at the start , {2} are {3} . {1} {2} must be moved {4}"),
    (f"^{_MOVE} ({_SOME}) ({_BLOCKS}) {_FROM} {_TO}{_END}",
     "at the start , {2} are on {3} . {1} {2} must be moved {4}"),
    (f"^{_MOVE} {_ALL}{_LYING} {_HERE} {_TO}{_END}", "at the start , {1} are {2} . {1} must be moved {3}"),
    (f"^({_SOME}) ({_BLOCKS}){_LYING} {_HERE} {MUST} (?:go|be (?:moved|brought|taken|put)|move|end up|be) {_TO}{_END}",
     "at the start , {2} are {3} . {1} {2} must be moved {4}"),
)  # fmt: skip
"""What is looked for in every sentence, and what is said instead."""
