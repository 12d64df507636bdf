"""Goal atoms about where blocks are relative to each other, to patches, to the table, and how they are turned.

Distances in metres, angles in degrees; fields that end in `_edges` are multiples of the larger edge of the blocks
compared. Directions are the viewer's: left +y, right -y, front -x (nearer), back +x (farther).
"""

from __future__ import annotations

from typing import Literal

from rpg.ir.assets import Face
from rpg.ir.base import Names
from rpg.ir.node import Cosine, Direction, Edges, Length, Metres, Node, Operand, Tilt, Turn

Region = Literal[
    "left_half", "right_half", "near_half", "far_half", "middle", "corner", "edge",
    "near_left_corner", "near_right_corner", "far_left_corner", "far_right_corner",
    "left_edge", "right_edge", "near_edge", "far_edge",
]  # fmt: skip


class On(Node):
    """`a` rests directly on `b`."""

    kind: Literal["on"] = "on"
    a: Operand
    b: Operand
    gap: Metres = 0.01
    offset_edges: Edges = 0.5
    slack: Metres = 0.002
    tilt: Tilt = 15.0


class Above(Node):
    """`a` is somewhere above `b` in the same stack."""

    kind: Literal["above"] = "above"
    a: Operand
    b: Operand


class OnTable(Node):
    """Each of `a` rests on the table."""

    kind: Literal["on_table"] = "on_table"
    a: Operand
    gap: Metres = 0.01


class Clear(Node):
    """Nothing rests on any of `a`."""

    kind: Literal["clear"] = "clear"
    a: Operand


class OnPatch(Node):
    """Each of `a` has its centre inside the outline of `patch`, on the table or on blocks that are."""

    kind: Literal["on_patch"] = "on_patch"
    a: Operand
    patch: str


class Empty(Node):
    """No block's footprint overlaps `patch`."""

    kind: Literal["empty"] = "empty"
    patch: str


class Directional(Node):
    """All of `a` lie on one side of all of `b`.

    The offset along the axis is at least `min_edges`, and for single blocks not smaller than the offset across it
    unless `somewhere`. `directly`: across it at most half an edge. `immediate`: also a gap of at most half an edge.
    Groups (more than one name) are compared along the axis alone; `directly` relative to a group, each block of the
    smaller one is at most half an edge past the ends of the larger one.
    """

    a: Operand
    b: Operand
    somewhere: bool = False
    directly: bool = False
    immediate: bool = False
    min_edges: Edges = 1.0
    across_edges: Edges = 0.5
    gap_edges: Edges = 0.5


class LeftOf(Directional):
    kind: Literal["left_of"] = "left_of"


class RightOf(Directional):
    kind: Literal["right_of"] = "right_of"


class InFrontOf(Directional):
    kind: Literal["in_front_of"] = "in_front_of"


class Behind(Directional):
    kind: Literal["behind"] = "behind"


class Beside(Node):
    """Both level, the gap between the two footprints at most `gap_edges`; for groups, between their nearest members."""

    kind: Literal["beside"] = "beside"
    a: Operand
    b: Operand
    gap_edges: Edges = 1.0


class Adjacent(Node):
    """Both level, the gap between the two footprints at most `gap_edges`."""

    kind: Literal["adjacent"] = "adjacent"
    a: Operand
    b: Operand
    gap_edges: Edges = 0.5


class Touching(Node):
    """The gap between the two bodies is at most `gap`, at any height."""

    kind: Literal["touching"] = "touching"
    a: Operand
    b: Operand
    gap: Metres = 0.002


class Near(Node):
    """Centres at most `distance` apart in the plane; for groups, the nearest members."""

    kind: Literal["near"] = "near"
    a: Operand
    b: Operand
    distance: Length = 0.10


class Apart(Node):
    """Centres at least `distance` apart in the plane; for groups, the nearest members."""

    kind: Literal["apart"] = "apart"
    a: Operand
    b: Operand
    distance: Length = 0.10


class Distance(Node):
    """The distance between `a` and `b` in the plane, between centres or faces, lies in [minimum, maximum]."""

    kind: Literal["distance"] = "distance"
    a: Operand
    b: Operand
    minimum: Length | None = None
    maximum: Length | None = None
    measure: Literal["centres", "faces"] = "centres"


