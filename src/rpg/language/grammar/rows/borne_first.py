"""What a block bears, told before what is said of the block, "the green one with a blue one on top is ...", patches
with their colours behind them, and postures in one word, as rows that say it plainly."""

from __future__ import annotations

from rpg.language.grammar.rows.said_short import BLOCK, IS, THING
from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import COLOR, FEW, MUST, PATCH

_BEARING = "(?:carrying|bearing|supporting|holding|topped by|topped with)"
_WITH = "(?:with|having|(?:that|which) has)"
_ON_IT = "(?:on it|on top|on top of it)"
_THEN = f"((?:{IS}|{MUST}) .+)"
BORNE_FIRST: tuple[Turn, ...] = (
    (f"^({THING}) {_WITH} ({THING}) {_ON_IT} {_THEN}$", "{1} , with {2} on top , {3}"),
    (f"^({THING}) ((?:that|which) (?:carries|bears|supports|holds)|{_BEARING}) ({THING}) {_THEN}$",
     "{1} , carrying {3} , {4}"),
    (f"^with ({THING}) {_ON_IT}(?: ,)? ({THING}) {_THEN}$", "{2} , with {1} on top , {3}"),
    (f"\\bthe (?:(?:{FEW}) )?({PATCH}s|patches) ({COLOR}(?: , {COLOR})*(?: ,)? and {COLOR})(?! (?:{BLOCK}s?|ones?)\\b)",
     "the {2} {1}"),
    (f"\\b(the|an?) ({PATCH}) ({COLOR})(?= [,.]| and |$)", "{1} {3} {2}"),
    # what it bears at the end as well
    (f"(?: ,)? (?:with |while )?({THING})(?: (?:is|{MUST} be|stays?|remains?))? still (?:on top(?: of it)?|on it)$",
     "with {1} on it"),
    # any posture, where only another is known in that place
    ("\\b(?:sits|rests|lies)\\b", "stands"), ("(?<!the )\\b(?:sit|rest|lie)\\b(?!$)", "stand"),
)  # fmt: skip
"""What is looked for, and what is said instead; the last of all rows."""
