"""Two blocks, or two groups of one size, change places in the goal."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.blocks.traits import Traits
from rpg.core.diagnostics import Span
from rpg.ir.edits import SetField
from rpg.ir.structures import Equation, GroupBy, Row, Spells, Stack
from rpg.steer.draft import Draft
from rpg.steer.operations.exchange import exchange
from rpg.steer.operations.lines import pin
from rpg.steer.operations.order import permute, put_in_order
from rpg.steer.refer import resolve
from rpg.steer.requests import requests as r
from rpg.steer.requests.replacing import TradeColors
from rpg.steer.view import Line


def _trade_symbols(draft: Draft, line: Line, a: Sequence[str], b: Sequence[str], span: Span) -> None:
    """Cubes of a word change places, which makes it another word; an equation is given as a whole."""
    if not isinstance(line.node, Spells) or not line.ordered or line.node.reverse:
        told, hint = "this changes what the cubes have to show", "say what they show: 'change it to 3 + 2 = 5'"
        raise draft.refusal("breaks-structure", told, span, hint)
    new = {**dict(zip(a, b, strict=True)), **dict(zip(b, a, strict=True))}
    draft.aim("MODIFY")
    put_in_order(draft, line, [new.get(name, name) for name in line.members], span)
    draft.note("swap", [list(a), list(b)])
    draft.look_at((*a, *b))


def trade(draft: Draft, request: r.Trade) -> None:
    """Two blocks, or two groups of one size, take each other's parts in the goal."""
    a, b = resolve(draft.view, request.a).names, resolve(draft.view, request.b).names
    if len(a) != len(b):
        raise draft.refusal(
            "edit-unclear",
            f"{len(a)} blocks cannot change places with {len(b)}",
            request.span,
            "name as many blocks on both sides",
        )
    looks = draft.view.world.look
    if any(looks.get(one) != looks.get(other) for one, other in zip(a, b, strict=True)):
        for name in (*a, *b):
            pin(draft, (name,), request.span)
    line = draft.view.line_of((*a, *b))
    if line is not None and isinstance(line.node, Spells | Equation):
        _trade_symbols(draft, line, a, b, request.span)
        return
    free = isinstance(line.node, Stack | Row) and line.node.order.by == "any" if line is not None else False
    if line is not None and free and not line.ordered:
        told, hint = "the order of these blocks is free, so that they have no places to change", "give the order first"
        raise draft.refusal("nothing-to-do", told, request.span, hint)
    before = draft.schema.goal
    permute(draft, {**dict(zip(a, b, strict=True)), **dict(zip(b, a, strict=True))}, request.span)
    if draft.schema.goal == before:
        raise draft.refusal(
            "nothing-to-do",
            "the goal does not tell these blocks apart",
            request.span,
            "swap blocks that the goal has a place for",
        )
    _untied(draft)
    draft.aim("MODIFY")
    draft.note("swap", [list(a), list(b)])
    draft.look_at((*a, *b))


def _untied(draft: Draft) -> None:
    """Groups whose members do not agree any more are not told apart by what they agreed in."""
    traits = Traits(draft.view.world)
    for path, atom in draft.view.atoms:
        if not isinstance(atom, GroupBy) or atom.by is None or atom.outliers:
            continue
        if any(len({traits.of(name, atom.by) for name in group}) > 1 for group in atom.groups):
            draft.do(SetField(at=path, field="by", value=None))


def trade_colors(draft: Draft, request: TradeColors) -> None:
    """What had one of two colours gets the other; two single blocks take each other's places."""
    world = draft.view.world
    names = tuple(world.patches) if request.patches else draft.view.busy
    colors = list(dict.fromkeys(world.assets[name].color for name in names))
    if len(colors) != 2:
        told, hint = f"there are {len(colors)} colours", "say which two: swap red and blue"
        raise draft.refusal("ambiguous-object", told, request.span, hint)
    draft.aim("MODIFY")
    draft.note("swap", colors)
    if len(names) == 2 and not request.patches:
        before = draft.schema.goal
        permute(draft, {names[0]: names[1], names[1]: names[0]}, request.span)
        if draft.schema.goal == before:
            raise draft.refusal("nothing-to-do", "the goal does not tell these blocks apart", request.span)
        draft.look_at(names)
        return
    other = {colors[0]: colors[1], colors[1]: colors[0]}
    exchange(
        draft,
        {name: world.assets[name].model_copy(update={"color": other[world.assets[name].color]}) for name in names},
        request.span,
    )