class Between(Node):
    """`a` has its foot on the segment from `b` to `c`, inside its ends and within `within_edges` of the line.

    Where the three stand in one tower, `a` is between the other two in height.
    """

    kind: Literal["between"] = "between"
    a: Operand
    b: Operand
    c: Operand
    within_edges: Edges = 1.0


class Closer(Node):
    """Each of `a` is closer to each of `b` than to any of `c`: in the plane, between centres, by at least `by`."""

    kind: Literal["closer"] = "closer"
    a: Operand
    b: Operand
    c: Operand
    by: Metres = 0.01


class Equidistant(Node):
    """Each of `a` is at the same distance from all of `b` and `c`.

    Between centres in the plane, these differ by at most `tolerance`.
    """

    kind: Literal["equidistant"] = "equidistant"
    a: Operand
    b: Operand
    c: Operand
    tolerance: Metres = 0.01


class InRegion(Node):
    """Each of `a` has its centre in a region of the table, as the viewer names it."""

    kind: Literal["in_region"] = "in_region"
    a: Operand
    region: Region


class Facing(Node):
    """A face of `block` (or every face that shows `label`: any of them will do) points `toward` a direction.

    The glyph on it is turned by `turn` degrees from upright, counter-clockwise as seen by its reader (180: upside
    down); None asks for no turn in the plane. `viewer` is whichever of up and towards the viewer shows the face.
    """

    kind: Literal["facing"] = "facing"
    block: str
    face: Face | None = None
    label: str | None = None
    toward: Literal["up", "down", "left", "right", "front", "back", "viewer"] = "up"
    turn: Turn | None = None
    normal_cos: Cosine = 0.97
    upright_cos: Cosine = 0.94


class Stayed(Node):
    """Each of `a` is within `tolerance` of where the episode found it."""

    kind: Literal["stayed"] = "stayed"
    a: Operand
    tolerance: Metres = 0.02


class Moved(Node):
    """Each of `a` is at least `at_least` from where the episode found it."""

    kind: Literal["moved"] = "moved"
    a: Operand
    at_least: Length = 0.05


class Shifted(Node):
    """Each of `a` is on one side of where the episode found it, by at least `at_least` and at most `at_most`.

    It is off the axis by at most `across`; where that is left out, by no more than it went along it.
    """

    kind: Literal["shifted"] = "shifted"
    a: Operand
    toward: Direction
    at_least: Length = 0.05
    at_most: Length | None = None
    across: Length | None = None


class Ranged(Node):
    """The distance of each of `a` from each of `b` is another than at the start, by at least `at_least`.

    Between centres in the plane, and by at most `at_most`, where that is said. Where `a` and `b` are the same blocks,
    this is so of every two of them.
    """

    a: Operand
    b: Operand
    at_least: Length = 0.02
    at_most: Length | None = None


class Approached(Ranged):
    """Each of `a` is closer to each of `b` than at the start: in the plane, between centres, by at least `at_least`.

    Where `a` and `b` are the same blocks, every two of them are.
    """

    kind: Literal["approached"] = "approached"


class Receded(Ranged):
    """Each of `a` is farther from each of `b` than at the start: in the plane, between centres, by at least `at_least`.

    Where `a` and `b` are the same blocks, every two of them are.
    """

    kind: Literal["receded"] = "receded"


class Swapped(Node):
    """`a` and `b` each stand within `tolerance` of where the other started."""

    kind: Literal["swapped"] = "swapped"
    a: Names
    b: Names
    tolerance: Metres = 0.03


class TookPlace(Node):
    """`a` stand within `tolerance` of where `b` started, one for one."""

    kind: Literal["took_place"] = "took_place"
    a: Names
    b: Names
    tolerance: Metres = 0.03


class Turned(Node):
    """`block` has turned about the vertical by `degrees` since the start (counter-clockwise from above is positive)."""

    kind: Literal["turned"] = "turned"
    block: str
    degrees: Turn
    either_way: bool = False
    tolerance: Tilt = 15.0
