"""What the start leaves open, or settles, of the end: what is left as it is, is not turned either; a line that is there
already is to go the other way."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.walk import atoms, transform
from rpg.ir.walk import names as names_in
from rpg.passes.schema.resolve.things.world import Scene


def left_as_they_are(goal: g.Goal, scene: Scene) -> g.Goal:
    """ "Turn B by 90 degrees and leave the others as they are": these lie as they did, and not only where."""
    turned = {x.block for x in atoms(goal) if isinstance(x, r.Turned | r.Facing)}
    if not turned:
        return goal

    def change(node: g.Goal) -> g.Goal:
        names = names_in(node) if isinstance(node, r.Stayed) else ()
        still = [r.Turned(block=n, degrees=0.0, span=node.span) for n in names if n in scene.untouched - turned]
        return g.All(goals=(node, *still), span=node.span) if still else node

    return transform(goal, change)


def the_other_way(goal: g.Goal, scene: Scene) -> g.Goal:
    """ "Four blocks stand one behind the other. They should stand side by side": from left to right, for in a line that
    goes any way they are already."""
    begun = {frozenset(x.blocks): x.axis for start in scene.start_goals for x in atoms(start) if isinstance(x, s.Row)}

    def change(node: g.Goal) -> g.Goal:
        axis = begun.get(frozenset(node.blocks)) if isinstance(node, s.Row) and _any_line(node) else None
        return node.model_copy(update={"axis": "y" if axis == "x" else "x"}) if axis is not None else node

    return transform(goal, change) if any(begun.values()) else goal


def _any_line(row: s.Row) -> bool:
    """Whether nothing is asked of a line but that it is one."""
    told = (row.axis, row.spacing, row.gap) == (None, None, None) and not (row.touching or row.evenly)
    return told and row.order.by == "any"
