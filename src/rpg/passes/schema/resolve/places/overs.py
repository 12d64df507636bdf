"""Blocks somewhere above each other in a tower: "pink is somewhere above brown in a stack with gray in between"."""

from __future__ import annotations

from rpg.language.meaning import (
    Absolute,
    Amount,
    At,
    Clause,
    Coord,
    Into,
    Loc,
    Manner,
    Meaning,
    Noun,
    OrderBy,
    Places,
    Pronoun,
    Structure,
    Toward,
    Traits,
    parts_of,
    replace,
)

_LOWER = {"above": 0, "under": 1}
"""Which of the theme and the landmark is the lower one: 0 the landmark."""
_ANY_ONE = (Traits(), Traits(scheme="same"))
"""What is said of a tower of which no more is said than that both are in it, which "above" says too."""


def in_one_tower(clause: Clause) -> tuple[Clause, ...]:
    """The clauses that build the tower and say what is above what in it; none where this is not said."""
    if clause.verb not in ("be", "place", "stack", "build") or clause.negated or clause.mode == "start":
        return ()
    least = 1 if clause.verb == "stack" or isinstance(clause.theme, Structure) else 2
    if len(clause.adjuncts) < least:
        return ()
    if (between := _sandwiched(clause) or _with_one_between(clause) or _in_a_row_with(clause)) is not None:
        return (between,)
    towers = [shape for a in clause.adjuncts if (shape := _tower(a)) is not None]
    places = [a for a in clause.adjuncts if isinstance(a, Loc) and _tower(a) is None]
    middles: list[Meaning] = [a for a in clause.adjuncts if isinstance(a, Absolute)]
    idle = [a for a in clause.adjuncts if isinstance(a, Manner) and (a.kind, a.value) == ("idle", None)]
    if len(places) != 1 or len(towers) != 1 or 2 + len(middles) + len(idle) != len(clause.adjuncts):
        return ()
    tower, over = replace(towers[0], details=()), places[0]
    middles += towers[0].details
    if len(middles) > 1 or tower.plural:
        return ()
    plain = not over.negated and over.low is None and over.high is None and not {"directly", "immediate"} & {*over.mods}
    if over.rel not in _LOWER or not plain or not _one(clause.theme) or not _one(over.landmark):
        return ()
    if middles:
        return _between(clause, tower, over, middles[0]) if isinstance(middles[0], Absolute) else ()
    if tower.sizes:
        return ()
    if tower.members is None and tower.traits in _ANY_ONE and (tower.traits.scheme or tower.det == "bare"):
        return (replace(clause, adjuncts=(over,)),) if clause.verb != "stack" else ()
    if tower.members is None or tower.det != "a" or not _looks(clause.theme, over.landmark) <= _looks(tower.members):
        return ()
    built = Clause(verb="build", theme=tower, mode="goal", span=tower.span)
    said = replace(clause, verb="be", lemma="", theme=_known(clause.theme),
                   adjuncts=(replace(over, landmark=_known(over.landmark)),))  # fmt: skip
    return built, said


def _sandwiched(clause: Clause) -> Clause | None:
    """ "white between the two black ones in one tower", "stack white between red and blue": one below, one above."""
    places = [a for a in clause.adjuncts if isinstance(a, Loc) and _tower(a) is None]
    towers = [a for a in clause.adjuncts if _tower(a) is not None or a == Toward(axis="z", span=a.span)]
    said = places[0] if len(places) == 1 else None
    upright = len(towers) == 1 or (clause.verb == "stack" and not towers)
    if said is None or said.rel != "between" or said.negated or not upright or not _one(clause.theme):
        return None
    shapes = [shape for a in towers if (shape := _tower(a)) is not None]
    if any(x.details or x.members or x.plural or x.traits not in _ANY_ONE for x in shapes):
        return None
    if 1 + len(towers) != len(clause.adjuncts) or any(z.amount != Amount(3, 3) for x in shapes for z in x.sizes):
        return None
    return replace(clause, verb="be", lemma="", adjuncts=(replace(said, rel="sandwiched"),))


def _with_one_between(clause: Clause) -> Clause | None:
    """ "two black ones with a white one between them in one stack", "a tower of two red blocks with a blue one between
    them": the same, told of those outside."""
    built = clause.theme if isinstance(clause.theme, Structure) else None
    ends = built.members if built is not None and _is_bare_stack(built) else clause.theme
    middles = [a for a in clause.adjuncts if isinstance(a, Absolute)]
    towers = [a for a in clause.adjuncts if _tower(a) is not None or a == Toward(axis="z", span=a.span)]
    upright = clause.verb == "stack" or len(towers) == 1 or ends is not clause.theme
    if not upright or not _two(ends) or len(middles) != 1 or 1 + len(towers) != len(clause.adjuncts):
        return None
    shapes = [shape for a in towers if (shape := _tower(a)) is not None]
    if not _between_them(middles[0]) or not _one(middles[0].theme) or not all(map(_is_bare_stack, shapes)):
        return None
    between = Loc(rel="sandwiched", landmark=ends, span=middles[0].span)
    return replace(clause, verb="be", lemma="", theme=middles[0].theme, adjuncts=(between,))


