"""What alternates along a line: colours, kinds, vowels and consonants, odd and even digits."""

from __future__ import annotations

from rpg.ir.order import Attribute
from rpg.language.lexicon import RAINBOW
from rpg.language.meaning import Noun, OrderBy, Traits
from rpg.passes.schema.resolve.things.things import fits
from rpg.passes.schema.resolve.things.world import Scene, Thing, refuse

_SORTS: dict[frozenset[str | None], Attribute] = {
    frozenset({"odd", "even"}): "parity",
    frozenset({"vowel", "consonant"}): "vowel",
    frozenset({"letter", "digit"}): "kind",
}
"""Sorts of symbols that may take turns, and what tells them apart."""


def alternating(order: OrderBy, things: list[Thing], scene: Scene) -> Attribute:
    """What an alternation or a mirrored line is told apart by; colours are given to blocks that have none."""
    if order.items and order.by == "alternating":
        sorts = [x.traits for x in order.items if isinstance(x, Noun) and not x.traits.colors]
        told = _SORTS.get(frozenset(x.quality or x.kind for x in sorts)) if len(sorts) == len(order.items) else None
        if told is not None:
            _of_both_sorts(order, things, sorts)
            return told
        _alternate(order, things)
        return "color"
    if (attribute := _telling(things)) == "color":
        _two_colors(things, order.by, scene)
    return attribute


def _of_both_sorts(order: OrderBy, things: list[Thing], sorts: list[Traits]) -> None:
    lots = [[thing for thing in things if fits(thing, sort)] for sort in sorts]
    if not all(lots) or sum(map(len, lots)) != len(things):
        raise refuse("contradiction", "the blocks are not of these two sorts", order.span, "name blocks of both sorts")


def _alternate(order: OrderBy, things: list[Thing]) -> None:
    """Two colours said with the alternation."""
    colors = [i.traits.colors[0] for i in order.items if isinstance(i, Noun) and len(i.traits.colors) == 1]
    if len(colors) != 2 or len(order.items) != 2:
        raise refuse("misplaced", "an alternation is of two colours", order.span, "say 'alternating red and blue'")
    for index, thing in enumerate(things):
        if thing.color is None and thing.kind is None:
            thing.color = colors[index % 2]
    if {t.color for t in things} != set(colors):
        raise refuse("contradiction", "the blocks have other colours", order.span, "name two colours that they have")


def _telling(things: list[Thing]) -> Attribute:
    """What tells blocks apart that take turns: their colours; of those in one colour, their kinds or their symbols."""
    if len({t.color for t in things}) > 1 or not any(t.kind for t in things):
        return "color"
    if len({t.kind for t in things}) == 2:
        return "kind"
    labels = {t.label for t in things}
    return "label" if None not in labels and 1 < len(labels) < len(things) else "color"


def _two_colors(things: list[Thing], by: str, scene: Scene) -> None:
    """Colours for an alternation or a mirrored line where none were said."""
    if any(t.color or t.label for t in things) or not things:
        return
    half = (len(things) + 1) // 2
    for index, thing in enumerate(things):
        place = index % 2 if by == "alternating" else min(index, len(things) - 1 - index) % max(1, half)
        thing.color = (
            RAINBOW[0]
            if by == "alternating" and place == 0
            else "blue"
            if by == "alternating"
            else RAINBOW[place % len(RAINBOW)]
        )
    scene.assume(
        "the colours are not said: red and blue"
        if by == "alternating"
        else "the colours are not said: pairs of equal colours"
    )
