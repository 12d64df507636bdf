"""The centres of blocks in many states at once, for ruling out most of the states in which a goal cannot hold."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from rpg.blocks.state import Vec3, World

Numbers = NDArray[np.float64]
Mask = NDArray[np.bool_]
"""One truth value a state."""


class Centres:
    """Where blocks are in each of many states, as one world sees them: `column` is that of each of its blocks in
    `places`, which has a row a state."""

    def __init__(self, world: World, places: Numbers, column: Mapping[str, int]) -> None:
        self.world, self.places, self.column = world, places, column

    def of(self, names: Sequence[str]) -> tuple[Numbers, Numbers, Numbers]:
        """x, y and z of these blocks: a row a state, a column a block."""
        x, y, z = self.places[:, :, [self.column[name] for name in names]]
        return x, y, z

    def edges(self, names: Sequence[str]) -> Numbers:
        """The edges of these blocks."""
        return np.array([self.world.edge[name] for name in names])

    def all(self) -> Mask:
        """Every state."""
        return np.ones(self.places.shape[1], dtype=np.bool_)

    def none(self) -> Mask:
        """No state."""
        return np.zeros(self.places.shape[1], dtype=np.bool_)


def places_of(names: Iterable[str], positions: Sequence[Mapping[str, Vec3]]) -> Numbers:
    """The centres of these blocks: x, y and z, each with a row a state and a column a block."""
    wanted = tuple(names)
    rows = ([place[name] for name in wanted] for place in positions)
    # one long run of numbers: nested lists take twice as long to become an array
    numbers = np.fromiter(chain.from_iterable(chain.from_iterable(rows)), np.float64)
    return np.ascontiguousarray(numbers.reshape(len(positions), len(wanted), 3).transpose(2, 0, 1))
