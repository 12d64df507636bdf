"""Clauses that say twice how things are shared out, in plainer words: "four blocks, one in every corner"."""

from __future__ import annotations

from rpg.language.meaning import (
    Absolute,
    Amount,
    Chain,
    Clause,
    Coord,
    In,
    Into,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Size,
    Structure,
    That,
    Toward,
    Traits,
    replace,
)

_CORNERS = Amount(4, 4)
ONE_END = "one end"
"""The attribute of an order of which no more is told than what stands at one end of it: "the biggest on top"."""
_SIZED = ("extreme", "size_down", "size_up")
"""Orders by size, after which "by size" says no more."""


def plainly(clause: Clause) -> Clause:
    """The clause without what says once more how many go where."""
    if clause.negated:
        return clause
    clause = _groups_of(_as_written(_for_its_part(_told_inside(clause))))
    kept = clause.adjuncts
    ordered = [a for a in kept if isinstance(a, OrderBy)]
    if clause.verb != "sort" and len(ordered) == 1 and ordered[0].by == "extreme" and ordered[0].first:
        kept = tuple(replace(a, attribute=ONE_END) if a is ordered[0] else a for a in kept)
    grouped = [a for a in kept if isinstance(a, OrderBy) and a.by == "grouped"]
    if grouped and _of_no_line(clause):
        by_color = replace(grouped[0], by="attribute", attribute="color")
        parts = tuple(by_color if a is grouped[0] else a for a in kept)
        return replace(clause, verb="sort", lemma="sort", adjuncts=parts)
    if clause.verb == "stack" and any(isinstance(a, OrderBy) and a.by in _SIZED for a in kept):
        kept = tuple(a for a in kept if not (isinstance(a, OrderBy) and a.attribute == "size" and a.by == "attribute"))
    if clause.verb == "sort" and len(kept) == 1 and _one_group(kept[0]) and isinstance(clause.theme, Noun):
        return replace(clause, verb="place", lemma="put")
    amount = clause.theme.amount if isinstance(clause.theme, Noun) and clause.theme.part_of is None else None
    corners = [a for a in kept if isinstance(a, In) and a.region.startswith("each_corner")]
    if amount == _CORNERS and len(kept) == 1 and (place := _one_in_each(kept[0])) is not None:
        return replace(clause, adjuncts=(place,))
    if amount == Amount(1, 1) and corners:
        kept = tuple(a for a in kept if not (isinstance(a, Size) and a.what == "total" and a.amount == _CORNERS))
    if amount is not None and amount.low > 1 and any(_as_many(a, amount) for a in kept):
        kept = tuple(a for a in kept if not (isinstance(a, Size) and a.what == "columns" and a.amount == Amount(1, 1)))
    return replace(clause, adjuncts=kept) if kept != clause.adjuncts else clause


def _as_written(clause: Clause) -> Clause:
    """ "Write 6 - 2 = 4 in this order", "cubes in a row so that 6 - 2 = 4 can be read": it is so anyway."""
    shapes = [a.structure for a in clause.adjuncts if isinstance(a, Into)]
    if not any(
        isinstance(x, Structure) and x.kind in ("word", "equation") and x.letter for x in (clause.theme, *shapes)
    ):
        return clause
    return replace(clause, adjuncts=tuple(a for a in clause.adjuncts if not _so_anyway(a, len(shapes) > 1)))


def _so_anyway(part: Meaning, several: bool) -> bool:
    if isinstance(part, OrderBy):
        return part.by == "given" and not part.items
    row = part.structure if isinstance(part, Into) and several else None
    return isinstance(row, Structure) and row == Structure(kind="row", amount=row.amount, span=row.span)


def _for_its_part(clause: Clause) -> Clause:
    """ "The blue one, in turn, on the white one": of one block it says no more than that it is next."""
    one = isinstance(clause.theme, Noun) and not clause.theme.plural and clause.theme.amount in (None, Amount(1, 1))
    if not one or not any(isinstance(a, Loc) for a in clause.adjuncts):
        return clause
    return replace(clause, adjuncts=tuple(a for a in clause.adjuncts if a != OrderBy(by="alternating", span=a.span)))


