"""Clauses for relations: where blocks are with respect to each other, to patches and to the table."""

from __future__ import annotations

from typing import Any

from rpg.blocks.english.measures import cm, span
from rpg.blocks.english.speaker import Speaker
from rpg.ir import relations as r
from rpg.ir.node import Highest, Lowest, Operand, members

DIRECTIONS = {
    "left_of": "to the left of",
    "right_of": "to the right of",
    "in_front_of": "in front of",
    "behind": "behind",
}

REGIONS: dict[r.Region, str] = {
    "left_half": "in the left half of the table",
    "right_half": "in the right half of the table",
    "near_half": "in the near half of the table",
    "far_half": "in the far half of the table",
    "middle": "in the middle of the table",
    "corner": "in a corner of the table",
    "edge": "at the edge of the table",
    "near_left_corner": "in the near left corner of the table",
    "near_right_corner": "in the near right corner of the table",
    "far_left_corner": "in the far left corner of the table",
    "far_right_corner": "in the far right corner of the table",
    "left_edge": "at the left edge of the table",
    "right_edge": "at the right edge of the table",
    "near_edge": "at the near edge of the table",
    "far_edge": "at the far edge of the table",
}


def on(node: r.On, say: Speaker) -> str:
    return f"{say.the(node.a)} {say.be(node.a)} on {say.the(node.b)}"


def above(node: r.Above, say: Speaker) -> str:
    return f"{say.the(node.a)} {say.be(node.a)} somewhere above {say.the(node.b)}"


def on_table(node: r.OnTable, say: Speaker) -> str:
    return f"{say.the(node.a)} {say.be(node.a)} on the table"


def clear(node: r.Clear, say: Speaker) -> str:
    with say.strictly():
        return _covered(node, say)


def _covered(node: r.Clear, say: Speaker) -> str:
    if not say.negated:
        return f"nothing {say.be('nothing')} on {say.the(node.a)}"
    say.negated = False
    text = " or ".join(_carries(name, say) for name in members(node.a))
    say.negated = True
    return text


def _carries(name: str, say: Speaker) -> str:
    """Something on a block: one of all the other blocks."""
    others = tuple(other for other in say.world.blocks if other != name)
    some = say.the(others) if len(others) == 1 else f"at least one of {say.the(others)}"
    return f"{some} {say.be('one')} on {say.the(name)}"


def on_patch(node: r.OnPatch, say: Speaker) -> str:
    return f"{say.the(node.a)} {say.be(node.a)} on {say.the(node.patch)}"


def empty(node: r.Empty, say: Speaker) -> str:
    return f"{say.the(node.patch)} {say.be(node.patch)} empty"


def directional(node: r.Directional, say: Speaker) -> str:
    adverb = "immediately " if node.immediate else "directly " if node.directly else ""
    adverb = "somewhere " if node.somewhere else adverb
    return f"{say.the(node.a)} {say.be(node.a)} {adverb}{DIRECTIONS[node.kind]} {say.the(node.b)}"  # type: ignore[attr-defined]


def beside(node: r.Beside, say: Speaker) -> str:
    return _mutual(node, say, "next to")


def adjacent(node: r.Adjacent, say: Speaker) -> str:
    return _mutual(node, say, "adjacent to")


def touching(node: r.Touching, say: Speaker) -> str:
    if (both := _look_alikes(node.a, node.b, say)) is not None:
        return f"{say.the(both)} {say.do(both, 'touch', 'touches')} each other"
    return f"{say.the(node.a)} {say.do(node.a, 'touch', 'touches')} {say.the(node.b)}"


def near(node: r.Near, say: Speaker) -> str:
    if node.distance != 0.10:
        return _far(node, say, f"at most {cm(node.distance)}")
    return _mutual(node, say, "near")


def apart(node: r.Apart, say: Speaker) -> str:
    if node.distance != 0.10:
        return _far(node, say, f"at least {cm(node.distance)}")
    if (both := _look_alikes(node.a, node.b, say)) is not None:
        return f"{say.the(both)} {say.be(both)} apart from each other"
    return f"{say.the(node.a)} {say.be(node.a)} apart from {say.the(node.b)}"


