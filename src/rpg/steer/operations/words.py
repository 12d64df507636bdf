"""Words and equations: other symbols in the same row, and the same symbols up a tower instead of along a row."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.blocks.traits import Traits
from rpg.core.diagnostics import Span
from rpg.ir.assets import SemanticCube
from rpg.ir.edits import AddAsset, ChangeCondition, RemoveAsset, SetField, SetGoal
from rpg.ir.structures import Equation, Spells
from rpg.ir.walk import transform
from rpg.steer.draft import Draft
from rpg.steer.operations.count import like
from rpg.steer.operations.exchange import exchange
from rpg.steer.operations.kinds import listed
from rpg.steer.operations.lines import of_all
from rpg.steer.operations.make import new_assets
from rpg.steer.requests.language import m
from rpg.steer.view import Line

ALONG = {"stack": "stack", "row": "row", "line": "row"}
"""What a word or an equation runs along when it is made a tower or a row."""


def plain(wanted: m.Structure) -> bool:
    """Whether a phrase names a structure and says nothing of it."""
    return not (wanted.details or wanted.sizes or wanted.members or wanted.plural or wanted.dims)


def run_along(draft: Draft, line: Line, along: str, span: Span) -> None:
    """The same symbols up a tower, read from the top, or along a row."""
    assert isinstance(line.node, Spells | Equation)
    if line.node.along == along:
        raise draft.refusal("nothing-to-do", f"it runs along a {along} already", span)
    draft.aim("PIVOT")
    draft.do(SetField(at=line.path, field="along", value=along), span)


def respell(draft: Draft, line: Line | None, names: Sequence[str], word: str, span: Span) -> None:
    """Another word."""
    if line is None or not isinstance(line.node, Spells):
        draft.aim("PIVOT")
        _spell_afresh(draft, names, word, span)
        return
    _other_letters(draft, line, line.node.model_copy(update={"word": word, "reverse": False}), span)


def _other_letters(draft: Draft, line: Line, node: Spells, span: Span) -> None:
    """Cubes with letters that are shared stay, others are relabelled, missing ones are added, spare ones leave."""
    symbols = node.word
    draft.aim("MODIFY")
    places, spare = _shared(draft, line, symbols)
    changed = {k: spare.pop(0) for k, name in enumerate(places) if name is None and spare}
    left = tuple(name for name in line.members if name not in spare)
    body = _body(draft, left)
    draft.do(ChangeCondition(at=line.path, to=node.model_copy(update={"blocks": left})), span)
    for name in spare:
        draft.do(RemoveAsset(name=name), span)
    if changed:
        world = draft.view.world
        blocks = {
            n: world.blocks[n].model_copy(update={"label": symbols[k], "labels": None}) for k, n in changed.items()
        }
        renamed = exchange(draft, blocks, span)
        for k, name in changed.items():
            places[k] = renamed[name]
    new = [k for k, name in enumerate(places) if name is None]
    added: tuple[str, ...] = ()
    if new:
        traits = m.Traits(labels=tuple(symbols[k] for k in new), colors=body)
        added = draft.add(new_assets(draft, m.Noun(head="block", plural=True, traits=traits, span=span)), span)
        for k, name in zip(new, added, strict=True):
            places[k] = name
    final = tuple(name for name in places if name is not None)
    draft.do(ChangeCondition(at=line.path, to=node.model_copy(update={"blocks": final})), span)
    old, more = [name for name in final if name not in added], tuple(name for name in final if name in added)
    goal = transform(draft.schema.goal, lambda part: of_all(part, old, more)) if more else draft.schema.goal
    if goal != draft.schema.goal:
        draft.do(SetGoal(goal=goal), span)
    draft.look_at(final)


def _shared(draft: Draft, line: Line, symbols: str) -> tuple[list[str | None], list[str]]:
    """For each symbol a cube that shows it already, where there is one; and the cubes that are left over."""
    traits, spare = Traits(draft.view.world), list(line.members)
    places: list[str | None] = []
    for symbol in symbols:
        name = next((n for n in spare if traits.symbol(n) == symbol), None)
        if name is not None:
            spare.remove(name)
        places.append(name)
    return places, spare


def _body(draft: Draft, names: Sequence[str]) -> tuple[str, ...]:
    """The colour that cubes share and ivory ones do not have."""
    colors = {draft.view.world.blocks[name].color for name in names if name in draft.view.world.blocks}
    return tuple(colors) if len(colors) == 1 and colors != {"ivory"} else ()


def _spell_afresh(draft: Draft, names: Sequence[str], word: str, span: Span) -> None:
    """Blocks that spelt nothing become the letters of a word."""
    blocks = [name for name in listed(draft, names) if name in draft.view.world.blocks]
    for name in blocks[len(word) :]:
        draft.do(SetGoal(goal=Spells(blocks=tuple(blocks[: len(word)]), word=word)), span)
        draft.do(RemoveAsset(name=name), span)
    blocks = blocks[: len(word)]
    for asset in like(draft, blocks, len(word) - len(blocks)):
        draft.do(AddAsset(asset=asset), span)
        blocks.append(asset.name)
    draft.do(SetGoal(goal=Spells(blocks=tuple(blocks), word=word)), span)
    world = draft.view.world
    exchange(
        draft,
        {n: SemanticCube(name=n, label=letter, size=world.edge[n]) for n, letter in zip(blocks, word, strict=True)},
        span,
    )
