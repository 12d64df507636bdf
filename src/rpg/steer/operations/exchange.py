"""Other looks for objects that stay what they are: their names follow, and the words that they spell."""

from __future__ import annotations

from collections.abc import Mapping

from rpg.blocks.traits import Traits
from rpg.core.diagnostics import Span
from rpg.ir.assets import EDGE, Asset, GoalPatch, SemanticCube
from rpg.ir.edits import ChangeCondition, Exchange, ReplaceAssets, SetField
from rpg.ir.relations import Facing
from rpg.ir.structures import Equation, GroupBy, Spells, Towers
from rpg.steer.draft import Draft
from rpg.steer.operations.make import free_name


def exchange(draft: Draft, new: Mapping[str, Asset], span: Span | None) -> dict[str, str]:
    """Give objects their new looks, and the names that fit them; words on cubes follow. Old name -> new name."""
    same = {name for name, asset in new.items() if _same_words(draft, name, asset)}
    taken = {asset.name for asset in draft.schema.assets} - set(new) | same
    exchanges: list[Exchange] = []
    names: dict[str, str] = {}
    for name, asset in new.items():
        called = name if name in same else _called(asset, taken)
        taken.add(called)
        names[name] = called
        exchanges.append(Exchange(name=name, asset=asset.model_copy(update={"name": called})))
    draft.do(ReplaceAssets(exchanges=tuple(exchanges)), span)
    draft.look_at(tuple(dict.fromkeys([*(names.get(n, n) for n in draft.focus if n not in names), *names.values()])))
    _respell(draft)
    return names


def _same_words(draft: Draft, name: str, asset: Asset) -> bool:
    """Whether the old name still fits: the colour, symbol and size class are as they were."""
    old = draft.view.world.assets[name]
    return type(old) is type(asset) and _words(old) == _words(asset)


def _words(asset: Asset) -> tuple[object, ...]:
    if isinstance(asset, GoalPatch):
        return (asset.color,)
    size = (asset.size > EDGE) - (asset.size < EDGE)
    return (asset.label, asset.labels, size) if isinstance(asset, SemanticCube) else (asset.color, size)


def _called(asset: Asset, taken: set[str]) -> str:
    if not isinstance(asset, GoalPatch):
        return free_name(asset, taken)
    name, number = f"{asset.color}_patch", 2
    while name in taken:
        name, number = f"{asset.color}_patch_{number}", number + 1
    return name


def _respell(draft: Draft) -> None:
    """Words and equations read what their cubes show now."""
    traits = Traits(draft.view.world)
    for line in draft.view.lines:
        node = line.node
        if not isinstance(node, Equation) or node.text is None:
            continue
        if sorted(node.text) != sorted(traits.symbol(name) for name in node.blocks):
            draft.do(SetField(at=line.path, field="text", value=None))
    _regroup(draft, traits)
    for path, atom in draft.view.atoms:
        block = draft.view.world.blocks.get(atom.block) if isinstance(atom, Facing) and atom.label else None
        if isinstance(block, SemanticCube) and block.label and block.label != getattr(atom, "label", None):
            draft.do(SetField(at=path, field="label", value=block.label))
        if isinstance(atom, Spells) and sorted(atom.word) != sorted(traits.symbol(n) for n in atom.blocks):
            word = "".join(traits.symbol(name) for name in atom.blocks)
            draft.do(SetField(at=path, field="word", value=word))


def _regroup(draft: Draft, traits: Traits) -> None:
    """Blocks that are sorted by what they look like go over to the group that they fit now."""
    for path, atom in draft.view.atoms:
        alike = isinstance(atom, Towers) and len({traits.of(name, atom.each or "color") for name in atom.blocks}) == 1
        if isinstance(atom, Towers) and atom.separate and alike:
            draft.do(ChangeCondition(at=path, to=atom.model_copy(update={"each": None, "separate": False})))
        if not isinstance(atom, GroupBy) or atom.by is None or atom.outliers:
            continue
        found: dict[object, list[str]] = {}
        for group in atom.groups:
            for name in group:
                found.setdefault(traits.of(name, atom.by), []).append(name)
        groups = tuple(tuple(group) for group in found.values())
        if len(groups) == 1 and len(atom.groups) > 1:
            draft.do(SetField(at=path, field="by", value=None))
        elif None not in found and set(groups) != set(atom.groups):
            draft.do(ChangeCondition(at=path, to=atom.model_copy(update={"groups": groups})))
