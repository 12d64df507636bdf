"""What alone may be at a place: "only the green block may be on the patch, neither the red nor the blue one", "every
block on the mat must be yellow", as rows that say what must not be there; and a stock that is told as enough."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, MUST, PATCH

_HERE = f"((?:on|in) the (?:{COLOR} )?{PATCH})"
_BLOCKS = "(?:blocks?|cubes?|bricks?|ones?)"
_ALL = f"(?:every|each|all|all the) {_BLOCKS}(?: (?:that|which) (?:is|are|lies?))?"
_LOT = f"{MANY} {COLOR}(?: {_BLOCKS})?"
_ENOUGH = "(?:(?:are|is|will be|would be) (?:enough|sufficient|plenty)|will do|suffices?)"

BARRED_THERE_AT_ONCE: tuple[Turn, ...] = (
    (f"^(only {THING} (?:may|can) (?:be|lie|go|stand) {_HERE})(?: ,)? (?:and )?(?:neither|not) ({THING}) (?:nor|or|and "
     f"not) ({THING})$", "{1} . {3} and {4} must not be {2}"),
)  # fmt: skip
"""What is looked for in every sentence, and what is said instead."""
BARRED_THERE: tuple[Turn, ...] = (
    (f"^there (?:is|{MUST} be) at least one {_BLOCKS} {_HERE}(?: ,)? and {_ALL} (?:\\1|there) (?:is|are|{MUST} be) "
     f"({COLOR})$", "at least one {2} block must be {1} . only {2} blocks may be {1}"),
    (f"^{_ALL} {_HERE} {MUST} be ({COLOR})$", "only {2} blocks may be {1}"),
    # the stock behind it
    (f"^({MANY}) are ({COLOR})(?: ,| and| , and) ({MANY})(?: are)? ({COLOR})$", "there are {1} {2} and {3} {4} blocks"),
    (f"^({MANY})(?: {_BLOCKS})? of (?:each|every|both)(?: colors?)? {_ENOUGH}$", "there are {1} blocks of each color"),
    (f"^({_LOT}(?:(?: ,| and| , and) {_LOT})*) {_ENOUGH}$", "there are {1}"),
)  # fmt: skip
"""What makes no sense as it stands."""
WORDS = ("enough sufficient plenty suffice suffices",)
"""Words that these take besides those that are read anyway."""
