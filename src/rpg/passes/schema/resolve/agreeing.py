"""Two things said of one order of blocks: whether they agree, and what the order then is."""

from __future__ import annotations

from itertools import pairwise

from rpg.ir.order import Order
from rpg.language.lexicon import RAINBOW
from rpg.passes.schema.resolve.world import Scene, Thing

OPPOSITE = {"left": "right", "front": "back", "bottom": "top"}
OPPOSITE |= {two: one for one, two in OPPOSITE.items()}
_SORTED = ("label", "number", "rainbow")


def key(order: Order, thing: Thing) -> float | str | None:
    """What an order compares."""
    if order.by == "rainbow":
        return RAINBOW.index(thing.color) if thing.color in RAINBOW else None
    return thing.label if order.by in ("number", "label") else None


def agreed(one: Order, two: Order, directed: bool, scene: Scene) -> Order | None:
    """The order that both a list and the name of an order say; None where they contradict each other.

    "In alphabetical order: D, B, A" lists what there is; "a rainbow row: red, green, blue" lists it in its order.
    `directed`: a side was said where the order begins.
    """
    given, other = (one, two) if one.by == "given" else (two, one)
    if given.by != "given" or other.by == "given":
        return None
    found = _sorted(given, other, directed, scene) if other.by in _SORTED else _patterned(given, other, scene)
    if found is not None and found.by != "given":
        forget_side(scene)
    return found


def _sorted(given: Order, other: Order, directed: bool, scene: Scene) -> Order | None:
    keys = [key(other, scene.things[n]) for rank in given.ranks for n in rank]
    if None in keys:
        return None
    up, down = keys == sorted(keys), keys == sorted(keys, reverse=True)  # type: ignore[type-var]
    forward, backward = (down, up) if other.descending else (up, down)
    if other.by != "rainbow":
        return None if directed and backward and not forward else other
    if not directed:
        return other if up or down else None
    other = other.model_copy(update={"first": given.first})
    if forward or other.descending:
        return other if forward else None
    return other.model_copy(update={"descending": True}) if backward else None


def _patterned(given: Order, other: Order, scene: Scene) -> Order | None:
    """ "an alternating row: three red, three blue" tells how many of each; a list of single ones how they stand."""
    if other.by not in ("alternating", "mirrored"):
        return None
    if any(len(rank) > 1 for rank in given.ranks):
        return other
    looks = [(scene.things[n].color, scene.things[n].label) for (n,) in given.ranks]
    fits = looks == looks[::-1] if other.by == "mirrored" else all(a != b for a, b in pairwise(looks))
    return given if fits else None


def forget_side(scene: Scene) -> None:
    """Take back what was assumed of the side where an order begins."""
    for note in [note for note in scene.assumptions if note.startswith("the order is read from")]:
        del scene.assumptions[note]


def in_place(
    order: Order, places: dict[int, str], names: tuple[str, ...], sides: tuple[str, str], scene: Scene
) -> Order | None:
    """An order that is settled, where these blocks stand at these places, counted from the first side.

    None where it has them elsewhere; where its direction was open, they say which it is.
    """
    ranks = list(order.ranks)
    if order.by in _SORTED:
        keyed = [(key(order, scene.things[n]), n) for n in names]
        if any(k is None for k, _ in keyed):
            return None
        keyed.sort(key=lambda pair: str(pair[0]).rjust(4), reverse=order.descending)
        ranks = [tuple(n for k, n in keyed if k == one) for one in dict.fromkeys(k for k, _ in keyed)]
    elif order.by != "given":
        return None
    spots = [rank for rank in ranks for _ in rank]
    looks = {n: (scene.things[n].color, scene.things[n].label) for n in names}
    for side in sides if order.first is None else (order.first,):
        row = spots if side == sides[0] else spots[::-1]
        if all(looks[name] in {looks[n] for n in row[at]} for at, name in places.items()):
            return order if order.first else order.model_copy(update={"first": side})
    return None