def _groups_of(clause: Clause) -> Clause:
    """ "(Put three red and three blue blocks) in groups of one red and one blue": what each of these groups has."""
    if clause.theme is None or isinstance(clause.theme, Structure):
        return clause
    parts = tuple(_each_with(a) if isinstance(a, Into) else a for a in clause.adjuncts)
    if parts == clause.adjuncts:
        return clause
    put = {"verb": "place", "lemma": "put"} if clause.verb == "sort" else {}
    return replace(clause, adjuncts=parts, **put)


def _each_with(into: Into) -> Into:
    shape = into.structure
    if not isinstance(shape, Structure) or (shape.kind, shape.plural, shape.details) != ("pile", True, ()):
        return into
    items = shape.members.items if isinstance(shape.members, Coord) else (shape.members,)
    each: list[Meaning] = []
    for item in items:
        many = item.amount if isinstance(item, Noun) and item.det in ("bare", "a") and item.part_of is None else None
        if not isinstance(item, Noun) or many is None or many.low != many.high or len(item.traits.colors) != 1:
            return into
        each += [replace(item, head="block", det="a", amount=Amount(1, 1), plural=False)] * many.low
    told = OrderBy(by="each", items=tuple(each), span=shape.span)
    return replace(into, structure=replace(shape, members=None, each_size=False, details=(told,)))


def _told_inside(clause: Clause) -> Clause:
    """ "Stack them so that every colour has its own tower": the way that they are stacked."""
    so = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    inside = so.clauses if isinstance(so, That) and so.kind == "so" else None
    told = inside.clauses[0] if isinstance(inside, Chain) and len(inside.clauses) == 1 else None
    if clause.verb != "stack" or not isinstance(told, Clause) or told.verb != "stack" or told.negated:
        return clause
    same = isinstance(told.theme, Noun) and (told.theme.det, told.theme.head) == ("the", "block")
    plain = same and isinstance(told.theme, Noun) and told.theme.traits == Traits() and not told.theme.conditions
    return replace(clause, adjuncts=told.adjuncts) if plain and told.adjuncts else clause


def _of_no_line(clause: Clause) -> bool:
    """Whether nothing says that the blocks form something: those that are grouped are groups."""
    formed = isinstance(clause.theme, Structure) or any(isinstance(a, Into | Toward) for a in clause.adjuncts)
    return clause.verb in ("be", "arrange", "place") and clause.lemma not in ("line", "align", "order") and not formed


def _one_group(part: Meaning) -> bool:
    """ "sort the vowels A, E and I into one group": they are put there."""
    shape = part.structure if isinstance(part, Into) else None
    plain = isinstance(shape, Structure) and shape.kind == "pile" and not shape.plural and shape.members is None
    return plain and isinstance(shape, Structure) and shape.amount == Amount(1, 1) and shape.traits == Traits()


def _one_in_each(part: Meaning) -> In | None:
    """ ", one in every corner" behind four blocks."""
    if not isinstance(part, Absolute) or len(part.adjuncts) != 1:
        return None
    place, one = part.adjuncts[0], part.theme
    bare = isinstance(one, Noun) and one.head == "any" and one.traits == Traits() and one.amount in (None, Amount(1, 1))
    bare = bare or (isinstance(one, Pronoun) and one.word == "one")
    return place if bare and isinstance(place, In) and place.region.startswith("each_corner") else None


def _as_many(part: Meaning, amount: Amount) -> bool:
    """ "on the two black ones, one each": as many landmarks as blocks."""
    mark = part.landmark if isinstance(part, Loc) and part.rel == "on" and not part.negated else None
    return isinstance(mark, Noun) and mark.amount is not None and mark.amount[:2] == amount[:2] and mark.head != "patch"
