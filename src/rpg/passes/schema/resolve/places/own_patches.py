"""Blocks and patches of the same colors, each of which has "its own" patch."""

from __future__ import annotations

from rpg.passes.schema.resolve.things.world import Scene

Unit = tuple[str, ...]
"""Blocks that go together."""


def by_color(units: list[Unit], patches: Unit, scene: Scene) -> list[tuple[Unit, str]]:
    """ "Each block on its own mat", where there is one mat of the color of each: on that; nothing where not."""
    mats = {scene.things[name].color: name for name in patches}
    hues = [{scene.things[name].color for name in unit} for unit in units]
    told = [hue.pop() if len(hue) == 1 else None for hue in hues]
    if None in told or len({*told}) < len(told) or {*told} != {*mats} or len(mats) < len(patches):
        return []
    return [(unit, mats[hue]) for unit, hue in zip(units, told, strict=True)]
