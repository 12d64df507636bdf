"""Fourth step, repair: the smallest change that would make a task possible.

A repair is `silent` only where it changes nothing that was asked for: an order that has another name, a symbol that
was left open, a face that nobody can see. It is then made, and noted among the task's assumptions. Every other repair
would change the request: it is only suggested, in words that can be compiled.
"""

from __future__ import annotations

import string
from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import islice
from typing import Any, Literal

from pydantic import ValidationError

from rpg.blocks.english import describe
from rpg.blocks.english.variants import variants
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.assets import Asset, ColoredCube, SemanticCube
from rpg.ir.order import Order
from rpg.ir.schema import TaskSchema
from rpg.ir.shrink import TooSmall, without
from rpg.ir.walk import rename, transform
from rpg.passes.schema.feasibility.conflicts import Conflict
from rpg.passes.schema.feasibility.inventory import Excess, Inventory, Sort, take_stock
from rpg.passes.schema.feasibility.requirements import Ordering, Sight, Symbols

RepairKind = Literal["REDUCE_LABELS_PRESERVE_GEOMETRY", "SWITCH_ORDERING_PATTERN", "SWITCH_TO_SPATIAL_ONLY"]
RAINBOW = ("red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink")
SYMBOLS = {"letter": string.ascii_uppercase, "digit": "1234567890"}
TRIES = 3
"""Texts that are tried for a repaired task, the one that says everything apart."""


@dataclass(frozen=True)
class Repair:
    """A task that is possible in place of one that is not; `text`: what was changed and what is kept.

    `silent`: nothing that was asked for has changed.
    """

    kind: RepairKind
    task: TaskSchema
    text: str
    silent: bool = False

    def instructions(self) -> Iterator[str]:
        """The repaired task in words, the shortest first."""
        yield from islice(variants(self.task), TRIES)
        yield describe(self.task)


def repairs(task: TaskSchema, stock: Inventory, conflict: Conflict) -> Iterator[Repair]:
    """Repairs for one conflict, the one that changes least first."""
    for repair in _proposed(task, stock, conflict):
        with suppress(ValidationError):
            yield replace(repair, task=TaskSchema.model_validate(repair.task.model_dump()))


def _proposed(task: TaskSchema, stock: Inventory, conflict: Conflict) -> Iterator[Repair]:
    match conflict.need:
        case Excess(what="letter" | "digit") as excess:
            yield from _fewer_labels(task, stock, excess)
        case Ordering() as ordering:
            yield from _other_order(task, stock, ordering)
        case Symbols() as symbols:
            yield from _places_alone(task, symbols)
        case Sight() as sight:
            yield from _unseen(task, sight)


def _fewer_labels(task: TaskSchema, stock: Inventory, excess: Excess) -> Iterator[Repair]:
    """Show other symbols where the choice is open; else show fewer, and where even that breaks an order, use fewer."""
    surplus = excess.names[excess.limit :]
    other: Sort = "digit" if excess.what == "letter" else "letter"
    used = {symbol for symbols in stock.shows.values() for symbol in symbols}
    free = [symbol for symbol in SYMBOLS[other] if symbol not in used]
    if len(surplus) <= len(free) and all(set(free) <= set(stock.open.get(name, "")) for name in surplus):
        shown = dict(zip(surplus, free, strict=False))
        yield Repair(
            "REDUCE_LABELS_PRESERVE_GEOMETRY",
            _renamed(_relabelled(task, shown), {name: f"{symbol}_block" for name, symbol in shown.items()}),
            f"there are {excess.limit} {excess.what} cubes at most: the further symbols are {' '.join(shown.values())}",
            silent=True,
        )
        return
    kept = f"the shape stays, with {excess.limit} {excess.what} cubes"
    yield Repair("REDUCE_LABELS_PRESERVE_GEOMETRY", _plain(task, surplus), f"{kept} and {len(surplus)} plain blocks")
    for count in range(excess.limit, 1, -1):
        try:
            fewer = _dropped(task, excess.names[count:])
        except (TooSmall, ValueError):
            return
        yield Repair("REDUCE_LABELS_PRESERVE_GEOMETRY", fewer, f"the shape stays, with {count} {excess.what} cubes")


def _other_order(task: TaskSchema, stock: Inventory, need: Ordering) -> Iterator[Repair]:
    """The order that these blocks can show: by digits, letters or colours; else none."""
    shown = {sort for name in need.among for sort in stock.sorts(name)}
    plain = any(not stock.sorts(name) for name in need.among)
    if shown == {"digit"} and not plain:
        text = "digits have no alphabet: the order is numerical"
        yield _reordered(task, need, need.order.model_copy(update={"by": "number"}), text, silent=True)
    elif shown == {"letter"} and not plain:
        text = "the same places, in alphabetical order"
        yield _reordered(task, need, need.order.model_copy(update={"by": "label"}), text)
    colors = {block.name: block.color for block in task.blocks}
    hues = [colors[name] for name in need.among if name in colors]
    if len(set(hues)) > 1 and set(hues) <= set(RAINBOW):
        order = Order(by="rainbow", first=need.order.first, descending=need.order.descending)
        yield _reordered(task, need, order, "the same places, ordered by colour")
    spatial = _with_order(task, need, Order())
    yield Repair("SWITCH_TO_SPATIAL_ONLY", spatial, "the same places, in any order")


