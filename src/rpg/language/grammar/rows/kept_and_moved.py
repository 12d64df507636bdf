"""What may move and what is to stay, what is so already, and what was so before it fell: as rows that say it as
commands and starts do."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE, THING, THINGS
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST

_MAY = f"(?:{MUST}|may|can)"
_OTHERS = f"the (?:rest|others|other {MANY}(?: blocks| cubes| ones)?|remaining (?:blocks|cubes|ones|{MANY}))"
_LIES = "(?:is|are|lies|lie|stands|stand|sits|sit|rests|rest)"
_FIGURE = "tower|stack|row|line|column|pyramid|wall|pile|circle|ring|square|grid|staircase"
_ONE = "(?:(?!and\\b)[^ .,]+ ?)+?(?<! )"
"""One place, and not what is told of further blocks: "on the mat and green on blue" are two."""
_PUT = "(?:put|place|stack|move|bring|set|lay)"
_CAN = "(?:may|can|must|should)"
_BUT = "(?:except|but|other than|apart from)"
_ONLY_MOVED = (
    f"(?:nothing|no block|no other block) (?:{_CAN} be moved|{_CAN} move) {_BUT} ({THING})",
    f"nothing {_BUT} ({THING}) (?:{_CAN} be moved|{_CAN} move)",
    f"only ({THING}) (?:{_CAN} be moved|{_CAN} move)",
    f"(?:you|we|the robot) (?:{_CAN} only move|{_CAN} move only|(?:is|are) only allowed to move) ({THING})",
)
"""What alone may be moved."""
_FELL = ("(?:has|have) (?:fallen (?:over|down|apart|off)|fallen|collapsed|toppled(?: over)?|tumbled(?: down)?|crashed|"
         "been knocked (?:over|down)|tipped over)")  # fmt: skip
_AGAIN = "(?:again|up again|back up|back together|once more)"

KEPT_AT_ONCE: tuple[Turn, ...] = (
    (f"^(?:and |but )?only ({COLOR}) (?:may|can|is allowed to) (?:be )?(?:moved|move|touched)$",
     "nothing but the {1} block may be moved"),
    (f"^(?:and |but )?only ({THING}) (?:may|can|is allowed to) (?:be )?(?:moved|move|touched|change places?)$",
     "nothing but {1} may be moved"),
    ("^(?:you|we|the robot) (?:(?:may|can|must) (?:only (?:move|touch)|(?:move|touch) only)|(?:is|are) only allowed "
     f"to (?:move|touch)) ({THING})$", "nothing but {1} may be moved"),
    (f"^(?:(?:please|can|could|you) )*move ({THING})(?: ,)? but not ({THING})$",
     "{1} must be moved . {2} must stay where it is"),
    (f"^({_PUT} {THING}) (on|in|to|onto|into) (the [^,]+?)(?: ,)? and (?:no other blocks?|no others?|nothing else)(?: "
     "may be| is)? "
     "there$", "{1} {2} {3} . no other block may be {2} {3}"),
    (f"^((?:put|place|set|lay|move|bring) {THING}) there (?:too|as well|also)$", "{1} there . both must be there"),
)  # fmt: skip
KEPT_AND_MOVED: tuple[Turn, ...] = (
    (f"\\b({MUST}) (?:stay|remain|be kept|be left) not (moved|touched|shifted|displaced)\\b", "{1} not be {2}"),
    ("\\b(?:stays?|remains?|is left|is kept) not (moved|touched|shifted|displaced)\\b", "must not be {1}"),
    # who may move
    (f"^({THINGS}) ({_MAY}) (be (?:moved|turned|rotated|flipped|touched)|move)(?: ,| and| but| , and| , but)+ "
     f"({THINGS}) {_MAY} not(?: be)?$", "{1} {2} {3} . {4} must not {3}"),
    (f"^(.+?)(?: ,)? (?:and|but|while) (?:leave|leaving|keep|keeping) ({_OTHERS}) (?:standing|untouched|in place|alone|"
     "as it is|as they are|there|stacked|unchanged)$", "{1} . {2} must stay where they are"),
    # what is so already
    (f"^({THINGS}) ({_LIES}) ({PLACE} [^,]+?) already$", "{1} {2} already {3}"),
    (f"^({THINGS}) ({_LIES}) (stacked|in a row|lined up|in a line) already$", "at the start {1} {2} {3}"),
)  # fmt: skip
"""What makes no sense as it stands, in words that do."""

FALLEN: tuple[Turn, ...] = (
    # What else there is, is told behind it.
    *(row for only in _ONLY_MOVED for row in (
        (f"^{only} \\. ({_PUT}) it ([^.]+)(?= \\.|$)", "{2} {1} {3} . nothing but {1} may be moved"),
        (f"^{only} \\. ((?:{_PUT} )?\\1 [^.]+)(?= \\.|$)", "{2} . nothing but {1} may be moved"),
    )),
    # Of a text that tells what there is; otherwise there are others, and how many is assumed.
    (f"(?<= \\. )({_PUT}) (the [^.,]+?|{THING}) ({PLACE} {_ONE})(?: ,)?(?: \\. | (?:and|but) )(?:move|touch) nothing "
     "else(?= \\.|$)", "{1} {2} {3} . nothing but {2} may be moved"),
    (f"(?<= \\. )({_PUT}) (the [^.,]+?|{THING}) ({PLACE} {_ONE})(?: ,)? without (?:moving|touching) anything else"
     "(?= \\.|$)", "{1} {2} {3} . nothing but {2} may be moved"),
    (f"^there are ({MANY} (?:letter|digit|number) (?:cubes|blocks) [^.]+?) on the table(?= \\.)", "there are {1}"),
    (f"^(?:the|a|my|our) ((?:{_FIGURE}) (?:of|with) [^.]+?) {_FELL} \\. (?:please )?(?:build|put|set|stack|make|"
     f"restore|rebuild) (?:it|the (?:{_FIGURE}))(?: {_AGAIN})?(?= \\.|$)", "build a {1}"),
    (f"^({THING}) (?:has fallen|fell|has come|has slipped|slipped) off ({THING}) \\. (?:please )?(?:put|place|set|lay) "
     "it back(?: on(?: it| top(?: of it)?)?| up| again| there)*(?= \\.|$)", "at the start {1} is on the table . put "
     "{1} on {2}"),
    (f"^(?:get|take|pull|bring) ({THING}) (?:out )?(?:from )?(?:under|beneath|underneath|below) ({THING})(?: ,| ;| "
     f"\\.)? (?:and |then )*(?:put|lay|place|set|stack) it (?:on top of|on|onto) it(?= \\.|$)",
     "at the start {2} is on {1} . put {1} on {2}"),
)  # fmt: skip
"""Over the whole text: what lies about is built as it was."""
WORDS = ("fallen fell collapsed toppled tumbled crashed knocked tipped slipped",)
"""Words that these take besides those that are read anyway."""
