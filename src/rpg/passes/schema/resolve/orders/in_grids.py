"""Where some of the blocks of a figure are, told after it: "the middle one", "the far left one", "its corners"."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir.structures import Figure, Grid
from rpg.ir.walk import transform
from rpg.language.meaning import At, Meaning, Places
from rpg.passes.schema.resolve.orders.parts import cells_of, groups_in, laid
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse

CELLS = frozenset({"back left", "back right", "front left", "front right"})


Item = tuple[Ref, Meaning, Span]


def in_figure(goal: g.Goal, node: Grid | Figure, items: Sequence[Item], scene: Scene) -> g.Goal:
    """The goal with these blocks in their cells."""
    held: dict[int, str] = {}
    cells = cells_of(node, len(node.blocks))
    for ref, place, span in items:
        part = place if isinstance(place, At | Places) and node.pattern is None and cells else None
        indices = [k for group in groups_in(part, node, cells, scene) for k in group] if part is not None else []
        if len(indices) != len(ref.names) or {*indices} & {*held}:
            raise refuse("misplaced", "the structure has no such part", span, "name its blocks one by one")
        held.update(zip(indices, ref.names, strict=True))
    rest = iter([n for n in node.blocks if n not in held.values()])
    every = [held.get(k) or next(rest) for k in range(len(cells))]
    runs = groupby(range(len(cells)), lambda k: k if k in held else -1)
    ranks = tuple(tuple(every[k] for k in run) for _, run in runs)
    looks = {n: (scene.things[n].color, scene.things[n].label) for n in node.blocks}
    unlike = {looks[n] for n in every if n not in held.values()}.isdisjoint(looks[n] for n in held.values())
    pattern = laid(node, ranks)
    if not unlike:
        pattern = pattern.model_copy(update={"order": pattern.order.model_copy(update={"match": "single"})})
    return transform(goal, lambda x: node.model_copy(update={"pattern": pattern}) if x == node else x)
