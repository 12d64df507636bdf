""" "Put blue right of yellow. There should be no gap between them.": said of two blocks, that they touch."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Coord, Loc, Meaning, Noun, Pronoun, Spacing, replace

_BESIDE = frozenset({"left", "right", "front", "behind", "beside", "touching", "side_by_side"})


def no_gap(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with what a gap between two blocks is denied of said by these blocks."""
    before: Meaning | None = None
    placed = [
        x for chain in chains for x in chain.clauses if isinstance(x, Clause) and x.verb in ("be", "place", "touch")
    ]
    if len(placed) > 1:
        return chains  # "red left of blue, green right of it. No gaps.": said of them all
    out = []
    for chain in chains:
        clauses = []
        for clause in chain.clauses:
            if isinstance(before, Clause) and _gapless(clause) and (touch := _touching(before)) is not None:
                clause = touch
            clauses.append(clause)
            before = clause
        out.append(replace(chain, clauses=tuple(clauses)))
    return tuple(out)


def _gapless(clause: Meaning) -> bool:
    """ "No gap", and no more."""
    if not isinstance(clause, Clause) or clause.verb != "part" or clause.theme is not None or clause.negated:
        return False
    return (
        len(clause.adjuncts) == 1 and isinstance(clause.adjuncts[0], Spacing) and clause.adjuncts[0].kind == "touching"
    )


def _touching(clause: Clause) -> Clause | None:
    """That the two blocks touch of which a clause says how they stand to each other."""
    place = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    if (
        clause.negated
        or clause.mode == "start"
        or not isinstance(place, Loc)
        or place.negated
        or place.rel not in _BESIDE
    ):
        return None
    mutual = isinstance(place.landmark, Pronoun) and place.landmark.word == "each other"
    if mutual and isinstance(clause.theme, Coord) and len(clause.theme.items) == 2 and clause.theme.op == "and":
        items = [_the(item) for item in clause.theme.items]
        theme: Meaning | None = replace(clause.theme, items=tuple(x for x in items if x is not None))
        mark: Meaning | None = place.landmark
        whole = None not in items
    else:
        theme, mark = _the(clause.theme), _the(place.landmark)
        whole = theme is not None and mark is not None
    if not whole or theme is None or mark is None:
        return None
    touch = Loc(rel="touching", landmark=mark, span=place.span)
    return Clause(verb="be", theme=theme, adjuncts=(touch,), mode="goal", span=clause.span)


def _the(thing: Meaning | None) -> Noun | None:
    """The same block again; None where it is not one block with a look of its own."""
    plain = isinstance(thing, Noun) and not thing.plural and thing.head != "patch" and thing.part_of is None
    if not plain or not isinstance(thing, Noun) or thing.det in ("another", "other", "no", "each", "any"):
        return None
    return replace(thing, det="the", amount=None) if thing.traits.colors or thing.traits.labels else None
