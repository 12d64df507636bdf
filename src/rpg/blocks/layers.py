"""Layers of grids, pyramids and staircases: how many blocks each has, and whether a pattern tells more apart."""

from __future__ import annotations

import itertools

from rpg.ir.structures import Cells, Grid, Pyramid, Staircase


def by_layers(node: Cells) -> bool:
    """Does the order of reading tell whole layers apart and no more, so that the figure may be turned in any way?"""
    pattern = node.pattern
    if pattern is None or pattern.kind != "reading" or pattern.own or pattern.order.by != "given":
        return False
    levels = layer_sizes(node)
    whole = set(itertools.accumulate(levels if pattern.upward else levels[::-1]))
    return len(levels) > 1 and whole.issuperset(itertools.accumulate(len(rank) for rank in pattern.order.ranks))


def layer_sizes(node: Cells) -> list[int]:
    """How many blocks each layer of a grid, a pyramid or a staircase has, the lowest first."""
    match node:
        case Grid():
            return [node.rows * node.columns] * node.layers
        case Pyramid():
            n, m = max(node.base), min(node.base)
            return [*range(n, 0, -1)] if m == 1 else [(n - k) * (m - k) for k in range(m)]
        case Staircase():
            return [*range(node.steps, 0, -1)]
        case _:
            return []
