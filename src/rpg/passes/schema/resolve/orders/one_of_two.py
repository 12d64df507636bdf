""" "Red is left of blue. Put the green block on the left one": that of the two that was said to be on that side."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import members
from rpg.language.meaning import Noun, Traits
from rpg.passes.schema.resolve.things.world import Ref, Scene, Thing

_SIDES: dict[type[object], tuple[str, str]] = {
    r.LeftOf: ("left", "right"),
    r.RightOf: ("right", "left"),
    r.InFrontOf: ("front", "back"),
    r.Behind: ("back", "front"),
}
_HALVES = {"left_half": "left", "right_half": "right", "near_half": "front", "far_half": "back"}


def one_of_two(noun: Noun, side: str, scene: Scene) -> Ref | None:
    """The block on that side, where no more than two were spoken of before, and it was said of them how they lie."""
    if noun.head == "patch" or noun.plural or noun.det != "the" or noun.traits != Traits(rank=noun.traits.rank):
        return None
    told = [m for m in scene.mentions if m.clause < scene.clause]
    before = {n for m in told for n in m.ref.names}
    if len(before) != 2 or any(scene.things[n].patch for n in before) or not all(m.start for m in told):
        return None  # what is done to one of them may change which one it is
    sides: dict[str, set[str]] = {}
    for place, name in _placed(scene):
        sides.setdefault(place, set()).add(name)
    found, opposite = sides.get(side, set()), sides.get(_OPPOSITE.get(side, ""), set())
    if len(found) != 1 or found | opposite != before:
        return None
    return Ref(names=tuple(found), span=noun.span)


def the_other_of_two(noun: Noun, scene: Scene) -> list[Thing]:
    """ "Leave the left one where it is and put the other behind it": of two that there are, the one that the clause
    before says nothing of."""
    there = [t for t in scene.things.values() if not t.extra]
    told = [m for m in scene.mentions if m.clause == scene.clause - 1 and not m.start]
    said = {n for m in told for n in m.ref.names}
    plain = noun.head == "any" and noun.det == "other" and not noun.plural and noun.traits == Traits()
    if not plain or len(there) != 2 or len(said) != 1 or any(t.patch for t in there):
        return []
    return [t for t in there if t.name not in said]


_OPPOSITE = dict(_SIDES.values())


def _placed(scene: Scene) -> Iterator[tuple[str, str]]:
    """The sides on which blocks are said to be at the start, of each other or of the table."""
    for fact in scene.start_goals:
        for part in fact.goals if isinstance(fact, g.All) else (fact,):
            if type(part) in _SIDES:
                for side, names in zip(_SIDES[type(part)], (part.a, part.b), strict=True):  # type: ignore[union-attr]
                    yield from ((side, name) for name in members(names))
            elif isinstance(part, r.InRegion) and part.region in _HALVES:
                yield from ((_HALVES[part.region], name) for name in members(part.a))
