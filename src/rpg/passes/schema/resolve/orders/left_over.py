"""What is left of a structure when other parts were told: "the other two", "the other two rows", "all above"."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from rpg.blocks.figures import Cell
from rpg.language.meaning import Absolute, Amount, At, Noun, Places, Traits, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.places.either_end import at_an_end
from rpg.passes.schema.resolve.things.things import fits
from rpg.passes.schema.resolve.things.world import Scene, refuse

_WAYS = {"above": 1, "right": 1, "behind": 1, "below": -1, "left": -1, "front": -1}
ALONG = {"above": ("bottom", "top"), "right": ("left", "right"), "behind": ("front", "back")}
ALONG |= {"below": ALONG["above"], "left": ALONG["right"], "front": ALONG["behind"]}
"""Between which ends a line runs in which there is something on that side."""


def all_left(place: At | Places | None, left: Sequence[int], told: Collection[int]) -> None:
    """ "the other two": so many places have to be left. "everything above it": above all that were told, by levels."""
    several = place.several if isinstance(place, Places) and place.unit in ("", "block", "cell") else None
    if place is not None and several not in (None, len(left)):
        raise refuse("count-mismatch", f"{len(left)} places are left for these, but {several} are told", place.span,
                     f"say {len(left)}", places=len(left), named=several)  # fmt: skip
    if place is not None and not all(lies_beyond(place, here, told) for here in left):
        raise refuse("contradiction", "not all that is left is there", place.span, "say 'everything else'")


def lies_beyond(place: At | Places | None, here: int, told: Collection[int]) -> bool:
    """ "the two above it": whether a place is on that side of all that were told, if a side is named."""
    way = _WAYS.get(place.beyond or "", 0) if isinstance(place, Places) else 0
    return not way or all(way * (here - there) > 0 for there in told)


def not_so(item: Absolute, names: Collection[str], scene: Scene) -> Absolute:
    """ "(Three red and two blue blocks in one tower,) no red one at the bottom": a blue one, where all others are."""
    theme = item.theme
    color = theme.traits.colors if isinstance(theme, Noun) and theme.det == "no" and theme.part_of is None else ()
    if not isinstance(theme, Noun) or len(color) != 1 or theme.traits != Traits(colors=color):
        return item
    shown = {(t.color, t.label) for t in (scene.things[n] for n in names)}
    others = [x for x in shown if x[0] != color[0]]
    if len(others) == len(shown):
        raise refuse("misplaced", f"none of these is {color[0]}", item.span, "leave it out")
    look, label = others[0] if len(others) == 1 else (None, None)
    if look is None or label is not None:
        raise refuse("ambiguous", "it is not said which of the others is there", item.span, "say what it looks like")
    place = item.adjuncts[0]
    if isinstance(place, At | Places) and at_an_end(place):  # at neither of them
        place = Places(side="ends", unit="block", span=place.span)
    one = Amount(1, 1) if isinstance(place, At) else None
    other = Noun(head="any", det="a" if one else "bare", amount=one, traits=Traits(colors=(look,)), span=theme.span)
    return replace(item, theme=other, adjuncts=(place,))


def lines_left(place: Places, left: Sequence[Cell], told: Sequence[Cell], stands: bool) -> None:
    """ "the other two rows": so many have to be left, and nothing told of any of them."""
    unit = "layer" if stands and place.unit == "row" else place.unit
    field = {"row": "row", "column": "column", "layer": "level"}.get(unit)
    if field is None:
        return
    here, there = ({getattr(cell, field) for cell in cells} for cells in (left, told))
    if here & there or place.several not in (None, len(here)):
        raise refuse("count-mismatch", f"{len(here - there)} {place.unit}s are left for this", place.span,
                     "say 'everything else'")  # fmt: skip


def one_or_all(spec: Spec, names: tuple[str, ...], scene: Scene) -> None:
    """ "Two green and two pink blocks in a row, green first", "large first": one of them at that end, or all? All of
    them where all blocks are told of, "green on the left and pink on the right"."""
    if spec.orders or spec.patterns:  # "alternating, red at the bottom"
        return
    bare: list[tuple[Absolute, Noun]] = []
    for item in spec.absolutes:
        theme, place = item.theme, item.adjuncts[0] if len(item.adjuncts) == 1 else None
        plain = isinstance(place, At) and place.side != "next" and isinstance(theme, Noun) and theme.det == "bare"
        looks = isinstance(theme, Noun) and (theme.traits.colors or theme.traits.size or theme.traits.edge)
        if plain and isinstance(theme, Noun) and looks and not (theme.amount or theme.plural):
            bare.append((item, theme))
    lots = [tuple(n for n in names if fits(scene.things[n], theme.traits)) for _, theme in bare]
    told = sorted(name for lot in lots for name in lot)
    for (item, theme), lot in zip(bare, lots, strict=True):
        if len(lot) <= sum(other.traits == theme.traits for _, other in bare) or len(lot) == len(names):
            continue
        if told != sorted(names):
            raise refuse("ambiguous", "one of these blocks there, or all of them?", theme.span,
                         f"say 'a {_look(theme)} one', or 'the {_look(theme)} ones'")  # fmt: skip
        all_ = replace(theme, det="the", plural=True, amount=Amount(len(lot), len(lot)))
        spec.absolutes[spec.absolutes.index(item)] = replace(item, theme=all_)


def _look(noun: Noun) -> str:
    return noun.traits.colors[0] if noun.traits.colors else noun.traits.size or "large"


def all_like_base(
    item: Absolute, place: At | Places, base: Collection[str], names: Collection[str], scene: Scene
) -> None:
    """ "A pyramid with a base of three blue blocks": nobody who wants other blocks above them leaves these out."""
    below = [scene.things[n] for n in base]
    others = [scene.things[n] for n in names if n not in base]
    plain = all((t.color, t.label, t.kind, t.size) == (None, None, None, None) for t in others)
    whole = place.side == "bottom" and isinstance(item.theme, Noun) and item.theme.head == "block"
    if not whole or not plain or any(t.label or not t.color for t in below):
        raise refuse("ambiguous", "the base alone or the whole pyramid could look like this", item.span,
                     "say how the other blocks look")  # fmt: skip
    for thing in others:
        thing.color = below[0].color
    scene.assume("the whole pyramid looks like its base")
