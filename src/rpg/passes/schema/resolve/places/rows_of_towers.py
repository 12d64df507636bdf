"""Towers that stand in a row: "three towers in a row, the blue one in the middle"."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.passes.schema.resolve.places.of_themselves import Loose
from rpg.passes.schema.resolve.things.operands import UPRIGHT
from rpg.passes.schema.resolve.things.world import Scene


def of_towers(lines: Iterable[g.Goal], loose: Sequence[Loose], scene: Scene) -> Iterator[tuple[s.Row, list[Loose]]]:
    """The row that one block of each tower is in, and what is said of the towers, as said of these blocks."""
    towers = [{*built.members} for built in scene.built if built.kind in UPRIGHT]
    for node in (line for line in lines if isinstance(line, s.Row)):
        feet = [(ref, at_, span, {*ref.names} & {*node.blocks}) for ref, at_, span in loose]
        if feet and all(len(there) == 1 < len(ref.names) and {*ref.names} in towers for ref, _, _, there in feet):
            yield node, [(replace(ref, names=(*there,)), at_, span) for ref, at_, span, there in feet]
