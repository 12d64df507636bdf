"""Towers told two blocks at a time: "a tower with B on A and C on B"."""

from __future__ import annotations

from rpg.language.meaning import Absolute, Amount, Loc, Meaning, Noun, OrderBy, Structure, Traits
from rpg.passes.schema.resolve.clauses.spec import Spec


def one_on_another(shape: Structure, spec: Spec) -> None:
    """The order of a tower of which it is told what lies on what, all of it from the lowest block to the top.

    "With red on blue and green beside it": green is no part of it.
    """
    pairs = [item for item in spec.absolutes if all(_pair(item))]
    further = [item for item in spec.absolutes if item not in pairs]
    told = len(pairs)
    many = Amount(told + 1, told + 1)
    bare = shape.kind == "stack" and not (shape.plural or shape.members or shape.dims or shape.traits != Traits())
    beside = all(isinstance(x, Loc) and x.rel not in ("on", "above", "under") for one in further for x in one.adjuncts)
    if not bare or not told or len(spec.absolutes) < 2 or not beside or spec.orders or spec.usings:
        return
    if any(size.amount != many for size in shape.sizes):
        return
    above = {lower[0]: upper for lower, upper in map(_pair, pairs) if lower and upper}
    lowest = [look for look in above if look not in {upper for upper, _ in above.values()}]
    if len(above) < told or len(lowest) != 1:
        return
    nouns = {look: noun for pair in map(_pair, pairs) for look, noun in filter(None, pair)}
    looks = [lowest[0]]
    while looks[-1] in above and len(looks) <= told:
        looks.append(above[looks[-1]][0])
    if len(looks) == len({*looks}) == told + 1:
        items = tuple(nouns[look] for look in looks)
        spec.orders = [OrderBy(by="named", items=items, first="bottom", span=shape.span)]
        spec.absolutes = further


Look = tuple[str, Noun]


def _pair(item: Absolute) -> tuple[Look | None, Look | None]:
    """The lower and the upper of two blocks, if they are told by one colour or label each."""
    place = item.adjuncts[0] if len(item.adjuncts) == 1 else None
    if not isinstance(place, Loc) or place.rel != "on" or place.negated or place.low or place.high:
        return None, None
    return _look(place.landmark), _look(item.theme)


def _look(said: Meaning | None) -> Look | None:
    marks = said.traits.colors + said.traits.labels if isinstance(said, Noun) else ()
    plain = isinstance(said, Noun) and said.traits == Traits(colors=said.traits.colors, labels=said.traits.labels)
    one = isinstance(said, Noun) and said.amount in (None, Amount(1, 1)) and said.det in ("the", "a", "bare")
    told = isinstance(said, Noun) and plain and one and said.head != "patch" and not (said.part_of or said.conditions)
    return (marks[0], said) if told and len(marks) == 1 and isinstance(said, Noun) else None
