"""Blocks that lie somewhere and of which some, or all, are moved elsewhere: "move two of the three blocks on the red
mat to the blue one", "off the red mat and onto the blue one", as rows that tell apart where they are and where they
go; and of which some are just taken off: "three blocks are on the mat. Take all but one off"."""

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

_NO_TOWER = "(?!.*\\b(?:tower|stack|pile|heap|row|line)s?\\b)"
_THERE = f"^{_NO_TOWER}(.*\\b(?:on|in) (the (?:{COLOR} )?{PATCH}) [.;,])(?: (?:please|now|then|so))*"
_TAKE = "(?:take|get|move|remove|lift|pull|push|pick)"
_OFF = "(?:off|away|out)"
_OF_IT = f"(?: (?:of |from )?(?:it|there|the (?:{COLOR} )?{PATCH}))?"
_THEM_ALL = f"(?:all(?: of them)?|them all|everything|all the {BLOCK}s)"
_BUT_SO_MANY = f"(?:but|except|except for|save)(?: for)? ({MANY})(?: of them)?"
_CLOSED = "(?= [.!]|$)"
_REMOVE = "(?:remove|discard|get rid of|clear away)"
_REST = f"(?:all )?(?:of )?the (?:rest|others|other (?:ones|{BLOCK}s|{MANY})|remaining (?:ones|{BLOCK}s|{MANY}))"
_LEFT = f"(?:exactly |just |only )?({MANY})(?: of them| {BLOCK}s?)?(?: stay| remain)?"
_JUST = f"(?:exactly|just|only) ({MANY})(?: of them| {BLOCK}s?)?"
_ON_IT = f"(?: there| behind| (?:on|in) (?:it|the (?:{COLOR} )?{PATCH}))?"
_STAY = f"(?:stay|remain|be left|be kept){_ON_IT}"

OFF_ONTO: tuple[Turn, ...] = (
    (f"^(?=.*? off(?: of)? the {COLOR} {PATCH}(?: ,)?(?: and)? (?:over )?(?:onto|on|to|into) the (?P<hue>{COLOR}) "
     f"one\\b)"
     f"(?!.*\\b(?P=hue) (?!one\\b|{PATCH}\\b))(.*?) off(?: of)? (the {COLOR} ({PATCH}))(?: ,)?(?: and)? ((?:over )?"
     f"(?:onto|on|to|into) the {COLOR}) one\\b", "{2} from {3} {5} {4}"),
    # off the mat that was spoken of last
    (f"^(the (?:{COLOR} )?{PATCH}) (?:has|holds|carries|contains|bears) ([^.,]*? {BLOCK}s)(?: on (?:it|top))? \\. "
     f"(?=(?:{_TAKE}|leave|keep|only|discard|clear)\\b)", "{2} are on {1} . "),
    (f"{_THERE} {_TAKE} ({MANY})(?: of them| {BLOCK}s?)? {_OFF}{_OF_IT}{_CLOSED}",
     "{1} take {3} of them off {2}"),
    (f"{_THERE} (?:{_REMOVE}|{_TAKE} away) (?:exactly |just |only )?({MANY})(?: of them| {BLOCK}s?)?{_OF_IT}{_CLOSED}",
     "{1} take {3} of them off {2}"),
    *((f"{_THERE} {left}{_CLOSED}", "{1} exactly {3} of them must be on {2}")
      for left in (f"{_TAKE} {_THEM_ALL} {_BUT_SO_MANY} (?:{_OFF}|from){_OF_IT}",
                   f"{_TAKE} {_THEM_ALL} {_OFF}{_OF_IT}(?: ,)? {_BUT_SO_MANY}",
                   f"{_REMOVE} {_THEM_ALL} {_BUT_SO_MANY}{_OF_IT}",
                   f"(?:leave|keep) {_LEFT}{_ON_IT}(?: ,| and| , and| but) (?:(?:{_REMOVE}|{_TAKE} {_OFF}) {_REST}|"
                   f"{_TAKE} {_REST} {_OFF})"
                   f"{_OF_IT}",
                   f"{_JUST} {MUST} {_STAY}",
                   f"(?:leave|keep) {_JUST}{_ON_IT}",
                   f"only (?:leave|keep) ({MANY})(?: of them| {BLOCK}s?)?{_ON_IT}")),
    (f"{_THERE} {_JUST} (?:may|can|is allowed to|are allowed to) {_STAY}{_CLOSED}",
     "{1} at most {3} of them may be on {2}"),
    (f"{_THERE} {_TAKE} {_OFF} ((?:the|all the|both) [^.,]+?)(?= and leave| [.!]|$)", "{1} take {3} off {2}"),
    (f"(?<= off )(the (?:{COLOR} )?{PATCH})(?: ,)? and leave ((?:the|all the|both) [^.,]+?) "
     f"(?:inside|in it|in there|in){_CLOSED}", "{1} and leave {2} on {1}"),
)  # fmt: skip
"""Over a whole text: "onto the blue one" is onto the blue mat where nothing else is called blue."""
MOVED_OFF_AT_ONCE: tuple[Turn, ...] = (
    # what leaves a mat starts there
    (f"\\b(?:comes|goes|gets) off (the (?:{COLOR} )?{PATCH})\\b", "leaves {1}"),
    (f"^(.*\\b{PATCH}\\b.*) (?:comes|goes|gets) off(?: it)?(?= ,| and\\b|$)", "{1} leaves it"),
    (f"^{_MOVE} ({_SOME}) ({_BLOCKS}){_LYING} {_HERE} {_TO}{_END}",
     "at the start , {2} are {3} . {1} {2} must be moved {4}"),
    (f"^{_MOVE} ({_SOME}) ({_BLOCKS}) {_FROM} {_TO}{_END}",
     "at the start , {2} are on {3} . {1} {2} must be moved {4}"),
    (f"^{_MOVE} {_ALL}{_LYING} {_HERE} {_TO}{_END}", "at the start , {1} are {2} . {1} must be moved {3}"),
    (f"^({_SOME}) ({_BLOCKS}){_LYING} {_HERE} {MUST} (?:go|be (?:moved|brought|taken|put)|move|end up|be) {_TO}{_END}",
     "at the start , {2} are {3} . {1} {2} must be moved {4}"),
)  # fmt: skip
"""What is looked for in every sentence, and what is said instead."""