def _places_alone(task: TaskSchema, need: Symbols) -> Iterator[Repair]:
    """The blocks of a text stand as they would, and nothing is asked of what they show."""
    line: g.Goal = (
        s.Row(blocks=need.among, axis="y", span=need.atom.span)
        if need.atom.along == "row"
        else s.Stack(blocks=need.among, span=need.atom.span)
    )
    spatial = _replaced(task, {id(need.atom): line})
    yield Repair("SWITCH_TO_SPATIAL_ONLY", spatial, "the blocks stand as they would, whatever they show")


def _unseen(task: TaskSchema, need: Sight) -> Iterator[Repair]:
    """Nothing is asked of faces that are covered: silently where the same phrase speaks of faces that are seen."""
    new: dict[int, g.Goal | None] = {}
    hidden: list[str] = []
    for atom in need.atoms:
        stack = next((stack for stack in need.loose if atom.block in stack and len(stack) > 1), None)
        if atom.block in need.covered:
            new[id(atom)] = None
            hidden.append(atom.block)
        elif stack is not None:
            new[id(atom)] = g.Any(goals=(g.Not(goal=r.Clear(a=(atom.block,))), atom), span=atom.span)
    text = "nothing is asked of a face that another block lies on"
    spatial = _replaced(task, new)
    if len(hidden) < len(need.atoms):
        yield Repair("SWITCH_TO_SPATIAL_ONLY", spatial, text, silent=True)
    else:
        yield Repair("SWITCH_TO_SPATIAL_ONLY", _relabelled(spatial, _single(task, hidden)), text)


def _single(task: TaskSchema, names: Iterable[str]) -> dict[str, str]:
    """The symbol of each cube that shows one symbol, on whichever faces: without a duty it may be on all of them."""
    shown = take_stock(task, {}).shows
    return {name: next(iter(shown[name])) for name in names if len(shown[name]) == 1}


def _reordered(task: TaskSchema, need: Ordering, order: Order, text: str, *, silent: bool = False) -> Repair:
    return Repair("SWITCH_ORDERING_PATTERN", _with_order(task, need, order), text, silent)


def _with_order(task: TaskSchema, need: Ordering, order: Order) -> TaskSchema:
    pattern = getattr(need.atom, "pattern", None)
    update: dict[str, Any] = {"order": order, "readable": order.by in ("label", "number")}
    if pattern is not None:
        update = {"pattern": pattern.model_copy(update={"order": order}) if order.by != "any" else None}
    return _replaced(task, {id(need.atom): need.atom.model_copy(update=update)})


def _replaced(task: TaskSchema, new: Mapping[int, g.Goal | None]) -> TaskSchema:
    """The task with other nodes in its goal; None takes one out."""

    def change(node: g.Goal) -> g.Goal:
        if isinstance(node, g.All):
            kept = tuple(part for part in node.goals if part is not GONE)
            return kept[0] if len(kept) == 1 and len(node.goals) > 1 else node.model_copy(update={"goals": kept})
        return (new[id(node)] or GONE) if id(node) in new else node

    return task.model_copy(update={"goal": transform(task.goal, change)})


GONE = g.All(goals=())
"""Stands for a goal that is taken out."""


def _relabelled(task: TaskSchema, shown: Mapping[str, str]) -> TaskSchema:
    """The task with these symbols on all faces of some cubes."""

    def relabel(asset: Asset) -> Asset:
        if not isinstance(asset, SemanticCube) or asset.name not in shown:
            return asset
        return asset.model_copy(update={"label": shown[asset.name], "labels": None})

    return task.model_copy(update={"assets": tuple(map(relabel, task.assets))})


def _plain(task: TaskSchema, names: tuple[str, ...]) -> TaskSchema:
    """The task with plain cubes in place of some that show symbols."""
    taken = {asset.color for asset in task.assets}
    color = next(hue for hue in (*RAINBOW, "brown") if hue not in taken)
    made = tuple(
        ColoredCube(name=asset.name, color=color, size=asset.size)  # type: ignore[arg-type]
        if asset.name in names and not isinstance(asset, ColoredCube) and hasattr(asset, "labels")
        else asset
        for asset in task.assets
    )
    numbered = {name: f"{color}_block_{n}" for n, name in enumerate(names, start=1)}
    return _renamed(task.model_copy(update={"assets": made}), numbered)


def _dropped(task: TaskSchema, names: tuple[str, ...]) -> TaskSchema:
    """The task without some of its blocks. Raises TooSmall where a structure cannot do without them."""
    goal = without(task.goal, names)
    arranged = tuple(kept for start in task.init.arranged if (kept := without(start, names)) is not None)
    if goal is None:
        raise ValueError("nothing would be left to do")
    heaps = tuple(tuple(name for name in heap if name not in names) for heap in task.init.heaps)
    init = task.init.model_copy(update={"arranged": arranged, "heaps": tuple(heap for heap in heaps if heap)})
    assets = tuple(asset for asset in task.assets if asset.name not in names)
    return task.model_copy(update={"assets": assets, "goal": goal, "init": init})


def _renamed(task: TaskSchema, names: Mapping[str, str]) -> TaskSchema:
    """The task with other names for some of its objects."""
    init = task.init
    return task.model_copy(
        update={
            "assets": tuple(a.model_copy(update={"name": names.get(a.name, a.name)}) for a in task.assets),
            "goal": rename(task.goal, names),
            "init": init.model_copy(
                update={
                    "arranged": tuple(rename(start, names) for start in init.arranged),
                    "heaps": tuple(tuple(names.get(n, n) for n in heap) for heap in init.heaps),
                }
            ),
        }
    )
