""" "Stack the blocks in groups of two": each group is a tower."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Into, Meaning, Structure, replace


def stacked_groups(chain: Chain) -> Chain:
    """The sentence with towers for groups that are stacked."""
    return replace(chain, clauses=tuple(_stacked(c) if isinstance(c, Clause) else c for c in chain.clauses))


def _stacked(clause: Clause) -> Clause:
    if clause.lemma != "stack" or not any(_groups(x) for x in clause.adjuncts):
        return clause
    return replace(clause, adjuncts=tuple(_as_towers(x) for x in clause.adjuncts))


def _groups(said: Meaning) -> bool:
    shape = said.structure if isinstance(said, Into) else None
    several = isinstance(shape, Structure) and shape.kind == "pile" and shape.plural
    return several and isinstance(shape, Structure) and bool(shape.sizes or shape.each_size or shape.amount)


def _as_towers(said: Meaning) -> Meaning:
    if not _groups(said) or not isinstance(said, Into) or not isinstance(said.structure, Structure):
        return said
    return replace(said, structure=replace(said.structure, kind="stack"))
