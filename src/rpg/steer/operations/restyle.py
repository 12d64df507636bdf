"""Other looks for the same blocks: colour, symbol, size; and other blocks in the same places."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

from rpg.blocks.traits import Traits
from rpg.core.diagnostics import Span
from rpg.ir.assets import EDGE, Asset, Block, ColoredCube, GoalPatch, SemanticCube
from rpg.steer.draft import Draft
from rpg.steer.matching import matches
from rpg.steer.operations.exchange import exchange
from rpg.steer.operations.grow import grow
from rpg.steer.operations.guard import check_new
from rpg.steer.operations.kinds import convert, listed, mix
from rpg.steer.operations.lines import by_place, insert, pin
from rpg.steer.operations.make import describe, free_name, new_assets, unused_colors
from rpg.steer.refer import resolve
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import lexicon, m


def restyle(draft: Draft, request: r.Restyle) -> None:
    """Other colours, symbols or sizes: "make the red block green", "make them bigger", "change the A to a B"."""
    found = resolve(draft.view, request.theme) if request.theme is not None else None
    if request.scale is not None and found is not None and found.whole and _as_a_whole(request.theme):
        told, hint = "this may be larger blocks or more of them", "say 'larger blocks', or how many it should have"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    names = found.names if found is not None else draft.view.busy
    names = tuple(name for name in names if name not in draft.kept)
    traits = request.traits
    if not all(matches(draft.view, name, request.former) for name in names):
        raise draft.refusal("no-such-object", "it does not look like that", request.span, "say only what it should be")
    several = len(names) > 1 and len(traits.labels) == 1
    if several and isinstance(request.theme, m.Pronoun) and request.theme.word == "it":
        told, hint = f"'it' could be any of {len(names)} blocks", "say which block, or 'them'"
        raise draft.refusal("ambiguous-object", told, request.span, hint)
    if not request.plainly and (several or not all(Traits(draft.view.world).symbol(name) for name in names)):
        told, hint = "this may be how many blocks or what they show", "say 'five blocks' or 'the number 5'"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    if (traits.shape or traits.long) and not set(names) <= set(draft.view.world.patches):
        raise draft.refusal("edit-unclear", "only a patch has a shape", request.span, "say a colour or a size")
    if traits.kind in ("letter", "digit", "plain", "symbol") and not traits.labels and not traits.colors:
        convert(draft, names, traits.kind, request.span)
        return
    if traits.scheme == "some":
        convert(draft, names, "plain", request.span)
        return
    draft.aim("TWEAK")
    if by_place(request.theme):
        pin(draft, names, request.span)
    new: dict[str, Asset] = {}
    colors = _colors(draft, listed(draft, names), traits, request.span)
    labels = _labels(draft, names, traits, request.span)
    for index, name in enumerate(listed(draft, names)):
        asset = draft.view.world.assets[name]
        if isinstance(asset, GoalPatch):
            new[name] = _patch(asset, traits, request.scale, colors[index] if colors else None)
        else:
            new[name] = _block(
                asset, traits, request.scale, colors[index] if colors else None, labels[index] if labels else None
            )
    if any(type(new[name]) is not type(draft.view.world.assets[name]) for name in new):
        draft.aim("MODIFY")
    exchange(draft, new, request.span)
    draft.note("restyle", {name: _said(request) for name in names})


def _as_a_whole(theme: m.Meaning | None) -> bool:
    """Whether a phrase is about a structure as one thing: "the circle", "it", but not "them"."""
    return isinstance(theme, m.Structure) or (isinstance(theme, m.Pronoun) and theme.word == "it")


def _said(request: r.Restyle) -> dict[str, object]:
    said: dict[str, object] = {
        "color": list(request.traits.colors),
        "label": list(request.traits.labels),
        "edge_m": request.traits.edge,
    }
    return {key: value for key, value in {**said, "scale": request.scale, "size": request.traits.size}.items() if value}


def _colors(draft: Draft, names: Sequence[str], traits: m.Traits, span: Span) -> list[str] | None:
    """A colour for each of `names`; None where colours stay."""
    if traits.colors:
        if len(traits.colors) not in (1, len(names)) and not traits.either:
            raise draft.refusal(
                "edit-unclear",
                f"{len(traits.colors)} colours do not say which of {len(names)} blocks gets which",
                span,
                "give one colour, or one for each",
            )
        return [traits.colors[index % len(traits.colors)] for index in range(len(names))]
    if traits.scheme in ("different", "mixed"):
        return unused_colors(draft, len(names))
    if traits.scheme == "same":
        return [draft.view.world.assets[names[0]].color] * len(names)
    return None


def _labels(draft: Draft, names: Sequence[str], traits: m.Traits, span: Span) -> list[str] | None:
    if not traits.labels:
        return None
    if len(traits.labels) not in (1, len(names)):
        raise draft.refusal(
            "edit-unclear",
            f"{len(traits.labels)} symbols do not say which of {len(names)} blocks gets which",
            span,
            "give one symbol for each",
        )
    return [traits.labels[index % len(traits.labels)] for index in range(len(names))]


def _block(block: Block, traits: m.Traits, scale: float | None, color: str | None, label: str | None) -> Block:
    size = block.size
    if traits.edge is not None:
        size = traits.edge
    elif traits.size:
        size = {"big": lexicon.BIG_EDGE, "small": lexicon.SMALL_EDGE}.get(traits.size, EDGE)
    elif scale is not None:
        size = round(block.size * scale, 4)
    if label is not None:
        return SemanticCube.model_validate(
            {
                "name": block.name,
                "label": label,
                "color": color or (block.color if isinstance(block, SemanticCube) else "ivory"),
                "size": size,
            }
        )
    return type(block).model_validate({**block.model_dump(), "color": color or block.color, "size": size})


def _patch(patch: GoalPatch, traits: m.Traits, scale: float | None, color: str | None) -> GoalPatch:
    width, depth = patch.size
    shape = traits.shape or patch.shape
    if traits.edge is not None:
        width = depth = traits.edge
    elif traits.long:
        width, depth, shape = max(2 * depth, width), depth, "rectangle"
    elif traits.size or scale is not None:
        factor = scale or {"big": 1.5, "small": 0.75}.get(traits.size or "", 1.0)
        width, depth = round(width * factor, 4), round(depth * factor, 4)
    return GoalPatch.model_validate(
        {**patch.model_dump(), "size": (width, depth), "shape": shape, "color": color or patch.color}
    )


def replace(draft: Draft, request: r.Replace) -> None:
    """Phrases such as "replace the green cube with a yellow one", "letters instead of colours"."""
    if _recounted(draft, request):
        return
    old = tuple(n for n in _old(draft, request) if n not in draft.kept)
    if by_place(request.old):
        pin(draft, old, request.span)
    if isinstance(request.new, m.Noun) and (_only_a_size(request.new) or _symbols_as_there(draft, old, request.new)):
        traits = dataclasses.replace(request.new.traits, kind=None)
        restyle(draft, r.Restyle(theme=request.old, traits=traits, span=request.span))
        return
    kinds = _kinds(request.new)
    if len(kinds) > 1:
        mix(draft, old, kinds, request.span)
        return
    if kinds and kinds[0] is not None and _generic(request.new):
        convert(draft, old, kinds[0], request.span)
        return
    draft.aim("MODIFY")
    new = request.new
    if isinstance(new, m.Noun) and (new.head == "patch" or all(name in draft.view.world.patches for name in old)):
        _replace_patches(draft, old, new, request.span)
    elif isinstance(new, m.Noun) and (_one_each(request) or (new.amount.low if new.amount else len(old)) == len(old)):
        _replace_each(draft, old, new, request.span)
    else:
        _replace_by_several(draft, old, request)


def _only_a_size(new: m.Noun) -> bool:
    """Phrases such as "use big cubes of 5 cm": the same blocks in another size."""
    traits = new.traits
    told = bool(traits.edge or traits.size) and traits == m.Traits(edge=traits.edge, size=traits.size)
    return told and new.plural and new.amount is None and new.head != "patch"


def _symbols_as_there(draft: Draft, old: Sequence[str], new: m.Noun) -> bool:
    """Phrases such as "with blue letters" where all are letters: these in another colour, not others."""
    traits, shown = new.traits, Traits(draft.view.world)
    if not set(old) <= set(draft.view.world.blocks):
        return False
    told = bool(traits.colors) and traits == m.Traits(colors=traits.colors, kind=traits.kind)
    symbols = [shown.symbol(name) for name in old]
    alike = all(symbol and (symbol.isalpha() or traits.kind != "letter") for symbol in symbols)
    alike = alike and all(symbol.isdigit() or traits.kind != "digit" for symbol in symbols)
    return told and traits.kind in ("letter", "digit", "symbol") and new.plural and new.amount is None and alike


def _one_each(request: r.Replace) -> bool:
    """Phrases such as "replace every letter with a red cube"."""
    old, new = request.old, request.new
    return isinstance(old, m.Noun) and old.det == "each" and isinstance(new, m.Noun) and new.det == "a"


def _recounted(draft: Draft, request: r.Replace) -> bool:
    """Phrases such as "make it four red blocks" where there are three: another number of those that are there."""
    new, world = request.new, draft.view.world
    pronoun = request.old is None or isinstance(request.old, m.Pronoun)
    if not pronoun or not isinstance(new, m.Noun) or new.amount is None or new.head == "patch" or new.det != "bare":
        return False
    alike = [name for name in draft.view.busy if matches(draft.view, name, new.traits)]
    others = [name for name in draft.view.busy if name not in alike]
    looks = {world.look[name] for name in others}
    single = len({world.look[name] for name in alike}) == 1
    if not single or len(alike) == new.amount.low or (len(alike) < 2 and others) or len(looks) == len(others) > 0:
        return False
    draft.aim("TWEAK")
    draft.note("count", {"amount": new.amount.low, "dims": [], "by": None})
    grow(draft, alike, new.amount.low, request.span)
    return True


def _replace_each(draft: Draft, old: Sequence[str], new: m.Noun, span: Span) -> None:
    """As many new blocks as old ones, of the old ones' sizes unless the request gives another."""
    check_new(new)
    _labels(draft, old, new.traits, span)
    if len(old) % max(1, len(new.traits.colors)):
        _colors(draft, old, new.traits, span)
    blocks = describe(draft, new.traits, len(old), like=new.head == "any")
    if not (new.traits.edge or new.traits.size):
        edges = [draft.view.world.edge[name] for name in listed(draft, old)]
        blocks = [block.model_copy(update={"size": edge}) for block, edge in zip(blocks, edges, strict=True)]
    draft.note("replace", exchange(draft, dict(zip(listed(draft, old), blocks, strict=True)), span))


