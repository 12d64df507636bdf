"""What a length is said to be of: "8 cm of empty table (between the groups)", "2 cm free (between the faces)"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.slots import Patterns

_FREE = Patterns(
    "of? free|empty|clear|open|bare|blank? space|room|table|air|tabletop|surface",
    "of? free|empty|clear|open|bare table space|top|surface",
    "of space|room|table|tabletop|surface free|empty|clear|open|bare",
    "free|empty|clear|open",
)


def behind_room(p: Parser, j: int) -> int:
    """The position after what a length that ends at j is of; j where nothing is said of it."""
    return max(_FREE.matches(p, j), default=j)
