"""What the predicate methods of a task share: how they take their operands and reach the state."""

from __future__ import annotations

from collections.abc import Hashable, Sequence
from copy import deepcopy
from typing import Any, NamedTuple, cast

import numpy as np
import numpy.typing as npt

from rpg.blocks.evaluate import evaluate
from rpg.blocks.namings import MANY, Namings, Variants
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.state import BlockState, World
from rpg.blocks.verdict import FALSE, Verdict
from rpg.blocks.verdicts import Verdicts
from rpg.env.told import Asked, Told
from rpg.ir import goal as g
from rpg.ir.node import Highest, Lowest, Node
from rpg.ir.walk import names

Names = str | Sequence[str]
"""One name, or several."""
Where = Names | Lowest | Highest
"""One block or patch, several, or the foot or the top of a tower."""


class _Call(NamedTuple):
    """A call of a predicate method: its kind of atom, its arguments, and the atom; the different ones that it is under
    all namings, and which of them under each; and the same of it without its order, where that is fewer."""

    kind: type[Node]
    fields: dict[str, Any]
    node: Node
    different: list[g.Goal]
    numbers: tuple[int, ...]
    chosen: npt.NDArray[np.intp]
    loosened: tuple[Node, list[g.Goal], npt.NDArray[np.intp]] | None


class Atoms:
    """Judges single atoms of the goal on the current state, and notes each for the report of conditions.

    Under a naming of look-alikes an atom speaks of other blocks; what it says of these is judged once for a state,
    however many namings, or atoms, say the same.
    """

    world: World
    _namings: Namings

    def __init__(self) -> None:
        self._now: BlockState | None = None
        self._asked = Asked.ONE_NAMING
        self._naming = 0
        self._calls: dict[Hashable, _Call] = {}
        self._script: list[_Call] = []
        self._distinct: dict[g.Goal, g.Goal] = {}
        self._variants: dict[int, Variants] = {}
        self._closely = self._passed_over = False
        self._verdicts: dict[int, Verdict] = {}
        self._noted: list[tuple[Node, Verdict]] = []

    def _look_at(self, state: BlockState) -> None:
        """Judge `state` from now on, with names as they stand."""
        self._now, self._verdicts = state, {}
        self._begin_naming(0)

    def _begin_naming(self, naming: int, asked: Asked = Asked.ONE_NAMING) -> None:
        """Names now stand for what this naming says, unless the code is `asked` in another way."""
        self._asked, self._naming, self._noted = asked, naming, []

    def _atom(self, kind: type[Node], **fields: Any) -> Verdict:
        call = self._call(kind, fields)
        if self._asked is Asked.TOLD:
            verdict = cast(Verdict, Told(call.different[0]))
        elif self._now is None:
            raise RuntimeError("the task has no state yet: call reset() before judging it")
        elif self._asked is Asked.ALL_NAMINGS:
            verdict = cast(Verdict, self._judged_at_all(call, self._now))
        else:
            verdict = self._judged_atom(call.different[call.numbers[self._naming]], self._now)
        self._noted.append((call.node, verdict))
        return verdict

    def _judged_at_all(self, call: _Call, now: BlockState) -> Verdicts:
        """The verdicts under all namings; what is the same in whatever order is judged once."""
        if call.loosened is None:
            return Verdicts.spread(self._judged_each(call.node, call.different, now), call.chosen)
        looser, different, chosen = call.loosened
        found = Verdicts.spread(self._judged_each(looser, different, now), chosen)
        predicate = PREDICATES[call.node.kind]  # type: ignore[attr-defined]
        return found & Verdicts.spread([predicate.in_order(node, now) for node in call.different], call.chosen)

    def _judged_each(self, node: Node, different: list[g.Goal], now: BlockState) -> list[Verdict]:
        """The verdicts of the different things that an atom says under all namings. Where they are many, those that
        plainly cannot hold are passed over, unless it is to be known which comes closest."""
        if len(different) < MANY or self._closely:
            return [self._judged_atom(one, now) for one in different]
        if id(node) not in self._variants:
            self._variants[id(node)] = self._namings.variants(node, self.world)  # type: ignore[arg-type]
        maybe = self._variants[id(node)].perhaps(now).tolist()
        self._passed_over = self._passed_over or not all(maybe)
        return [self._judged_atom(one, now) if k else FALSE for one, k in zip(different, maybe, strict=True)]

    def _judged_atom(self, node: g.Goal, now: BlockState) -> Verdict:
        verdict = self._verdicts.get(id(node))
        if verdict is None:
            verdict = self._verdicts[id(node)] = evaluate(node, now)
        return verdict

    def _call(self, kind: type[Node], fields: dict[str, Any]) -> _Call:
        """The call, most likely the one that was made at this place last time."""
        place = len(self._noted)
        if place < len(self._script):
            last = self._script[place]
            if last.kind is kind and last.fields == fields:
                return last
        key = (kind, *map(_frozen, fields.values()))
        call = self._calls.get(key)
        if call is None:
            node = kind(**fields)
            self._check_names(node)
            call = self._calls[key] = self._new_call(kind, deepcopy(fields), node)
        self._script[place : place + 1] = [call]
        return call

    def _new_call(self, kind: type[Node], fields: dict[str, Any], node: Node) -> _Call:
        different, numbers = self._spread(node)
        looser = PREDICATES[node.kind].loosened(node) if len(different) > 1 else None  # type: ignore[attr-defined]
        loosened = None if looser is None else self._spread(looser)
        fewer = loosened is not None and len(loosened[0]) < len(different)
        without = (cast(Node, looser), loosened[0], np.array(loosened[1])) if loosened is not None and fewer else None
        return _Call(kind, fields, node, different, numbers, np.array(numbers), without)

    def _spread(self, node: Node) -> tuple[list[g.Goal], tuple[int, ...]]:
        """The different things that an atom says under all namings, each one object for all that are equal."""
        different, numbers = self._namings.spread(node)  # type: ignore[arg-type]
        return [self._distinct.setdefault(one, one) for one in different], numbers

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
