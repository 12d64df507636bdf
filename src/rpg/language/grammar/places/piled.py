""" "red on blue on green": each thing lies on the one named next, not all on the first."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.meaning import Chain, Clause, Into, Loc, Meaning, Noun, Structure, That


def piled(found: Meaning) -> Meaning:
    """`found` with what its landmark lies on said of the landmark."""
    if not isinstance(found, Clause):
        return found
    if found.lemma == "keep" and found.adjuncts and all(_bunched(part) for part in found.adjuncts):
        bunch = tuple(part for part in found.adjuncts if isinstance(part, Into))
        return replace(found, verb="place", lemma="put", adjuncts=bunch) if bunch else found
    for index, (first, second) in enumerate(zip(found.adjuncts, found.adjuncts[1:], strict=False)):
        alike = getattr(first, "rel", "") == getattr(second, "rel", "")
        if alike and _lies_on(first) and _lies_on(second) and second.span[0] <= first.span[1] + 1:
            assert isinstance(first, Loc) and isinstance(first.landmark, Noun)
            theme = replace(first.landmark, det="the", amount=None, cost=0)
            span = (first.landmark.span[0], found.span[1])
            below = Clause(verb="be", theme=theme, adjuncts=found.adjuncts[index + 1 :], mode=found.mode, span=span)
            chain = Chain(clauses=(piled(below),), links=("and",), span=span)
            said = That(kind="so", clauses=chain, span=span)
            return replace(found, adjuncts=(*found.adjuncts[: index + 1], said))
    return found


def _bunched(part: Meaning) -> bool:
    """ "(keep the white blocks) together in one bunch": they are put there."""
    if isinstance(part, Into):
        return isinstance(part.structure, Structure) and part.structure.kind == "pile"
    return isinstance(part, Loc) and part.rel == "together" and not part.negated


def _lies_on(part: Meaning) -> bool:
    upright = isinstance(part, Loc) and part.rel in ("on", "above") and not part.negated
    return upright and isinstance(part, Loc) and isinstance(part.landmark, Noun)
