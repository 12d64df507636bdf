"""What is left as it is: where others are turned, it is not turned either."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import relations as r
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
