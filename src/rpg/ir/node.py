"""What every goal node shares: its place in the instruction, and operands that name blocks or a tower's foot."""

from __future__ import annotations

from typing import Annotated, Any, Literal, get_args

from pydantic import Field

from rpg.ir.base import Names, Record

Length = Annotated[float, Field(ge=0.0)]
"""A distance that is asked for, in metres; whether there is room for it is a question of feasibility."""
Metres = Annotated[float, Field(ge=0.0, le=1.0)]
"""A tolerance in metres."""
Edges = Annotated[float, Field(ge=0.0, le=10.0)]
"""A tolerance as a multiple of a block's edge."""
Tilt = Annotated[float, Field(ge=0.0, le=90.0)]
"""A tolerance of an angle in degrees."""
Cosine = Annotated[float, Field(ge=0.0, le=1.0)]
"""The least cosine of an angle that still counts."""
Turn = Annotated[float, Field(ge=-360.0, le=360.0)]
"""A turn in degrees, counter-clockwise positive."""


class Node(Record):
    """A node of a goal expression. `span` is its half-open character range in the instruction."""

    span: tuple[int, int] | None = None


class Lowest(Record):
    """Whichever of these blocks is the lowest: a relation to a tower is a relation to its lowest block."""

    lowest: Names


class Highest(Record):
    """Whichever of these blocks is the highest: what is put "on the tower" goes on its top block."""

    highest: Names


Operand = Names | Lowest | Highest
"""One block or patch, a group of blocks, or the foot or the top of a tower."""


def members(operand: Any) -> tuple[str, ...]:
    """The names an operand mentions."""
    if isinstance(operand, Lowest):
        return operand.lowest
    if isinstance(operand, Highest):
        return operand.highest
    return (operand,) if isinstance(operand, str) else tuple(operand)


Direction = Literal["left", "right", "front", "back"]
Axis = Literal["x", "y"]
Slope = Literal["rising", "falling", "diagonal"]
"""The diagonals of the table as the viewer sees it: from the near left to the far right, from the far left to the near
right, or either of them."""
SLOPES = get_args(Slope)
EACH = "each"
"""The name that stands for the counted block inside `Count`."""