def _old(draft: Draft, request: r.Replace) -> tuple[str, ...]:
    if request.old is not None:
        return resolve(draft.view, request.old).names
    if isinstance(request.new, m.Noun) and request.new.head == "patch":
        return tuple(draft.view.world.patches)
    line, figure = draft.view.main_line(), draft.view.main_figure()
    first = line.members if line else figure.members if figure else ()
    return (*first, *(name for name in draft.view.busy if name not in first))


def _kinds(new: m.Meaning) -> list[str | None]:
    """The kinds of block that a phrase lists: "letters, numbers, colours"."""
    items = new.items if isinstance(new, m.Coord) else (new,)
    found: list[str | None] = []
    for item in items:
        traits = item.traits if isinstance(item, m.Noun) else None
        found.append(
            None if traits is None else "plain" if traits.scheme in ("some",) and not traits.colors else traits.kind
        )
    return found if all(found) or len(found) == 1 else [None]


def _generic(new: m.Meaning) -> bool:
    """Whether a phrase names a kind of block and no certain colours or symbols."""
    if not isinstance(new, m.Noun):
        return False
    one = new.amount is not None and new.amount.low == 1 and new.det != "bare"
    return not new.traits.labels and not new.traits.colors and not one


def replace_head(wanted: m.Noun) -> m.Noun:
    """A phrase that stands for a patch, whatever its noun ("a yellow one")."""
    return dataclasses.replace(wanted, head="patch")


