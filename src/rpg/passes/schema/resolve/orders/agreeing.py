"""Two things said of one order of blocks: whether they agree, and what the order then is."""

from __future__ import annotations

from itertools import combinations, pairwise

from rpg.ir.order import Order
from rpg.language.lexicon import RAINBOW
from rpg.passes.schema.resolve.orders.between_ends import by_symbols
from rpg.passes.schema.resolve.orders.by_size import edge_of
from rpg.passes.schema.resolve.things.world import Scene, Thing

OPPOSITE = {"left": "right", "front": "back", "bottom": "top"}
OPPOSITE |= {two: one for one, two in OPPOSITE.items()}
Ranks = tuple[tuple[str, ...], ...]
_SORTED = ("label", "number", "rainbow", "size")


def key(order: Order, thing: Thing) -> float | str | None:
    """What an order compares."""
    if order.by == "rainbow":
        return RAINBOW.index(thing.color) if thing.color in RAINBOW else None
    if order.by == "size":
        return edge_of(thing)
    return thing.label if order.by in ("number", "label") else None


def agreed(one: Order, two: Order, directed: bool, scene: Scene) -> Order | None:
    """The order that both a list and the name of an order say; None where they contradict each other.

    "In alphabetical order: D, B, A" lists what there is; "a rainbow row: red, green, blue" lists it in its order.
    `directed`: a side was said where the order begins.
    """
    given, other = (one, two) if one.by == "given" else (two, one)
    if given.by != "given" or other.by == "given":
        return None
    if (ranks := sorted_ranks(given.ranks, other, scene)) is not None:
        return given.model_copy(update={"ranks": ranks}) if other.first in (None, given.first) else None
    found = _sorted(given, other, directed, scene) if other.by in _SORTED else _patterned(given, other, scene)
    if found is not None and found.by != "given":
        forget_side(scene)
    return found


def sorted_ranks(ranks: Ranks, order: Order, scene: Scene) -> Ranks | None:
    """Ranks with an order by symbols or sizes inside each; None where none of them holds blocks that it tells apart."""
    if order.by not in ("label", "number", "size"):
        return None
    found: list[tuple[str, ...]] = []
    for rank in ranks:
        keys = {n: key(order, scene.things[n]) for n in rank}
        if None in keys.values():
            return None
        values = sorted(set(keys.values()), reverse=order.descending)  # type: ignore[type-var]
        found += [tuple(n for n in rank if keys[n] == value) for value in values]
    return tuple(found) if len(found) > len(ranks) else None


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


def one_way(one: Order, two: Order, pointed: bool, first: str | None) -> Order | None:
    """Two orders by the same thing, where they say the same; None where they run against each other.

    `pointed`: the second one tells an end ("the biggest on the left"), which says where the first one begins unless
    that was said (`first`).
    """
    if one.by == "given":
        return two if one.ranks == two.ranks else None
    if one.by not in ("number", "size", "label", "rainbow"):
        return two
    if _way(one) == _way(two) or (one.by == "rainbow" and None in (one.first, two.first)):
        return one if one.first else two
    if first is None and one.descending == two.descending:
        return two if pointed else one
    if first is None and pointed and two.first in ("top", "bottom"):  # "from smallest to biggest, the biggest on top"
        return two.model_copy(update={"first": OPPOSITE[two.first], "descending": one.descending})
    return None


def _way(order: Order) -> tuple[str | None, bool]:
    """An order told from the left, from the front or from the bottom."""
    if order.first in ("right", "back", "top"):
        return OPPOSITE[order.first], not order.descending
    return order.first, order.descending


def forget_side(scene: Scene) -> None:
    """Take back what was assumed of the side where an order begins."""
    for note in [note for note in scene.assumptions if note.startswith("the order is read from")]:
        del scene.assumptions[note]


def in_place(
    order: Order, places: dict[int, str], names: tuple[str, ...], sides: tuple[str, str], scene: Scene
) -> list[Order]:
    """An order that is settled, where these blocks stand at these places, counted from the first side: each way to
    have them there.

    None of them where it has them elsewhere; what it left open, its direction or who is where in a run, they say.
    """
    ranks = order.ranks
    if order.by in _SORTED:
        keyed = [(key(order, scene.things[n]), n) for n in names]
        if any(k is None for k, _ in keyed):
            return []
        keyed.sort(key=lambda pair: str(pair[0]).rjust(4), reverse=order.descending)
        ranks = tuple(tuple(n for k, n in keyed if k == one) for one in dict.fromkeys(k for k, _ in keyed))
    elif order.by != "given" or len(scene.free_runs.get(ranks, ())) > 1:
        return []
    for side in sides if order.first is None else (order.first,):
        found = [ranks]
        for at, name in places.items():
            index = at if side == sides[0] else len(names) - 1 - at
            found = [one for ways in found for one in _split(ways, index, name, scene)]
        if found:
            known = [{"ranks": by_symbols(one, names, scene)} if order.by == "given" else {} for one in found]
            return [order.model_copy(update={**one, "first": side}) for one in known]
    return []


def _split(ranks: Ranks, at: int, name: str, scene: Scene) -> list[Ranks]:
    """Ranks with a block at a place, for each choice of those of its run before it; none where another stands there."""
    for index, rank in enumerate(ranks):
        if at >= len(rank):
            at -= len(rank)
            continue
        looks = {n: _look(scene.things[n]) for n in {*rank, name}}
        if len(set(looks.values())) == 1:
            return [ranks]
        if name not in rank:
            return []
        rest = [n for n in rank if n != name]
        alike = len({looks[n] for n in rest}) == 1
        found = []
        for before in [tuple(rest[:at])] if alike else combinations(rest, at):
            parts = (before, (name,), tuple(n for n in rest if n not in before))
            found.append((*ranks[:index], *(part for part in parts if part), *ranks[index + 1 :]))
        return found
    return []


def _look(thing: Thing) -> tuple[str | float | None, ...]:
    return thing.color, thing.label, thing.size, thing.edge
