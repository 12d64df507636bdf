"""Blocks that are counted where others were counted before: some of those, or further ones."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

from rpg.ir.node import members
from rpg.ir.relations import InRegion, OnPatch
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import atoms
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_FURTHER = frozenset({"another", "other", "others", "more", "further", "additional", "also", "too", "extra"})
"""Words of blocks beside those that were spoken of."""


def check_fewer_there(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "three blocks stand on the mat. Two should be on it" as five that should be on it."""
    there = [x for x in atoms(task.goal) if isinstance(x, OnPatch | InRegion) and x.span]
    for one, two in combinations(there, 2):
        alike = one.model_copy(update={"a": two.a, "span": two.span}) == two
        if not alike or {*members(one.a)} & {*members(two.a)} or len(members(two.a)) >= len(members(one.a)):
            continue
        begin, end = one.span[1] if one.span else 0, two.span[1] if two.span else 0
        between = [token.word for token in words if begin <= token.span[0] < end]
        if "." in between and _FURTHER.isdisjoint(between):
            raise refuse("ambiguous", "these could be some of the blocks before them, or further ones", two.span,
                         "say 'two of them', or 'two more'")  # fmt: skip
