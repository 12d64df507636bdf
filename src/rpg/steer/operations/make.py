"""New objects from a description: what it says, and what the task suggests where it says nothing."""

from __future__ import annotations

import string
from collections.abc import Iterable, Sequence

from rpg.blocks.nouns import SIGNS
from rpg.blocks.traits import GRADIENT, symbol_of
from rpg.ir.assets import EDGE, Asset, Block, ColoredCube, GoalPatch, SemanticCube
from rpg.steer.draft import Draft
from rpg.steer.operations.guard import check_new
from rpg.steer.requests.language import lexicon, m

PALETTE = (*GRADIENT, "brown", "black", "gray", "white")
DIGITS = "1234567890"
SPELT = dict(SIGNS.items())


def new_assets(draft: Draft, phrase: m.Meaning, count: int | None = None) -> list[Asset]:
    """The objects that `phrase` brings in; `count` where it does not say how many."""
    if isinstance(phrase, m.Coord):
        if phrase.op != "and":
            told, hint = "this leaves open which blocks are meant", "name one of them, or join them with 'and'"
            raise draft.refusal("ambiguous-object", told, phrase.span, hint)
        found: list[Asset] = []
        for item in phrase.items:
            found += _named(draft, item, count, found)
        return found
    return _named(draft, phrase, count, [])


def _named(draft: Draft, phrase: m.Meaning, count: int | None, before: Sequence[Asset]) -> list[Asset]:
    if not isinstance(phrase, m.Noun):
        raise draft.refusal(
            "edit-unclear", "this does not describe a block or a patch", phrase.span, "say a block's colour or letter"
        )
    check_new(phrase)
    listed = phrase.traits.labels or len(phrase.traits.colors) > 1
    if phrase.plural and phrase.amount is None and count is None and phrase.traits.extra and not listed:
        count = 2
        draft.assume(f"the number of distractors is not said: {count}")
    if phrase.plural and phrase.amount is None and count is None and not listed:
        told, hint = "it is not said how many these are", "say how many: add two red blocks"
        raise draft.refusal("edit-unclear", told, phrase.span, hint)
    taken = {asset.name for asset in (*draft.schema.assets, *before)}
    number = _number(phrase, count)
    if phrase.head == "patch":
        return _patches(phrase, number, taken)
    blocks = describe(
        draft, phrase.traits, number, like=phrase.det in ("another", "some") or phrase.head == "any", before=before
    )
    named: list[Asset] = []
    for block in blocks:
        name = free_name(block, taken)
        taken.add(name)
        named.append(block.model_copy(update={"name": name}))
    return named


def _number(phrase: m.Noun, count: int | None) -> int:
    if phrase.amount is not None:
        return phrase.amount.low
    listed = max(len(phrase.traits.colors), len(phrase.traits.labels))
    return listed if listed > 1 else (count or 1) if phrase.plural else 1


def describe(
    draft: Draft, traits: m.Traits, number: int, *, like: bool = False, before: Iterable[Asset] = ()
) -> list[Block]:
    """`number` blocks without names yet. `like`: what is not said is as with the blocks mentioned last."""
    edge = traits.edge or {"big": lexicon.BIG_EDGE, "small": lexicon.SMALL_EDGE}.get(traits.size or "", EDGE)
    kind = traits.kind if traits.kind in ("letter", "digit", "symbol") else None
    if traits.labels or kind:
        labels = _cycled(traits.labels, number) if traits.labels else unused_labels(draft, number, kind == "digit")
        colors = _cycled(traits.colors, number) or ["ivory"] * number
        return [
            SemanticCube.model_validate({"name": "new", "label": label, "color": c, "size": edge})
            for label, c in zip(labels, colors, strict=True)
        ]
    model = _model(draft, like) if not traits.colors and traits.scheme is None and not traits.extra else None
    if model is not None:
        return _alike(draft, model, number, traits.edge or (edge if traits.size else model.size))
    colors = _cycled(traits.colors, number) or unused_colors(draft, number, before)
    if not traits.colors:
        draft.assume(f"colours that the task does not have yet: {', '.join(colors)}")
    return [ColoredCube.model_validate({"name": "new", "color": color, "size": edge}) for color in colors]


def _model(draft: Draft, like: bool) -> Block | None:
    """The block whose looks a new one takes: the one mentioned last, or any of a task of look-alikes."""
    view = draft.view
    recent = [view.world.blocks[name] for name in view.focus if name in view.world.blocks]
    if like and recent:
        return recent[-1]
    looks = {view.world.look[name] for name in view.busy}
    return view.world.blocks[view.busy[0]] if len(looks) == 1 and len(view.busy) > 1 else None


def _alike(draft: Draft, model: Block, number: int, edge: float) -> list[Block]:
    if isinstance(model, SemanticCube):
        labels = unused_labels(draft, number, model.label.isdigit())
        return [SemanticCube(name="new", label=label, color=model.color, size=edge) for label in labels]
    return [ColoredCube(name="new", color=model.color, size=edge)] * number


def unused_labels(draft: Draft, number: int, digits: bool) -> list[str]:
    """Symbols that no block shows yet, in order; used ones again where there are no others."""
    used = {symbol_of(draft.view.world, name) for name in draft.view.world.blocks}
    row = DIGITS if digits else string.ascii_uppercase
    free = [symbol for symbol in row if symbol not in used]
    return _cycled((*free, *(symbol for symbol in row if symbol in used)), number)


def unused_colors(draft: Draft, number: int, before: Iterable[Asset] = ()) -> list[str]:
    """Palette colours that nothing in the task has yet, in rainbow order; used ones again where there are no others."""
    used = {asset.color for asset in (*draft.schema.assets, *before)}
    free = [color for color in PALETTE if color not in used]
    return _cycled((*free, *(color for color in PALETTE if color in used)), number)


def _patches(phrase: m.Noun, number: int, taken: set[str]) -> list[Asset]:
    traits = phrase.traits
    found: list[Asset] = []
    for color in _cycled(traits.colors, number) or ["green"] * number:
        size = traits.extent or ((0.2, 0.1) if traits.long else (0.1, 0.1))
        shape = (
            traits.shape
            if traits.shape in ("square", "rectangle", "circle")
            else "rectangle"
            if traits.long
            else "square"
        )
        name = _free(f"{color}_patch" if traits.colors else "patch", taken)
        taken.add(name)
        found.append(GoalPatch.model_validate({"name": name, "color": color, "shape": shape, "size": size}))
    return found


def free_name(block: Block, taken: Iterable[str]) -> str:
    """What a block is called by its looks, made unique."""
    size = "" if block.size == EDGE else "big_" if block.size > EDGE else "small_"
    if isinstance(block, SemanticCube):
        symbol = block.label or block.symbol("top")
        return _free(f"{size}{SPELT.get(symbol, symbol)}_block", set(taken))
    return _free(f"{size}{block.color}_block", set(taken))


def named(draft: Draft, blocks: Sequence[Block]) -> list[Asset]:
    """Blocks with free names."""
    taken = {asset.name for asset in draft.schema.assets}
    found: list[Asset] = []
    for block in blocks:
        name = free_name(block, taken)
        taken.add(name)
        found.append(block.model_copy(update={"name": name}))
    return found


def _free(name: str, taken: set[str]) -> str:
    candidate, number = name, 2
    while candidate in taken:
        candidate, number = f"{name}_{number}", number + 1
    return candidate


def _cycled(values: Sequence[str], number: int) -> list[str]:
    return [values[index % len(values)] for index in range(number)] if values else []
