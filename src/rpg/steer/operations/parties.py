"""Towers that a goal has several of: one more of them, all of them higher, one of them by itself."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import fields

from rpg.blocks.traits import Traits
from rpg.ir import goal as g
from rpg.ir.edits import AddAsset, AddCondition, ChangeCondition, RemoveAsset
from rpg.ir.schema import COLORS_UNSAID
from rpg.ir.structures import Stack, Towers
from rpg.steer.draft import Draft
from rpg.steer.operations.make import describe, named, new_assets, unused_colors
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import m
from rpg.steer.requests.parties import NewTower, SoManyTowers
from rpg.steer.view import Shape


def new_tower(draft: Draft, request: NewTower) -> None:
    """New blocks in a tower of their own, beside those that are there."""
    towers = next((f for f in draft.view.figures if isinstance(f.node, Towers)), None)
    there = sum(line.kind == "tower" for line in draft.view.lines)
    if towers is not None and isinstance(towers.node, Towers):
        there = towers.node.count or len(towers.node.heights or ())
    if not there:
        told, hint = "the task has no towers", "say where the blocks go: on top of, beside, on a patch"
        raise draft.refusal("no-such-object", told, request.span, hint)
    if request.ordinal is not None and request.ordinal != there + 1:
        told = f"the task has {there} towers, so that the next one is number {there + 1}"
        raise draft.refusal("edit-unclear", told, request.span, "say 'as another tower'")
    draft.aim("EXTEND")
    names = draft.add(new_assets(draft, request.theme), request.span)
    draft.note("add", list(names))
    if len(names) < 2:
        told, hint = "a tower takes at least two blocks", "say how many blocks it has"
        raise draft.refusal("breaks-structure", told, request.span, hint)
    if towers is not None:
        _tower(draft, towers, names, request)
    else:
        alike = len({draft.view.world.look[name] for name in names}) == 1
        draft.do(AddCondition(goal=Stack(blocks=names, exact=alike)), request.span)


def _tower(draft: Draft, figure: Shape, names: tuple[str, ...], request: NewTower) -> None:
    node = figure.node
    assert isinstance(node, Towers)
    update: dict[str, object] = {"blocks": (*node.blocks, *names)}
    if node.count is not None:
        update["count"] = node.count + 1
    if node.heights is not None:
        update["heights"] = (*node.heights, len(names))
    traits = Traits(draft.view.world)
    if node.each is not None and len({traits.of(name, node.each) for name in names}) > 1:
        told, hint = f"each tower here is of one {node.each}", "say blocks that agree in it"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    draft.do(ChangeCondition(at=figure.path, to=node.model_copy(update=update)), request.span)


def so_many(draft: Draft, request: SoManyTowers) -> None:
    """More or fewer of the towers that there are, all of one height and of blocks that look alike."""
    figure = next((f for f in draft.view.figures if isinstance(f.node, Towers)), None)
    node = figure.node if figure is not None else None
    heights = set(node.heights or ()) if isinstance(node, Towers) else set()
    if figure is None or not isinstance(node, Towers) or node.heights is None or len(heights) != 1:
        told, hint = "the task has no towers of one height that there could be more or fewer of", "say the towers again"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    alike = len({draft.view.world.look[name] for name in node.blocks}) == 1
    there, each = len(node.heights), heights.pop()
    other = request.amount > 0 and request.amount != there and len(node.blocks) % request.amount == 0
    other = other and not request.only
    unsaid = draft.schema.assumed(COLORS_UNSAID)
    if (
        not (alike or unsaid)
        or node.each is not None
        or request.amount < 2
        or (other and len(node.blocks) // request.amount > 1)
    ):
        told = "this may be fewer of the towers that there are, or other towers of the same blocks"
        raise draft.refusal("edit-unclear", told, request.span, "give the whole instruction")
    if request.amount == there:
        raise draft.refusal("nothing-to-do", f"there are {there} already", request.span)
    draft.aim("TWEAK")
    draft.note("count", {"amount": request.amount})
    blocks = list(node.blocks)
    if unsaid and request.amount > there:
        number = (request.amount - there) * each
        new = named(draft, describe(draft, m.Traits(colors=tuple(unused_colors(draft, number))), number))
        blocks += draft.add(list(new), request.span)
    else:
        blocks = _as_many(draft, blocks, request.amount * each)
    gone = [name for name in node.blocks if name not in blocks]
    update: dict[str, object] = {"blocks": tuple(blocks), "heights": (each,) * request.amount}
    if node.count is not None:
        update["count"] = request.amount
    draft.do(ChangeCondition(at=figure.path, to=node.model_copy(update=update)), request.span)
    for name in gone:
        draft.do(RemoveAsset(name=name), request.span)


def raised(draft: Draft, figure: Shape, request: r.Recount) -> bool:
    """All towers get another height; False where the request is about something else than how high they are."""
    node = figure.node
    if not isinstance(node, Towers) or request.dims or request.what not in ("height", "number") or node.heights is None:
        return False
    world, traits = draft.view.world, Traits(draft.view.world)
    times = request.times or 1.0
    wanted = [request.amount or int(h * times) + (request.by or 0) for h in node.heights]
    if min(wanted) < 2 or any(request.amount is None and h * times != int(h * times) for h in node.heights):
        told, hint = "a tower takes at least two blocks", "say how many blocks each should have"
        raise draft.refusal("breaks-structure", told, request.span, hint)
    parties = list(traits.by_value(node.blocks, node.each).values()) if node.each else [node.blocks]
    alike = all(len({world.look[name] for name in party}) == 1 for party in parties)
    if not alike or (node.each and len(parties) != len(node.heights)):
        told, hint = "it is not said how the new blocks look", "say the towers again, with their blocks"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    if wanted == list(node.heights):
        raise draft.refusal("nothing-to-do", "they have this height already", request.span)
    blocks: list[str] = []
    for party in parties:
        total = (
            sum(wanted)
            if not node.each
            else next(w for w, h in zip(wanted, node.heights, strict=True) if h == len(party))
        )
        blocks += _as_many(draft, list(party), total)
    gone = [name for name in node.blocks if name not in blocks]
    goal = node.model_copy(update={"blocks": tuple(blocks), "heights": tuple(wanted)})
    draft.do(ChangeCondition(at=figure.path, to=goal), request.span)
    for name in gone:
        draft.do(RemoveAsset(name=name), request.span)
    return True


def _as_many(draft: Draft, party: list[str], total: int) -> list[str]:
    """So many of these look-alikes: the first ones, and new ones."""
    model = draft.view.world.blocks[party[0]]
    kept = party[:total]
    for _ in range(total - len(kept)):
        (asset,) = named(draft, [model.model_copy(update={"origin": None})])
        draft.do(AddAsset(asset=asset))
        kept.append(asset.name)
    return kept


def told_apart(draft: Draft, requests: Iterable[r.Request]) -> None:
    """Towers of one colour each become towers by themselves where a request speaks of one of them by its colour."""
    if not any(_one_tower(phrase) for request in requests for phrase in _phrases(request)):
        return
    for figure in draft.view.figures:
        node = figure.node
        if isinstance(node, Towers) and node.each == "color" and node.separate and node.matching is None:
            parties = Traits(draft.view.world).by_value(node.blocks, "color")
            stacks = tuple(Stack(blocks=tuple(party), exact=True) for party in parties.values())
            draft.do(ChangeCondition(at=figure.path, to=g.All(goals=stacks)))


def _one_tower(phrase: m.Meaning) -> bool:
    if not isinstance(phrase, m.Structure) or phrase.kind != "stack" or phrase.det not in ("the", "its"):
        return False
    members = phrase.members
    return bool(phrase.traits.colors or (isinstance(members, m.Noun) and members.traits.colors))


def _phrases(value: object) -> Iterator[m.Meaning]:
    """Every phrase inside a request."""
    if isinstance(value, m.Meaning):
        yield value
    if isinstance(value, tuple):
        for each in value:
            yield from _phrases(each)
    elif isinstance(value, r.Request | m.Meaning | r.Spot):
        for field in fields(value):
            yield from _phrases(getattr(value, field.name))