def _in_a_row_with(clause: Clause) -> Clause | None:
    """ "two red blocks with two blue ones between them, in a row": a row of all of them, with red ends."""
    ends, middles = clause.theme, [a for a in clause.adjuncts if isinstance(a, Absolute)]
    rows = [a.structure for a in clause.adjuncts if isinstance(a, Into) and isinstance(a.structure, Structure)]
    if not isinstance(ends, Noun) or not _two(ends) or len(middles) != 1 or len(rows) + 1 != len(clause.adjuncts):
        return None
    row, inner = rows[0] if len(rows) == 1 else None, middles[0].theme
    if row is None or row.kind not in ("row", "line", "column") or row.members or row.details or row.sizes:
        return None
    if not _between_them(middles[0]) or not isinstance(inner, Noun) or len(inner.traits.colors) != 1 or row.plural:
        return None
    end = replace(ends, det="bare", amount=None, plural=False)
    order = OrderBy(by="named", items=(end, replace(inner, det="bare"), end), span=clause.span)
    return Clause(verb="build", theme=replace(row, det="a"), adjuncts=(order,), mode="goal", span=clause.span)


def _between_them(middle: Absolute) -> bool:
    """ "with ... in between", "with ... between them"."""
    place = middle.adjuncts[0] if len(middle.adjuncts) == 1 else None
    if isinstance(place, Loc):
        them = isinstance(place.landmark, Pronoun) and not place.negated
        return them and place.rel in ("between", "sandwiched")
    return isinstance(place, Places) and (place.side, place.unit) == ("rest", "block")


def _is_bare_stack(shape: Structure) -> bool:
    return shape.kind == "stack" and not (shape.details or shape.plural or shape.sizes) and shape.traits in _ANY_ONE


def _two(ends: Meaning | None) -> bool:
    """ "two black blocks", "a red and a blue block": two blocks of which one is the lower one."""
    if isinstance(ends, Coord):
        return ends.op == "and" and len(ends.items) == 2 and all(map(_one, ends.items))
    return isinstance(ends, Noun) and ends.amount == Amount(2, 2) and ends.part_of is None


def _tower(adjunct: Meaning) -> Structure | None:
    """The tower of "in one tower", "somewhere in the same stack"."""
    shape = adjunct.structure if isinstance(adjunct, Into) else None
    if isinstance(adjunct, Loc) and adjunct.rel == "in" and not adjunct.negated and adjunct.second is None:
        shape = adjunct.landmark
    return shape if isinstance(shape, Structure) and shape.kind == "stack" else None


def _between(clause: Clause, tower: Structure, over: Loc, middle: Absolute) -> tuple[Clause, ...]:
    place = middle.adjuncts[0] if len(middle.adjuncts) == 1 else None
    inside = (isinstance(place, Places) and place.side == "rest") or (isinstance(place, At) and place.side == "middle")
    them = isinstance(place, Loc) and place.rel == "between" and isinstance(place.landmark, Pronoun)
    if not (inside or them) or not _one(middle.theme) or tower.members is not None:
        return ()
    if any(z.amount != Amount(3, 3) for z in tower.sizes):
        return ()
    items = (over.landmark, middle.theme, clause.theme)
    items = items if _LOWER[over.rel] == 0 else items[::-1]
    named = tuple(x for x in items if isinstance(x, Noun))
    order = OrderBy(by="named", items=named, first="bottom", span=clause.span)
    return (Clause(verb="build", theme=replace(tower, det="a"), adjuncts=(order,), mode="goal", span=clause.span),)


def _looks(*said: Meaning | None) -> set[str]:
    """The colours and labels of which phrases speak."""
    nouns = [part for part in parts_of(said) if isinstance(part, Noun)]
    return {look for noun in nouns for look in (*noun.traits.colors, *noun.traits.labels)}


def _one(meaning: Meaning | None) -> bool:
    """One block by its look."""
    if not isinstance(meaning, Noun) or meaning.head == "patch" or meaning.plural or meaning.conditions:
        return False
    told = len(meaning.traits.colors) + len(meaning.traits.labels) == 1 and not meaning.traits.rank
    return told and meaning.amount in (None, Amount(1, 1)) and meaning.det in ("a", "the", "bare")


def _known(meaning: Meaning | None) -> Meaning | None:
    return replace(meaning, det="the", amount=None) if isinstance(meaning, Noun) else meaning
