"""Places said outside their structure: "the red one at the bottom" after "build a tower of three blocks"."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.passes.schema.resolve.things.world import Scene


def settle(goal: g.Goal, scene: Scene) -> g.Goal:
    """Work what `scene.loose` holds into the goal."""
    if not scene.loose and not scene.denied:
        return goal
    from rpg.passes.schema.resolve.places.sides import place_loose

    return place_loose(goal, scene)