def _replace_patches(draft: Draft, old: Sequence[str], wanted: m.Noun, span: Span) -> None:
    check_new(replace_head(wanted))
    new: dict[str, Asset] = {}
    for name in old:
        patch = draft.view.world.patches.get(name)
        if patch is None:
            raise draft.refusal(
                "edit-unclear", "a block cannot be replaced by a patch", span, "remove the block, then add a patch"
            )
        new[name] = _patch(patch, wanted.traits, None, wanted.traits.colors[0] if wanted.traits.colors else None)
    exchange(draft, new, span)


def _replace_by_several(draft: Draft, old: Sequence[str], request: r.Replace) -> None:
    """One block gives way to several in the same place of its line."""
    line = draft.view.line_of(old)
    assets = [a for a in new_assets(draft, request.new) if isinstance(a, ColoredCube | SemanticCube)]
    if line is None or len(old) != 1 or not assets:
        raise draft.refusal(
            "edit-unclear",
            f"{len(old)} blocks cannot give way to {len(assets)} here",
            request.span,
            "replace as many blocks as you take away",
        )
    index = line.members.index(old[0])
    names = exchange(draft, {old[0]: assets[0]}, request.span)
    first = names[old[0]]
    more = draft.add(
        [a.model_copy(update={"name": free_name(a, {x.name for x in draft.schema.assets})}) for a in assets[1:]],
        request.span,
    )
    for offset, name in enumerate(more):
        now = draft.view.line_of((first,))
        assert now is not None
        insert(draft, now, index + 1 + offset, name, request.span)
    draft.note("replace", {old[0]: [first, *more]})
    draft.look_at((first, *more))
