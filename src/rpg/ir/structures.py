"""Goal atoms about what blocks form together: stacks, rows, figures, groups, words, equations."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from rpg.ir.base import Names
from rpg.ir.node import Axis, Direction, Edges, Length, Metres, Node, Slope, Tilt
from rpg.ir.order import Attribute, Order, Pattern

Members = Annotated[Names, Field(min_length=1)]
Count = Annotated[int, Field(ge=1)]
TOUCHING_EDGES = 0.05
"""The widest gaps, in edges, inside of a group whose blocks touch each other."""


class Stack(Node):
    """`blocks` form one stack, bottom to top when the order is given; `order.first` is "bottom" unless it says "top".

    `exact`: nothing else is in the stack (its top is clear and its foot on the table or the patch). `patch`: the
    lowest block lies on that patch. `readable`: the symbols on the viewer's side read upright, but for cubes that are
    `excused` because another condition turns them in the plane of their face. `raised`: another condition puts the
    stack on a block, so that its foot need not be on the table.
    """

    kind: Literal["stack"] = "stack"
    blocks: Members
    order: Order = Order()
    exact: bool = False
    patch: str | None = None
    readable: bool = False
    excused: Names = ()
    raised: bool = False


class Towers(Node):
    """`blocks` form towers and nothing else: stacks of two or more with clear tops that use every one of them.

    `count` towers; `heights` lists their heights in any order; `equal`: all of one height; `each`: every tower agrees
    in that attribute, and (`separate`) no two towers share its value. `matching`: every tower stands on a patch of its
    blocks' colour.
    """

    kind: Literal["towers"] = "towers"
    blocks: Members
    count: Count | None = None
    heights: tuple[Count, ...] | None = None
    equal: bool = False
    each: Attribute | None = None
    separate: bool = False
    matching: Names | None = None


class Row(Node):
    """`blocks` stand in one straight line.

    `axis` "y" lies from left to right, "x" from front to back (a column on the table), "rising" from the near left to
    the far right, "falling" from the far left to the near right, "diagonal" along either, at 45 degrees; within
    `angle` degrees of it. Gaps between neighbours' faces at most `gap_edges`, or `spacing` metres between centres, or
    `gap` metres between faces, each within `tolerance`. `evenly`: gaps within `even_edges` of each other. `readable`:
    symbols on top read upright for the viewer (but for those `excused`), and in the order's direction. `covered`:
    cubes that another condition puts a block on; the others that are read have nothing on them.
    """

    kind: Literal["row"] = "row"
    blocks: Members
    axis: Axis | Slope | None = None
    order: Order = Order()
    readable: bool = False
    excused: Names = ()
    covered: Names = ()
    touching: bool = False
    evenly: bool = False
    spacing: Length | None = None
    gap: Length | None = None
    tolerance: Metres = 0.01
    gap_edges: Edges = 1.5
    line_edges: Edges = 0.5
    even_edges: Edges = 0.5
    angle: Tilt = 15.0


class Cells(Node):
    """Blocks that fill the cells of an ideal figure, each within `fit_edges` of its cell.

    The figure is fitted by position, rotation and pitch (`pitch_edges`, between neighbours' centres); figures that
    name no direction hold in any rotation and mirroring. `gap`: metres between the faces of neighbours, within
    `tolerance`.
    """

    blocks: Members
    pattern: Pattern | None = None
    readable: bool = False
    excused: Names = ()
    covered: Names = ()
    fit_edges: Edges = 0.5
    pitch_edges: tuple[Edges, Edges] = (1.0, 2.0)
    gap: Length | None = None
    tolerance: Metres = 0.01


class Grid(Cells):
    """`rows` lie along y, one behind the other along x; `columns` per row; `layers` high. A wall has one row."""

    kind: Literal["grid"] = "grid"
    rows: Count
    columns: Count
    layers: Count = 1
    axis: Axis | None = None


class Pyramid(Cells):
    """Layers of n, n-1, ... 1 blocks in a line (`base` = [n, 1]), or n x m, (n-1) x (m-1), ... (`base` = [n, m])."""

    kind: Literal["pyramid"] = "pyramid"
    base: tuple[Count, Count]


class Staircase(Cells):
    """Columns of 1, 2, ... `steps` blocks side by side, going up towards `up` when it is given."""

    kind: Literal["staircase"] = "staircase"
    steps: Count
    up: Direction | None = None


class Figure(Cells):
    """An outline or filled figure, or a letter shape, of `blocks` flat on the table.

    `sides`: cells along x and y for square, rectangle and plus, the side for triangle, the arms (long, short) for
    L, T, V, U; None takes what fits the number of blocks. `pointing`: where the apex of a triangle or V, the foot of
    an L (its stem behind it), the open side of a U, or the stem of a T points.
    """

    kind: Literal["figure"] = "figure"
    shape: Literal["square", "rectangle", "triangle", "circle", "L", "T", "V", "U", "plus", "X"]
    filled: bool = False
    sides: tuple[Count, Count] | None = None
    pointing: Direction | None = None


class GroupBy(Node):
    """`groups` lie apart: members chained by face gaps of at most `inner_edges`, groups at least `outer_edges` apart.

    Groups are also farther apart than any gap inside one. `by` is the attribute that tells the groups apart, where
    one does. `outliers`: exactly so many members of each group differ in `by` from the rest of it; the groups are then
    any division of the blocks that fits.
    """

    kind: Literal["group_by"] = "group_by"
    groups: Annotated[tuple[Members, ...], Field(min_length=1)]
    by: Attribute | None = None
    outliers: Annotated[int, Field(ge=0)] = 0
    inner_edges: Edges = 2.0
    outer_edges: Edges = 1.5


class Spells(Node):
    """Cubes among `blocks` spell `word` from readable faces, and nothing else adjoins it.

    `along` "row": left to right on top faces; "stack": down a tower on the viewer's side, top first. `reverse` reads
    from the other end. `beside`: blocks that another condition puts beside these; they may adjoin a row, but no
    symbol may stand in its line.
    """

    kind: Literal["spells"] = "spells"
    blocks: Members
    word: Annotated[str, Field(min_length=1)]
    along: Literal["row", "stack"] = "row"
    reverse: bool = False
    readable: bool = True
    excused: Names = ()
    covered: Names = ()
    beside: Names = ()
    gap_edges: Edges = 1.5


class Equation(Node):
    """All of `blocks`, read in a row from left to right (or down a stack), form a true equation.

    `longer`: numbers of several digits are allowed. `text` fixes the equation; None accepts every true one.
    """

    kind: Literal["equation"] = "equation"
    blocks: Members
    along: Literal["row", "stack"] = "row"
    longer: bool = False
    text: str | None = None
    excused: Names = ()
    covered: Names = ()
    beside: Names = ()
    gap_edges: Edges = 1.5
