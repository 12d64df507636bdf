"""Properties that are told one by one as on a data sheet: "the number of towers shall be three", "number of blocks:
four", "the order, from front to back, shall be: 1, 2, 3", as rows that say it of the blocks."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import PLACE, THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import MANY, MUST, WAY

_IS = f"(?:is|{MUST} be|equals|amounts to|:|=)"

DATA_SHEETS: tuple[Turn, ...] = (
    (f"^(?:the )?(?:total )?number of (blocks|cubes) {_IS} (?:exactly )?({MANY})$", "there are {2} {1}"),
    (f"^(?:the )?(?:total )?number of (towers|stacks|rows) {_IS} (?:exactly )?({MANY})$", "build {2} {1}"),
    (f"\\b({MUST}) have (?:a|the) height of (?:exactly )?({MANY}) (blocks|cubes)\\b", "{1} be {2} {3} high"),
    (f"\\bhas (?:a|the) height of (?:exactly )?({MANY}) (blocks|cubes)\\b", "is {1} {2} high"),
    (f"^(?:the|their) (?:order|sequence)(?: ,)? ({WAY})(?: ,)? {_IS}(?: :)? (.+)$", "{1} : {2}"),
    (f"^the (?:placement|position|location|place) of ({THING}) "
     f"((?:is|{MUST} be) (?:directly |immediately )?{PLACE} .+)$", "{1} {2}"),
    ("\\b(?:so|such) that(?: ,)? read (from \\w+ to \\w+)(?: ,)? they (?:yield|give|produce|result in|form|make) the "
     "(?:word|name) (\\S+)", "so that they spell {2} {1}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""
WORDS = ("yield total equals",)
"""Words that these take besides those that are read anyway."""