def distance(node: r.Distance, say: Speaker) -> str:
    length = span(node.minimum, node.maximum)
    if node.measure == "faces":
        both = _look_alikes(node.a, node.b, say)
        ends = say.the(both) if both is not None else f"{say.the(node.a)} and {say.the(node.b)}"
        return f"there {say.be('gap')} a gap of {length} between {ends}"
    return _far(node, say, length)


def _far(node: r.Near | r.Apart | r.Distance, say: Speaker, length: str) -> str:
    if (both := _look_alikes(node.a, node.b, say)) is not None:
        return f"{say.the(both)} {say.be(both)} {length} apart"
    return f"{say.the(node.a)} {say.be(node.a)} {length} from {say.the(node.b)}"


def _mutual(node: r.Beside | r.Adjacent | r.Near, say: Speaker, how: str) -> str:
    if (both := _look_alikes(node.a, node.b, say)) is not None:
        return f"{say.the(both)} {say.be(both)} {how} each other"
    return f"{say.the(node.a)} {say.be(node.a)} {how} {say.the(node.b)}"


def _look_alikes(a: Operand, b: Operand, say: Speaker) -> tuple[str, ...] | None:
    """Two single blocks as one pair, where they look alike and need no numbers."""
    both = (*members(a), *members(b))
    single = not isinstance(a, Lowest | Highest) and not isinstance(b, Lowest | Highest) and len(both) == 2
    return both if single and say.alike(both) else None


def between(node: r.Between, say: Speaker) -> str:
    subject = f"{say.the(node.a)} {say.be(node.a)}"
    if (both := _look_alikes(node.b, node.c, say)) is not None:
        return f"{subject} between {say.the(both)}"
    return f"{subject} between {say.the(node.b)} and {say.the(node.c)}"


def closer(node: r.Closer, say: Speaker) -> str:
    by = "" if node.by == 0.01 else f"at least {cm(node.by)} "
    if _marked(node.a, say):
        subject = f"{say.the(node.b)} {say.be(node.b)} {by}closer to {say.the(node.a)}"
        return f"{subject} than {_any_of(node.c, say)} is"
    subject = f"{say.the(node.a)} {say.be(node.a)} {by}closer to "
    one = say.the(node.b) if say.single(node.b) else f"each of {say.the(node.b)}"
    return f"{subject}{one} than to {_any_of(node.c, say)}"


def _any_of(operand: Operand, say: Speaker) -> str:
    return say.the(operand) if say.single(operand) else f"any of {say.the(operand)}"


def equidistant(node: r.Equidistant, say: Speaker) -> str:
    if _marked(node.a, say):
        be = say.be((*members(node.b), *members(node.c)))
        return f"{_ends(node, say)} {be} at the same distance from {say.the(node.a)}"
    each = "" if say.single(node.a) else " each"
    return f"{say.the(node.a)} {say.be(node.a)}{each} at the same distance from {_ends(node, say)}"


def _ends(node: r.Equidistant, say: Speaker) -> str:
    if isinstance(node.b, Lowest | Highest) or isinstance(node.c, Lowest | Highest):
        return f"{say.the(node.b)} and {say.the(node.c)}"
    return say.the((*node.b, *node.c))


def _marked(operand: Operand, say: Speaker) -> bool:
    """Whether this is one patch, of which nothing is said but with respect to blocks."""
    return len(members(operand)) == 1 and members(operand)[0] in say.world.patches


def in_region(node: r.InRegion, say: Speaker) -> str:
    return f"{say.the(node.a)} {say.be(node.a)} {REGIONS[node.region]}"


POINTING = {90.0: "to the left", -90.0: "to the right"}
"""Where the top of a symbol points that is turned a quarter turn."""


