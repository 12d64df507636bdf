"""Lines as they are noted down: "start: tower, red bottom, blue top. goal: same tower reversed", "three stacked blocks
(white at the bottom)", as rows with the words that are left out."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.grammar.rows.vocabulary import AND, COLOR, CUBE, MANY, PATCH

_HEAD = "((?:at the |in the )?(?:start|begin|beginning|given|goal|end|finish|initially|finally|currently|now|then))"
_LINE = "(tower|row|column|pyramid|(?:stack|line|pile)(?= (?:of|with|from|,|:|\\()|$))"
_ONE = f"(?:the )?(?:{COLOR}(?: {CUBE}| one)?|\\w)"
_SIDE = "(?:on (?:the )?top|at the (?:top|bottom)|in the middle|lowest|highest|(?:on|at) the (?:left|right)(?: end)?)"
_ENDS = f"{_ONE} (?:is )?{_SIDE}(?:{AND} {_ONE} (?:is )?{_SIDE})*"
_CUBES = f"((?:{COLOR} )?{CUBE}s)"
_NOT_THEN = "(?! (?:to|at the|at|initially|originally|now|currently|,|:|in the beginning))"
"""When they are so, or what they are, is told of the blocks."""
_BARE = f"((?:the )?{COLOR}(?: {CUBE}| one)?|[a-z0-9])"
_THEN = "(?: ,| , and)"
"""Without a comma, "green and blue on top", both may be there."""


def _between(one: str, other: str) -> tuple[Turn, ...]:
    """ "Red at the bottom, green, blue on top": what is said of no end lies between."""
    lower, upper = f"({_ONE} {one})", f"({_ONE} {other})"
    return (
        (f"{lower}{_THEN} {_BARE}{_THEN} {upper}", "{1} , then {2} , {3}"),
        (f"{lower}{_THEN} {_BARE}{_THEN} {_BARE}{_THEN} {upper}", "{1} , then {2} , then {3} , {4}"),
    )


_BOTTOM, _TOP = "(?:at the bottom|lowest)", "(?:(?:on|at) (?:the )?top|highest)"
NOTED_DOWN: tuple[Turn, ...] = (
    (f"^{_HEAD} : {_LINE}\\b", "{1} : a {2}"),
    (f"^{_HEAD} : ((?:{COLOR} )?{PATCH}) (empty|clear|free)(?= ,|$)", "{1} : the {2} is {3}"),
    ("(?:^|(?<=: )|(?<=, ))same (tower|stack|row|line|column|pile|order|blocks|cubes)\\b", "the same {1}"),
    (f"(?<=[,:(] )({COLOR}) \\( (?:at the )?(top|bottom) \\)", "{1} at the {2}"),
    (f"\\b(tower|stack|row)(?: of| with| from)?(?: :)? ({COLOR}) \\( (?:at the )?(top|bottom) \\)",
     "{1} : {2} at the {3}"),
    (f"\\b((?:tower|stack|row|column|line|{CUBE}s)\\b[^().]*?)(?: ,)? \\( (?:with )?({_ENDS}) \\)", "{1} with {2}"),
    *_between(_BOTTOM, _TOP),
    *_between(_TOP, _BOTTOM),
    *_between("(?:on|at) the left(?: end)?", "(?:on|at) the right(?: end)?"),
    (f"\\bthe ({MANY}) stacked {_CUBES}{_NOT_THEN}", "the stack of {1} {2}"),
    (f"(?<!the )(?<!of )(?<!, )\\b({MANY}) stacked {_CUBES}{_NOT_THEN}", "a stack of {1} {2}"),
    (f"^there (?:is|are) ({MANY}) {_CUBES} stacked(?: up)?(?: on the table| on top of each other)*(?=$| ,)",
     "there is a stack of {1} {2}"),
)  # fmt: skip
"""In every sentence: what is looked for, and what is said instead."""
