"""Places that could be of one thing or of another: "build a tower and a row on the mat", "A left of B behind C"."""

from __future__ import annotations

from itertools import pairwise

from rpg.language.meaning import (
    Absolute,
    Clause,
    Coord,
    In,
    Loc,
    Meaning,
    Noun,
    Places,
    Pronoun,
    Structure,
    TableTop,
    Traits,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse


def with_its_noun(clause: Clause) -> Clause:
    """ "A red and a blue tower": the noun of the last one is that of all."""
    items = clause.theme.items if isinstance(clause.theme, Coord) and clause.theme.op == "and" else ()
    last = items[-1] if items else None
    if not isinstance(last, Structure) or last.plural or len(last.traits.colors) != 1:
        return clause
    if last.members is not None and getattr(last.members, "traits", None) != Traits():
        return clause
    if not all(isinstance(x, Noun) and _bare_look(x, last) for x in items[:-1]):
        return clause
    made = [replace(last, det=x.det, traits=x.traits, span=x.span) for x in items[:-1] if isinstance(x, Noun)]
    return replace(clause, theme=replace(clause.theme, items=(*made, last)))


def _bare_look(noun: Noun, last: Structure) -> bool:
    alone = noun.head == "any" and not noun.plural and noun.part_of is None and not noun.conditions
    return alone and noun.det == last.det and noun.traits == Traits(colors=noun.traits.colors[:1]) != Traits()


_HALVES = ("left_half", "right_half")


def _by_halves(clause: Clause) -> None:
    """Refuse "a row of three red blocks in the left half and three blue ones in the right half": of the table?"""
    parts = [a.adjuncts[0] for a in clause.adjuncts if isinstance(a, Absolute)]
    halves = any(isinstance(x, Places) and x.unit == "half" and x.side in ("left", "right") for x in parts)
    halves = halves and isinstance(clause.theme, Structure) and clause.theme.kind in ("row", "line")
    for place in (a for a in clause.adjuncts if halves and isinstance(a, In) and a.region in _HALVES):
        raise refuse("ambiguous", "this could be a half of the table, or of what is built", place.span,
                     "say 'of the table', or 'of the row'")  # fmt: skip


def one_or_all(clause: Clause, before: Clause | None) -> None:
    """Refuse "build a tower of three red and one of two blue on the mat", whichever of the two it was read as."""
    _by_halves(clause)
    last = clause.theme.items[-1] if isinstance(clause.theme, Coord) else clause.theme
    if clause.verb != "build" or not isinstance(last, Structure) or last.det not in _NEW:
        return
    if last is clause.theme and (before is None or not _goes_on(before, clause)):
        return
    for place in (x for x in clause.adjuncts if x.span[0] == last.span[1] + 1 and _could_be_of_one(x)):
        raise refuse("ambiguous", "is this where all of these are to be, or the last one?", place.span,
                     "say 'both of them ...', or say it in a sentence of its own")  # fmt: skip


_NEW = ("a", "bare", "some")


def _goes_on(before: Clause, clause: Clause) -> bool:
    """ "(build a row of red, green and blue) and a tower of A and B ...": the verb is of both; no comma parts them."""
    together = before.verb == "build" and clause.cost > 0 and clause.span[0] == before.span[1] + len(" and ")
    return together and isinstance(before.theme, Structure) and not before.adjuncts


def _could_be_of_one(place: Meaning) -> bool:
    if isinstance(place, In):
        return not place.region.endswith("corners")
    mark = place.landmark if isinstance(place, Loc) else None
    return mark is not None and not isinstance(mark, Pronoun) and not getattr(mark, "plural", False)


def place_of_which(clause: Clause, leaving: bool) -> None:
    """Refuse "A left of B behind C", where C may be behind A or B, and "move the red block on the mat to the left of
    the blue one", which may be on the mat at first or is to be. `leaving`: the verb takes blocks from where they are.
    """
    places = [x for x in clause.adjuncts if isinstance(x, Loc) and not x.negated]
    for one, two in pairwise(places):
        if two.span[0] != one.span[1] + 1:
            continue
        further = two.rel == "on" or (two.rel in _BESIDE and _of_a_block(two))
        if _of_a_block(one) and one.rel in _BESIDE and further and isinstance(two.landmark, Noun):
            raise refuse("ambiguous", "is this said of the first block, or of the one before it?", two.span,
                         "join the places by 'and', or use two sentences")  # fmt: skip
        there = clause.theme is not None and one.span[0] == clause.theme.span[1] + 1 and _plainly_on(one)
        if leaving and there and two.rel != "on" and getattr(clause.theme, "det", "") == "the":
            raise refuse("ambiguous", "is this where it is at first, or where it is to be?", one.span,
                         "say 'which is on ...', or 'onto'")  # fmt: skip
    table = any(isinstance(x.landmark, TableTop) and x.rel == "on" for x in places)
    patch = next((x for x in places if x.rel == "on" and getattr(x.landmark, "head", "") == "patch"), None)
    if table and patch is not None:
        raise refuse("ambiguous", "is this on the patch, or beside it on the table?", patch.span, "use two sentences")


_BESIDE = ("left", "right", "front", "behind", "beside", "adjacent", "touching", "near", "apart", "between")


def _of_a_block(place: Loc) -> bool:
    return isinstance(place.landmark, Noun) and place.landmark.head != "patch" and not place.landmark.plural


def _plainly_on(place: Loc) -> bool:
    """ "On the mat", and not "onto" it."""
    mark = place.landmark
    return place.rel == "on" and isinstance(mark, Noun) and mark.span[0] == place.span[0] + len("on ")
