""" "Clear the green patch", and nothing else: there are blocks on it that go elsewhere."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Meaning, Noun, Quality, Structure, Traits, Using, parts_of, replace


def emptied(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences, with all the blocks taken from the patches where no block is told of."""
    things = [part for chain in chains for part in parts_of(chain)]
    if any(isinstance(x, Structure) or (isinstance(x, Noun) and x.head != "patch") for x in things):
        return chains
    clauses = [clause for chain in chains for clause in chain.clauses]
    if len(clauses) != 1 or not _empties(clauses[0]):
        return chains
    return tuple(replace(chain, clauses=tuple(map(_taken, chain.clauses))) for chain in chains)


def _empties(clause: Meaning) -> bool:
    if not isinstance(clause, Clause) or clause.negated or not isinstance(clause.theme, Noun) or clause.theme.plural:
        return False
    if clause.verb == "remove" and clause.lemma in ("clear", "empty"):
        return not clause.adjuncts and clause.mode == "command"
    told = clause.verb == "be" and clause.mode == "goal" and len(clause.adjuncts) == 1
    return told and isinstance(clause.adjuncts[0], Quality) and clause.adjuncts[0].traits == Traits(empty=True)


def _taken(clause: Meaning) -> Meaning:
    if not isinstance(clause, Clause) or not isinstance(clause.theme, Noun):
        return clause
    every = Noun(head="block", det="all", plural=True, span=clause.theme.span)
    place = Using(members=clause.theme, lead="from", span=clause.theme.span)
    return Clause(verb="remove", lemma="remove", theme=every, adjuncts=(place,), span=clause.span, word=clause.word)
