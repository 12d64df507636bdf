"""Places said outside their structure: "the red one at the bottom" after "build a tower of three blocks"."""

from __future__ import annotations

from collections.abc import Hashable
from typing import TYPE_CHECKING

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.language.later import later
from rpg.language.meaning import At, Meaning, replace
from rpg.passes.schema.resolve.orders.positions import looks
from rpg.passes.schema.resolve.things.world import Ref, Scene, which_one

if TYPE_CHECKING:
    from rpg.passes.schema.resolve.places.sides import place_loose
else:
    (place_loose,) = later(__name__, "rpg.passes.schema.resolve.places.sides", "place_loose")


def settle(goal: g.Goal, scene: Scene) -> g.Goal:
    """Work what `scene.loose` holds into the goal."""
    if not scene.loose and not scene.denied:
        return goal
    _at_their_times(scene)
    return place_loose(goal, scene)


def _at_their_times(scene: Scene) -> None:
    """Refuse "put red on blue, then move it to the left": of what, when it is on blue already?

    "On the left red, then green" is no order in time, and neither is what is told of a line.
    """
    lines = [set(b.members) for b in scene.built if b.kind in ("row", "line", "column", "word")]
    late = [span for ref, _, span in scene.untimed if not any(line.issuperset(ref.names) for line in lines)]
    if late and all(getattr(place, "side", "") != "next" for _, place, _ in scene.loose):
        raise which_one("this could be a side of the table or of what is spoken of before", late[0],
                        "say 'to the left half of the table', or of what")  # fmt: skip


def each_alone(item: tuple[Ref, Meaning, Span]) -> list[tuple[Ref, Meaning, Span]]:
    """ "No red block", "the red blocks (not)" at a place: none of them is there."""
    ref, at_, span = item
    if ref.op == "nor":
        return [(part, at_, span) for part in ref.parts]
    if ref.op != "and" or len(ref.names) < 2 or ref.built:
        return [item]
    at_ = replace(at_, side="end") if isinstance(at_, At) and at_.side == "ends" else at_
    return [(Ref(names=(name,), span=ref.span), at_, span) for name in ref.names]


def once_of_each_look(scene: Scene, lines: list[frozenset[str]]) -> list[tuple[Ref, Meaning, Span]]:
    """What is denied, told of one of those that look alike in a line: its order is told by looks."""
    found: list[tuple[Ref, Meaning, Span]] = []
    told: set[Hashable] = set()
    for ref, at_, span in scene.denied:
        inside = frozenset(line for line in lines if line.issuperset(ref.names))
        same = (tuple(looks(scene.things[name]) for name in ref.names), at_, inside)
        if not inside or same not in told:
            found.append((ref, at_, span))
        told.add(same)
    return found
