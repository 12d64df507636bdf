""" "A row of A, B, C and D with exactly one block between A and D": of the others of the row, so many are there."""

from __future__ import annotations

from rpg.language.meaning import Absolute, Amount, Clause, Coord, Loc, Meaning, Noun, Pronoun, Traits, replace
from rpg.passes.schema.resolve.orders.positions import SIDES
from rpg.passes.schema.resolve.things.things import matching
from rpg.passes.schema.resolve.things.world import Scene


def counted_between(clause: Clause, scene: Scene) -> Clause:
    """ "There is exactly one block between red and blue": where both are in one line, one of its other blocks."""
    place = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    if clause.verb not in ("be", "exist") or clause.mode == "start" or not isinstance(place, Loc):
        return clause
    if (theme := _of_the_line(clause.theme, place, scene)) is None:
        return clause
    return replace(clause, verb="be", lemma="", theme=theme, mode="goal")


def so_many_between(item: Absolute, scene: Scene) -> Meaning:
    """ "With exactly one block between red and blue": what is there, of the line that has both."""
    place = item.adjuncts[0] if len(item.adjuncts) == 1 else None
    found = _of_the_line(item.theme, place, scene) if isinstance(place, Loc) else None
    return item.theme if found is None else found


def of_a_line(clause: Clause) -> bool:
    """ "There is exactly one block between red and blue": told of blocks that are there, and not what there is."""
    many = clause.theme.amount if isinstance(clause.theme, Noun) else None
    between = any(isinstance(a, Loc) and a.rel == "between" for a in clause.adjuncts)
    return between and many is not None and many.strict


def _of_the_line(theme: Meaning | None, place: Loc, scene: Scene) -> Noun | None:
    """So many of the other blocks of the line in which both ends are; None where this is something else."""
    if place.rel != "between" or not isinstance(place.landmark, Coord) or place.low is not None or place.mods:
        return None
    if not isinstance(theme, Noun) or theme.head != "block" or theme.traits != Traits() or theme.part_of is not None:
        return None
    many = theme.amount or Amount(1, 1)
    ends = [
        [thing.name for thing in matching(item.traits, scene, False)] if isinstance(item, Noun) else []
        for item in place.landmark.items
    ]
    if theme.det not in ("a", "bare", "no") or many.low != many.high or [len(names) for names in ends] != [1, 1]:
        return None
    both = {*ends[0], *ends[1]}
    lines = [built for built in scene.built if built.kind in SIDES and both < {*built.members}]
    if len(lines) != 1 or len({*lines[0].members} - both) < many.low:
        return None
    others = " ".join(name for name in lines[0].members if name not in both)
    those = Pronoun(word=f"={others}", span=theme.span)
    if theme.det == "no":
        return replace(theme, part_of=those, plural=True)
    exact = Amount(many.low, None if theme.det == "a" else many.low, True)
    return replace(theme, det="bare", amount=exact, plural=True, part_of=those)
