"""Whether what follows "so that" and "as long as" may be so or not: else it is no condition."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Manner, Meaning


def may_be_so(said: Chain, *, compared: bool) -> bool:
    """Whether all of it tells how things are. `compared`: "as long as" may also tell a length."""
    if compared and any(map(_mere_figure, said.clauses)):
        return False
    return not all(map(_only_when, said.clauses))


def _mere_figure(clause: Meaning) -> bool:
    """ "(a wall as long as) a row of four"."""
    return isinstance(clause, Clause) and clause.verb == "build" and not clause.lemma and clause.word is None


def _only_when(clause: Meaning) -> bool:
    """ "(where) it was at the start": a time, and nothing that was so then."""
    told = isinstance(clause, Clause) and clause.verb == "be" and clause.mode == "start"
    return told and all(isinstance(a, Manner) for a in getattr(clause, "adjuncts", ()))
