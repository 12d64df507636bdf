""" "Only the red block may be moved. Put it on the blue one.": what alone moves is what is spoken of next, and the
others are all that are named anywhere."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Coord, Manner, Meaning, Noun, Pronoun, Traits, replace


def moved_alone(clause: Meaning) -> Noun | None:
    """The one thing that a clause says is moved, or may be, while all other blocks stay; None if it says more."""
    theme = clause.theme if isinstance(clause, Clause) and not clause.negated else None
    if not isinstance(clause, Clause) or not isinstance(theme, Coord):
        return None
    manners = [x.kind for x in clause.adjuncts if isinstance(x, Manner)]
    whole, sole = theme.items[0], theme.items[-1]
    every = isinstance(whole, Noun) and (whole.head, whole.det, whole.traits) == ("block", "all", Traits())
    stays = (clause.verb, theme.op) == ("be", "except") and every and manners == ["stay"]
    moves = (clause.verb, clause.lemma, theme.op) == ("place", "move", "only")
    told = (stays or moves) and len(manners) == len(clause.adjuncts)
    return sole if told and isinstance(sole, Noun) and not sole.plural else None


def named_for_it(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with that block named where "it" begins what is said next."""
    found: list[Chain] = []
    sole: Noun | None = None
    for chain in chains:
        clauses: list[Meaning] = []
        for clause in chain.clauses:
            it = isinstance(clause, Clause) and isinstance(clause.theme, Pronoun) and clause.theme.word == "it"
            if sole is not None and it and isinstance(clause, Clause) and clause.theme is not None:
                clause = replace(clause, theme=replace(sole, span=clause.theme.span))
            sole = moved_alone(clause)
            clauses.append(clause)
        found.append(replace(chain, clauses=tuple(clauses)) if tuple(clauses) != chain.clauses else chain)
    return tuple(found)
