"""Cubes that show other symbols together: another equation, letters or numbers that go on."""

from __future__ import annotations

import string
from itertools import pairwise

from rpg.blocks.equations import is_true, value_of
from rpg.blocks.traits import Traits
from rpg.ir.edits import AddAsset, ChangeCondition, RemoveAsset
from rpg.ir.structures import Equation, Spells
from rpg.steer.draft import Draft
from rpg.steer.operations.exchange import exchange
from rpg.steer.operations.lines import insert
from rpg.steer.operations.make import describe, free_name
from rpg.steer.operations.words import respell
from rpg.steer.requests.language import m
from rpg.steer.requests.symbols import Continue, Equate, Respell


def equate(draft: Draft, request: Equate) -> None:
    """Cubes that both equations have stay, others show other symbols, missing ones are added, spare ones leave."""
    line = next((line for line in draft.view.lines if isinstance(line.node, Equation)), None)
    if line is None or not isinstance(line.node, Equation):
        told, hint = "the task has no equation", "say it as an instruction of its own: make the equation 2 + 3 = 5"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    text = request.text
    longer = line.node.longer or any(a.isdigit() and b.isdigit() for a, b in pairwise(text))
    if not is_true(text, longer):
        value = value_of(text.split("=")[0], longer)
        hint = f"say {text.split('=')[0]}={value}" if value is not None else "say for example 2+3=5"
        raise draft.refusal("false-equation", "this equation is not true", request.span, hint)
    draft.aim("MODIFY")
    draft.note("equation", text)
    traits = Traits(draft.view.world)
    spare = list(line.members)
    places: list[str | None] = []
    for symbol in text:
        name = next((n for n in spare if traits.symbol(n) == symbol), None)
        if name is not None:
            spare.remove(name)
        places.append(name)
    taken = [(k, spare.pop(0)) for k, name in enumerate(places) if name is None and spare]
    kept = tuple(name for name in line.members if name not in spare)
    node = line.node.model_copy(update={"blocks": kept, "text": None, "longer": longer})
    draft.do(ChangeCondition(at=line.path, to=node), request.span)
    for name in spare:
        draft.do(RemoveAsset(name=name), request.span)
    model = kept[0]
    if taken:
        blocks = draft.view.world.blocks
        new = {n: blocks[n].model_copy(update={"label": text[k], "labels": None}) for k, n in taken}
        renamed = exchange(draft, new, request.span)
        for k, name in taken:
            places[k] = renamed[name]
        model = renamed.get(model, model)
    for k, place in enumerate(places):
        if place is None:
            places[k] = _cube(draft, text[k], model)
    final = tuple(name for name in places if name is not None)
    draft.do(ChangeCondition(at=line.path, to=node.model_copy(update={"blocks": final, "text": text})), request.span)
    draft.look_at(final)


def other_word(draft: Draft, request: Respell) -> None:
    """The only word of the task is another one."""
    lines = [line for line in draft.view.lines if isinstance(line.node, Spells)]
    if len(lines) != 1:
        told = "the task spells more than one word" if lines else "the task spells no word"
        raise draft.refusal("edit-unclear", told, request.span, "say it as an instruction of its own: spell CAT")
    node = lines[0].node
    assert isinstance(node, Spells)
    if node.word == request.word and not node.reverse:
        raise draft.refusal("nothing-to-do", "it spells this already", request.span)
    draft.note("structure", {"to": "word", "dims": []})
    respell(draft, lines[0], lines[0].members, request.word, request.span)


def _cube(draft: Draft, symbol: str, model: str) -> str:
    """The name of a new cube that shows a symbol and is otherwise like `model`."""
    (block,) = describe(draft, m.Traits(labels=(symbol,)), 1)
    world = draft.view.world
    block = block.model_copy(update={"color": world.blocks[model].color, "size": world.edge[model]})
    name = free_name(block, {asset.name for asset in draft.schema.assets})
    draft.do(AddAsset(asset=block.model_copy(update={"name": name})))
    return name


def carry_on(draft: Draft, request: Continue) -> None:
    """A line of consecutive letters or numbers goes on to the one that is named, at the end where it comes."""
    line = draft.view.main_line()
    traits = Traits(draft.view.world)
    shown = [traits.symbol(name) for name in line.members] if line is not None else []
    row = string.ascii_uppercase if request.upto.isalpha() else string.digits
    at = [row.find(symbol) if symbol else -1 for symbol in shown]
    steps = {b - a for a, b in pairwise(at)}
    if line is None or -1 in at or steps not in ({1}, {-1}) or isinstance(line.node, Equation):
        told, hint = "there are no letters or numbers here that go on so", "name the blocks to add, and where they go"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    target = row.index(request.upto)
    if min(at) <= target <= max(at):
        raise draft.refusal("nothing-to-do", f"they go to {request.upto} already", request.span)
    draft.aim("EXTEND")
    draft.note("continue", request.upto)
    up = target > max(at)
    new = row[max(at) + 1 : target + 1] if up else row[target : min(at)][::-1]
    at_end = up == (steps == {1})
    for symbol in new:
        now = draft.view.line_of(line.members)
        assert now is not None
        insert(draft, now, len(now.members) if at_end else 0, _cube(draft, symbol, line.members[-1]), request.span)
