"""First step, asset analysis: what blocks a task has, what they show, and which limits they are beyond."""

from __future__ import annotations

import string
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from rpg.ir.assets import FACES, Block, SemanticCube
from rpg.ir.schema import MAX_BLOCKS, MAX_DIGITS, MAX_LETTERS, TaskSchema

Sort = Literal["letter", "digit", "sign"]
LIMITS = {"letter": MAX_LETTERS, "digit": MAX_DIGITS, "block": MAX_BLOCKS}
"""How many of each a task may have."""


@dataclass(frozen=True)
class Excess:
    """More of something than a task may have; `names`: all of them, in the order in which they were brought up."""

    what: Literal["letter", "digit", "block"]
    names: tuple[str, ...]

    @property
    def limit(self) -> int:
        """How many there may be."""
        return LIMITS[self.what]


@dataclass(frozen=True)
class Inventory:
    """The blocks of a task.

    `shows`: the symbols on each block's faces; `edges`: in metres; `open`: blocks whose symbol the instruction left
    open, with the symbols that each may show.
    """

    shows: Mapping[str, frozenset[str]]
    edges: Mapping[str, float]
    open: Mapping[str, str]

    @property
    def blocks(self) -> tuple[str, ...]:
        """The names of all blocks."""
        return tuple(self.shows)

    def of(self, sort: Sort) -> tuple[str, ...]:
        """The cubes that show a symbol of this sort."""
        return tuple(name for name, symbols in self.shows.items() if any(sort_of(s) == sort for s in symbols))

    def sorts(self, name: str) -> frozenset[Sort]:
        """The sorts of the symbols that a block shows; none for a plain one."""
        return frozenset(sort_of(symbol) for symbol in self.shows[name])

    @property
    def excesses(self) -> tuple[Excess, ...]:
        """The limits that the task is beyond."""
        counted = (Excess("block", self.blocks), Excess("letter", self.of("letter")), Excess("digit", self.of("digit")))
        return tuple(excess for excess in counted if len(excess.names) > excess.limit)


def take_stock(task: TaskSchema, open_: Mapping[str, str]) -> Inventory:
    """The inventory of a task."""
    return Inventory(
        shows={block.name: _symbols(block) for block in task.blocks},
        edges={block.name: block.size for block in task.blocks},
        open=open_,
    )


def sort_of(symbol: str) -> Sort:
    """Letter, digit, or a sign of arithmetic."""
    if symbol in string.ascii_uppercase:
        return "letter"
    return "digit" if symbol in string.digits else "sign"


def _symbols(block: Block) -> frozenset[str]:
    if not isinstance(block, SemanticCube):
        return frozenset()
    return frozenset(symbol for face in FACES if (symbol := block.symbol(face)))
