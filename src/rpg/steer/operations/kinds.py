"""Blocks of another kind in the same places: letters instead of colours, numbers instead of letters, a mixture."""

from __future__ import annotations

import string
from collections.abc import Sequence
from typing import Any

from rpg.blocks.traits import Traits
from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir.assets import Asset, Block, ColoredCube, SemanticCube
from rpg.ir.edits import SetGoal
from rpg.ir.order import Order, Pattern
from rpg.ir.schema import MAX_DIGITS, MAX_LETTERS
from rpg.ir.structures import GroupBy, Towers
from rpg.ir.walk import atoms, transform
from rpg.steer.draft import Draft
from rpg.steer.operations.exchange import exchange
from rpg.steer.operations.make import PALETTE
from rpg.steer.refer import resolve
from rpg.steer.requests import requests as r

SYMBOLS = {"letter": string.ascii_uppercase, "digit": "123456789", "symbol": string.ascii_uppercase}
MOST = {"letter": MAX_LETTERS, "digit": MAX_DIGITS, "symbol": MAX_LETTERS}


def listed(draft: Draft, names: Sequence[str]) -> list[str]:
    """`names` in the order in which the goal lines them up, where it does."""
    wanted = set(names)
    line = next((line for line in draft.view.lines if wanted <= set(line.members) and line.ordered), None)
    return [name for name in (line.members if line else names) if name in wanted]


def convert(draft: Draft, names: Sequence[str], kind: str, span: Span) -> None:
    """Blocks become letters, digits or plain ones; orders and groups by colour become orders and groups by symbol."""
    draft.aim("MODIFY")
    draft.note("kind", {"to": kind, "blocks": list(names)})
    names = [name for name in listed(draft, names) if name in draft.view.world.blocks]
    classes = _classes(draft, names, kind)
    new: dict[str, Asset] = {}
    if kind == "plain":
        new = {name: _plain(draft, name, PALETTE[classes[name] % len(PALETTE)]) for name in names}
        draft.assume("colours in the order of the rainbow, as none were named")
    else:
        row = SYMBOLS[kind] if max(classes.values(), default=0) < 9 or kind != "digit" else "0123456789"
        chosen = names[: MOST[kind]]
        if len(chosen) < len(names):
            draft.assume(
                f"at most {MOST[kind]} blocks can show a {kind}; the other {len(names) - len(chosen)} stay plain"
            )
        new = {name: _symbol(draft.view.world.blocks[name], row[classes[name] % len(row)], kind) for name in chosen}
    _adapt(draft, "color" if kind == "plain" else "label", "number" if kind == "digit" else "label")
    exchange(draft, new, span)


def _classes(draft: Draft, names: Sequence[str], kind: str) -> dict[str, int]:
    """Which blocks get equal symbols (or colours): those that the goal holds together by attribute; else none."""
    attribute = "label" if kind == "plain" else "color"
    traits = Traits(draft.view.world)
    if not any(attribute in _attributes(atom) for atom in atoms(draft.schema.goal)):
        return {name: index for index, name in enumerate(names)}
    values = list(dict.fromkeys(str(traits.of(name, attribute)) for name in names))  # type: ignore[arg-type]
    return {name: values.index(str(traits.of(name, attribute))) for name in names}  # type: ignore[arg-type]


def _attributes(atom: g.Goal) -> set[str]:
    """The attributes by which an atom holds blocks together."""
    found: set[str] = set()
    pattern = getattr(atom, "pattern", None)
    if isinstance(pattern, Pattern) and pattern.kind in ("row", "column", "layer", "checkerboard"):
        found.add(pattern.attribute)
    if isinstance(atom, GroupBy) and atom.by:
        found.add(atom.by)
    if isinstance(atom, Towers) and atom.each:
        found.add(atom.each)
    order = getattr(atom, "order", None)
    if isinstance(order, Order) and order.by in ("alternating", "mirrored", "together"):
        found.add(order.attribute)
    return found


def _adapt(draft: Draft, attribute: str, sorting: str) -> None:
    """Orders, patterns and groups compare what the blocks now differ in."""

    def adapted(order: Order) -> Order:
        if order.by in ("rainbow", "label", "number"):
            return order.model_copy(update={"by": "rainbow" if attribute == "color" else sorting})
        if order.by in ("alternating", "mirrored", "together"):
            return order.model_copy(update={"attribute": attribute})
        return order

    def change(node: g.Goal) -> g.Goal:
        update: dict[str, Any] = {}
        order, pattern = getattr(node, "order", None), getattr(node, "pattern", None)
        if isinstance(order, Order):
            update["order"] = adapted(order)
        if isinstance(pattern, Pattern):
            update["pattern"] = pattern.model_copy(update={"attribute": attribute, "order": adapted(pattern.order)})
        if isinstance(node, GroupBy) and node.by:
            update["by"] = attribute
        if isinstance(node, Towers) and node.each:
            update["each"] = attribute
        return node.model_copy(update=update) if update else node

    goal = transform(draft.schema.goal, change)
    if goal != draft.schema.goal:
        draft.do(SetGoal(goal=goal))


def _plain(draft: Draft, name: str, color: str) -> Block:
    block = draft.view.world.blocks[name]
    if isinstance(block, ColoredCube):
        return block
    return ColoredCube.model_validate({"name": name, "color": color, "size": block.size})


def _symbol(block: Block, label: str, kind: str) -> Block:
    shown = block.label if isinstance(block, SemanticCube) else ""
    if shown and (shown.isalpha() if kind != "digit" else shown.isdigit()):
        return block
    return SemanticCube(name=block.name, label=label, size=block.size)


def mix(draft: Draft, names: Sequence[str], kinds: Sequence[str | None], span: Span) -> None:
    """Blocks become a mixture of kinds in equal shares; groups are then told apart by kind."""
    draft.aim("MODIFY")
    draft.note("kind", {"to": list(kinds), "blocks": list(names)})
    order = [name for name in names if name in draft.view.world.blocks]
    share = -(-len(order) // len(kinds))
    new: dict[str, Asset] = {}
    for index, name in enumerate(order):
        kind, place = kinds[index // share] or "plain", index % share
        block = draft.view.world.blocks[name]
        if kind == "plain":
            new[name] = ColoredCube.model_validate(
                {"name": name, "color": PALETTE[place % len(PALETTE)], "size": block.size}
            )
        else:
            new[name] = SemanticCube(name=name, label=SYMBOLS[kind][place], size=block.size)
    renamed = exchange(draft, new, span)
    _regroup(draft, [renamed[name] for name in order], share)


def mixed(draft: Draft, request: r.Kinds) -> None:
    """The blocks of the request, or of the whole task, become a mixture."""
    names = resolve(draft.view, request.theme).names if request.theme is not None else draft.view.busy
    mix(draft, names, request.kinds, request.span)


def _regroup(draft: Draft, names: Sequence[str], share: int) -> None:
    """Groups follow the kinds that their blocks have now."""

    def change(node: g.Goal) -> g.Goal:
        if isinstance(node, GroupBy) and {n for group in node.groups for n in group} == set(names):
            groups = tuple(tuple(names[k : k + share]) for k in range(0, len(names), share))
            return node.model_copy(update={"groups": groups, "by": "kind"})
        return node

    goal = transform(draft.schema.goal, change)
    if goal != draft.schema.goal:
        draft.do(SetGoal(goal=goal))
        draft.assume("the groups are letters, numbers and plain blocks")
