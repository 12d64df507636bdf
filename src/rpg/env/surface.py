"""What the predicate methods of a task share: how they take their operands and reach the state."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from typing import Any

from rpg.blocks.evaluate import evaluate
from rpg.blocks.state import BlockState, World
from rpg.blocks.verdict import Verdict
from rpg.ir.node import Highest, Lowest, Node
from rpg.ir.walk import names

Names = str | Sequence[str]
"""One name, or several."""
Where = Names | Lowest | Highest
"""One block or patch, several, or the foot or the top of a tower."""


class Atoms:
    """Judges single atoms of the goal on the current state, and notes each for the report of conditions."""

    world: World

    def __init__(self) -> None:
        self._now: BlockState | None = None
        self._nodes: dict[Hashable, Node] = {}
        self._noted: list[tuple[Node, Verdict]] = []

    def _atom(self, kind: type[Node], **fields: Any) -> Verdict:
        if self._now is None:
            raise RuntimeError("the task has no state yet: call reset() before judging it")
        key = (kind, *map(_frozen, fields.values()))
        node = self._nodes.get(key)
        if node is None:
            node = kind(**fields)
            self._check_names(node)
            self._nodes[key] = node
        verdict = evaluate(node, self._now)  # type: ignore[arg-type]
        self._noted.append((node, verdict))
        return verdict

    def _check_names(self, node: Node) -> None:
        unknown = [name for name in names(node) if name not in self.world.assets]  # type: ignore[arg-type]
        if unknown:
            raise ValueError(f"the task has no object {unknown[0]!r}; it has {', '.join(self.world.assets)}")

    def lowest(self, *names: str) -> Lowest:
        """Whichever of these blocks is the lowest: the foot of a tower."""
        return Lowest(lowest=names)

    def highest(self, *names: str) -> Highest:
        """Whichever of these blocks is the highest: the top of a tower."""
        return Highest(highest=names)


def _frozen(value: Any) -> Hashable:
    """`value` with its lists as tuples, so that it can be looked up."""
    if isinstance(value, list | tuple):
        return tuple(map(_frozen, value))
    hashed: Hashable = value
    return hashed
