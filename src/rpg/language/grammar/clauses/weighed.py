"""Whether what follows a theme is said of it, or begins something of its own."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.meaning import Clause, Coord, Loc, Meaning, Noun, Pronoun, Structure


def rows_forming(theme: Meaning, apposed: Structure) -> bool:
    """ "three rows of three brown blocks, a filled square": what they form."""
    rows = isinstance(theme, Structure) and theme.kind in ("row", "column") and theme.plural
    return rows and apposed.kind in ("grid", "square", "rectangle") and apposed.det == "a"


def _told_one_by_one(theme: Meaning | None) -> bool:
    """ "Two stacks of two, a red one and a blue one", "a red tower and a blue tower, the red one": the stacks."""
    first, *more = theme.items if isinstance(theme, Coord) and theme.op == "and" else (theme,)
    last = more[-1] if more else None
    if isinstance(first, Structure) and isinstance(last, Noun) and (last.head, last.det) == ("any", "the"):
        return bool(last.traits.colors) and not last.plural and isinstance(more[0], Structure)
    many = first.amount.low if isinstance(first, Structure) and first.plural and first.amount is not None else 0
    ones = all(isinstance(x, Noun) and (x.head, x.det) == ("any", "a") for x in more)
    return many > 1 and ones and len(more) == many


def weighed(found: Meaning) -> Meaning:
    """ "First a row of three, then a red block on one of them": what comes then has its own place, not both of them."""
    theme, place = (found.theme, found.adjuncts[0]) if isinstance(found, Clause) and found.adjuncts else (None, None)
    kinds = isinstance(found, Clause) and found.verb == "be" and {getattr(a, "kind", "") for a in found.adjuncts}
    if isinstance(found, Clause) and (kinds == {"idle"} or _told_one_by_one(found.theme)):
        return replace(found, cost=found.cost + 4)  # "a T, 5 blue cubes, any orientation" says it of the T
    if not isinstance(place, Loc):
        return found
    inside = theme.members if isinstance(theme, Structure) else None
    mark = place.landmark.part_of if isinstance(place.landmark, Noun) else place.landmark
    told = isinstance(mark, Pronoun) and mark.word != "each other"
    later = told and isinstance(inside, Coord) and inside.op == "then"
    if isinstance(theme, Coord) and theme.op == "then" and any(isinstance(x, Structure) for x in theme.items):
        later = True
    return replace(found, cost=found.cost + 3) if later else found
