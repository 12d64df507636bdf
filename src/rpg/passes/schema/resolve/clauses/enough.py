""" "Stack blue blocks on the red one to make a tower of five", "... until it is five high": as many as it takes."""

from __future__ import annotations

from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    In,
    Into,
    Loc,
    Meaning,
    Noun,
    Pronoun,
    Size,
    Structure,
    That,
    replace,
)


def as_many_as_it_takes(clause: Clause) -> Clause:
    """The command with the number of its blocks, where it is told of how many the tower is that they make."""
    if clause.mode != "command" or clause.negated or clause.verb not in ("stack", "place", "build"):
        return clause
    ends = [a for a in clause.adjuncts if isinstance(a, That | Into) and _height(a) is not None]
    others = tuple(a for a in clause.adjuncts if a not in ends)
    if len(ends) != 1 or any(isinstance(a, That | Into | Size) for a in others):
        return clause
    high, theme = _height(ends[0]) or 0, clause.theme
    if clause.verb == "build":
        return _of_that_height(clause, others, high) if isinstance(ends[0], That) else clause
    bases = [a for a in others if isinstance(a, Loc | In)]
    if not isinstance(theme, Noun) or not theme.plural or theme.head == "patch" or not all(map(_one_block, bases)):
        return clause
    if len(bases) > 1 or (not bases and (isinstance(ends[0], Into) or clause.verb != "stack")):
        return clause
    many = high - len(bases)
    counted = theme.amount == Amount(many, many) or (theme.amount is not None and theme.amount[:2] == (many, many))
    open_ = theme.amount is None and theme.det in ("bare", "some", "the") and theme.part_of is None
    if many < 1 or not (open_ or counted):
        return clause
    those = replace(theme, amount=theme.amount or Amount(many, many), det="bare" if theme.det == "some" else theme.det)
    if many == 1:
        those = replace(those, plural=False)
    return replace(clause, verb="stack", theme=those, adjuncts=others)


def _of_that_height(clause: Clause, others: tuple[Meaning, ...], high: int) -> Clause:
    """ "Build a tower of red cubes until it is five high": a tower of five."""
    shape = clause.theme
    if not isinstance(shape, Structure) or shape.kind != "stack" or shape.sizes or shape.plural:
        return clause
    size = Size(what="high", amount=Amount(high, high), span=clause.span)
    return replace(clause, theme=replace(shape, sizes=(size,)), adjuncts=others)


def _one_block(place: Meaning) -> bool:
    mark = place.landmark if isinstance(place, Loc) and place.rel == "on" and not place.negated else None
    one = isinstance(mark, Noun) and mark.head != "patch" and not mark.plural and mark.part_of is None
    return one and isinstance(mark, Noun) and (mark.amount is None or mark.amount[:2] == (1, 1))


def _height(adjunct: Meaning) -> int | None:
    """Of how many blocks the tower is in the end, where that is what an adjunct tells."""
    if isinstance(adjunct, Into):
        return _tall(adjunct.structure)
    inner = adjunct.clauses if isinstance(adjunct, That) and adjunct.kind in ("until", "so") else None
    said = inner.clauses[0] if isinstance(inner, Chain) and len(inner.clauses) == 1 else None
    if not isinstance(said, Clause) or said.negated or said.mode not in ("goal", "given"):
        return None
    if said.verb in ("build", "exist") and not said.adjuncts:
        return _tall(said.theme)
    part = said.adjuncts[0] if len(said.adjuncts) == 1 else None
    if said.verb == "exist" and isinstance(said.theme, Noun) and isinstance(part, Into | Loc):
        inside = part.structure if isinstance(part, Into) else part.landmark
        plain = said.theme.head == "block" or said.theme.head == "any"
        plain = plain and not (said.theme.traits.colors or said.theme.traits.labels)
        return _exact(said.theme.amount) if plain and isinstance(inside, Structure) and inside.kind == "stack" else None
    tower = isinstance(said.theme, Pronoun) and said.theme.word == "it"
    tower = tower or (isinstance(said.theme, Structure) and said.theme.kind == "stack" and said.theme.det == "the")
    if said.verb == "be" and tower and isinstance(part, Size) and part.what in ("high", "size"):
        return _exact(part.amount)
    return None


def _tall(shape: Meaning | None) -> int | None:
    """The number of blocks of "a tower of five", of which no more is said."""
    if not isinstance(shape, Structure) or shape.kind != "stack" or shape.plural or shape.details or shape.dims:
        return None
    if len(shape.sizes) == 1 and shape.members is None and shape.sizes[0].what in ("size", "high"):
        return _exact(shape.sizes[0].amount)
    return None


def _exact(amount: Amount | None) -> int | None:
    return amount.low if amount is not None and amount.low == amount.high else None
