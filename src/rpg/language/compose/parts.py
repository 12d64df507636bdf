"""Parts of figures: their ends, rows, steps, and the blocks counted from a side."""

from __future__ import annotations

from rpg.language.compose.items import PARTS, SYMBOL_KINDS, shows
from rpg.language.compose.places_of import line_of, places
from rpg.language.compose.scene import Figure, Ref, Resolve, Scene, Unclear
from rpg.language.compose.syntax import ALL, Noun, Pronoun

_SIDES = frozenset({"left", "right"})

_READ = frozenset({"word", "equation"})
"""What is read from the left."""


def has_first(figure: Figure) -> bool:
    """Whether its blocks are read one after the other, so that one is the first and one the last."""
    listed = figure.told and figure.sided and figure.kind in {"row", "line"}
    return figure.kind in _READ or figure.in_order or listed


def part(scene: Scene, noun: Noun, resolve: Resolve) -> Ref:
    """The blocks of a figure at some of its places."""
    figures = whole_figures(scene, noun, resolve)
    unit = "step" if noun.noun == "one" and figures[0].kind == "staircase" else noun.noun
    said = (*noun.ranks, *((unit,) if unit in PARTS | {"row", "column"} else ()))
    if has_first(figures[0]):
        first, last = ("bottom", "top") if figures[0].kind == "tower" else ("left", "right")
        said = tuple({"last": last, "first": first}.get(rank, rank) for rank in said) or ((first,) if noun.nth else ())
    ids = []
    for figure in figures:
        count = noun.count or -noun.many
        if noun.many and not noun.count and said == ("middle",) and not figure.size:
            count = len(figure.blocks) - 2  # all but the outer ones
        if said == ("corner",) and figure.size == (2, 2) and noun.of is None:
            raise Unclear  # of what these are the corners
        at = places(figure, said, noun.nth, count)
        if scene.may_change(figure) and scene.subject is not None:
            rest = {scene.blocks[n].look for place, n in enumerate(figure.blocks) if place not in at}
            if figure.kind not in {"row", "line"} or any(scene.blocks[figure.blocks[n]].look in rest for n in at):
                raise Unclear  # what is put there is on the whole figure, or on what is left of it
        if noun.det == "other":
            if scene.place is None or scene.place[0] is not figure:
                raise Unclear
            at = [n for n in at if n != scene.place[1]]
            if len(at) != 1:
                raise Unclear
        found = [scene.at(figure, n) for n in at]
        scene.place = (figure, at[0]) if len(at) == 1 else None
        figure.sided |= figure.kind in _READ or (bool(_SIDES & set(said)) and figure.kind in {"row", "line"})
        ids += found
    if noun.color and any(scene.blocks[n].color != noun.color for n in ids):
        raise Unclear
    if noun.many and not noun.count and len(ids) == len(figures) and noun.noun in {"one", "block"} and noun.ranks:
        raise Unclear  # "the lower ones" are as many as are left
    whole = unit in {"row", "column", "layer", "side", "step"}
    if noun.noun in SYMBOL_KINDS and not all(shows(scene.blocks[n].label, noun.noun) for n in ids):
        raise Unclear
    if not noun.many and noun.det not in ALL and not noun.count and len(ids) > len(figures) and not whole:
        raise Unclear
    if noun.count and noun.count != len(ids):
        if noun.det in {"the", *ALL} or noun.bound or noun.count != 1:
            raise Unclear
        turned = figures[0].kind in {"row", "line"}  # either way round: one of the ends, whichever
        ids = [ids[0 if turned else scene.choose(len(ids))]]
        if not scene.alike(figures[0].blocks) or figures[0].sided:
            raise Unclear
    return Ref("block", ids, each=noun.det == "each")


def whole_figures(scene: Scene, noun: Noun, resolve: Resolve) -> list[Figure]:
    """The figures that a part is of: those said, or the one that was spoken of last."""
    if noun.of is not None and noun.of != Pronoun("it"):
        ref = resolve(scene, noun.of)
        if ref.kind == "figure":
            return [scene.figures[n] for n in ref.ids]
        held = scene.figure_of(ref.ids[0]) if ref.kind == "block" else None
        if held is None or not set(ref.ids) <= set(held.blocks):
            raise Unclear
        if len(held.blocks) == len(ref.ids):
            return [held]
        if isinstance(noun.of, Noun) and noun.of.noun in {"row", "column", "layer", "step"}:
            return [line_of(held, noun.of.noun, ref.ids)]
        raise Unclear
    if noun.color and (own := _of_color(scene, noun.color)) is not None:
        return [own]
    for spoken in (scene.here, scene.before):
        found = {n for ref in spoken if ref.kind == "figure" for n in ref.ids} - {*scene.placed}
        if len(found) == 1:
            scene.mention(Ref("figure", list(found)))
            return [scene.figures[found.pop()]]
        if found:
            raise Unclear
    if len(scene.figures) == 1:
        return [scene.figures[0]]
    raise Unclear


def _of_color(scene: Scene, color: str) -> Figure | None:
    """ "The middle red block": of several figures, the one that all red blocks are of."""
    own = {n for n, block in enumerate(scene.blocks) if block.color == color}
    return next((f for f in scene.figures if set(f.blocks) == own and not f.implied and len(scene.figures) > 1), None)


def within(scene: Scene) -> bool:
    """Whether a row that is spoken of is one of a grid, a wall, a cube or a pyramid."""
    return bool(scene.figures) and scene.figures[-1].kind in {"grid", "wall", "cube", "pyramid"}