def facing(node: r.Facing, say: Speaker) -> str:
    block = say.the(node.block)
    turn = _turn(node.turn)
    if not node.face and node.toward == "up" and node.turn in (90.0, -90.0):
        return f"{block} {say.do(node.block, 'lie', 'lies')} with its top pointing {POINTING[node.turn]}"
    if turn and not node.face and node.toward in ("up", "viewer"):
        return f"{block} {say.be(node.block)} {turn}"
    face = f"the {node.face} face of {block}" if node.face else f"the {node.label} of {block}" if node.label else block
    way = {"viewer": "the viewer", "front": "the front", "back": "the back"}.get(node.toward, node.toward)
    return f"{face} {say.do(node.block, 'face', 'faces')} {way}{f', {turn}' if turn else ''}"


def _turn(degrees: float | None) -> str:
    """How a glyph is turned in the plane of its face."""
    if degrees is None:
        return ""
    known = {0: "upright", 180: "upside down", 90: "turned a quarter turn counterclockwise"}
    known[270] = "turned a quarter turn clockwise"
    return known.get(round(degrees) % 360, f"turned by {degrees:g} degrees")


def stayed(node: r.Stayed, say: Speaker) -> str:
    where = "it is" if say.single(node.a) else "they are"
    return f"{say.the(node.a)} {say.do(node.a, 'stay', 'stays')} where {where}"


def moved(node: r.Moved, say: Speaker) -> str:
    return f"{say.the(node.a)} {say.be(node.a)} moved by at least {cm(node.at_least)}"


WAYS = {
    "left": "to the left",
    "right": "to the right",
    "front": "toward the robot",
    "back": "away from the robot",
}
"""Which way something moves, seen from where it was."""


def shifted(node: r.Shifted, say: Speaker) -> str:
    return f"{say.the(node.a)} {say.be(node.a)} moved {span(node.at_least, node.at_most)} {WAYS[node.toward]}"


def approached(node: r.Approached, say: Speaker) -> str:
    return _ranged(node, say, "closer together", "closer to")


def receded(node: r.Receded, say: Speaker) -> str:
    return _ranged(node, say, "farther apart", "farther from")


def _ranged(node: r.Ranged, say: Speaker, mutual: str, how: str) -> str:
    far = span(node.at_least, node.at_most)
    together = node.a if node.a == node.b else _look_alikes(node.a, node.b, say)
    if together is not None:
        return f"{say.the(together)} {say.be(together)} moved {far} {mutual}"
    return f"{say.the(node.a)} {say.be(node.a)} moved {far} {how} {say.the(node.b)}"


def swapped(node: r.Swapped, say: Speaker) -> str:
    if say.negated:
        return f"{say.the(node.a)} {say.be(node.a)} swapped with {say.the(node.b)}"
    return f"{say.the(node.a)} and {say.the(node.b)} {say.do((*node.a, *node.b), 'swap', 'swaps')} places"


def took_place(node: r.TookPlace, say: Speaker) -> str:
    was = "were" if len(node.b) > 1 else "was"
    return f"{say.the(node.a)} {say.be(node.a)} where {say.the(node.b)} {was} at the start"


def turned(node: r.Turned, say: Speaker) -> str:
    if not node.degrees:
        say.negated = not say.negated
        be = say.be(node.block)
        say.negated = not say.negated
        return f"{say.the(node.block)} {be} turned"
    way = "" if node.either_way else " counterclockwise" if node.degrees > 0 else " clockwise"
    return f"{say.the(node.block)} {say.be(node.block)} turned by {abs(node.degrees):g} degrees{way}"


TABLE: dict[str, Any] = {
    "on": on,
    "above": above,
    "on_table": on_table,
    "clear": clear,
    "on_patch": on_patch,
    "empty": empty,
    "left_of": directional,
    "right_of": directional,
    "in_front_of": directional,
    "behind": directional,
    "beside": beside,
    "adjacent": adjacent,
    "touching": touching,
    "near": near,
    "apart": apart,
    "distance": distance,
    "between": between,
    "closer": closer,
    "equidistant": equidistant,
    "in_region": in_region,
    "facing": facing,
    "stayed": stayed,
    "moved": moved,
    "shifted": shifted,
    "approached": approached,
    "receded": receded,
    "swapped": swapped,
    "took_place": took_place,
    "turned": turned,
}
