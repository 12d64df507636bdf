""" "Make a ring of eight green cubes and put a red one in the middle": in the middle of the ring, which is empty."""

from __future__ import annotations

from rpg.language.meaning import At, Chain, Clause, Loc, Meaning, Noun, Pronoun, Structure, replace

_RINGS = frozenset({"circle", "square", "rectangle", "triangle", "diamond"})


def middle_of_ring(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with "it" for the ring that was built just before a block is put in the middle of nothing else."""
    before: Meaning | None = None
    out = []
    for chain in chains:
        clauses = []
        for clause in chain.clauses:
            clauses.append(_in_it(clause) if before is not None and _ring(before) else clause)
            before = clause
        out.append(replace(chain, clauses=tuple(clauses)))
    return tuple(out)


def _ring(clause: Meaning) -> bool:
    """Whether one figure with nothing inside is built there."""
    shape = clause.theme if isinstance(clause, Clause) and clause.verb == "build" and not clause.negated else None
    if not isinstance(shape, Structure) or shape.plural or shape.kind not in _RINGS:
        return False
    return shape.filled is False or (shape.kind == "circle" and shape.filled is None)


def _in_it(clause: Meaning) -> Meaning:
    if not isinstance(clause, Clause) or clause.verb not in ("place", "be") or clause.negated:
        return clause
    theme, place = clause.theme, clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    one = isinstance(theme, Noun) and theme.head != "patch" and not theme.plural
    bare = isinstance(place, At) and (place.side, place.index, place.whole) == ("middle", None, None)
    if not one or not bare or place is None:
        return clause
    there = Loc(rel="between", landmark=Pronoun(word="it", span=place.span), span=place.span)
    return replace(clause, adjuncts=(there,))
