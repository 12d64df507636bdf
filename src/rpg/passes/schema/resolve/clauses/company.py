"""Who is put somewhere along with another: "red on the mat, together with blue"."""

from __future__ import annotations

from rpg.language.meaning import Clause, Coord, In, Loc, Meaning, Noun, replace

_OWN = frozenset({"together", "moved", "offset", "off"})
"""Places that are of one block alone, and not shared."""


def in_company(clause: Clause) -> Clause:
    """ "Put red on the mat together with blue": both are put there, rather than red there and close to blue."""
    with_it = [a for a in clause.adjuncts if isinstance(a, Loc) and a.rel == "together" and not a.negated]
    there = [a for a in clause.adjuncts if isinstance(a, In) or (isinstance(a, Loc) and a.rel not in _OWN)]
    other = with_it[0].landmark if len(with_it) == 1 else None
    if clause.negated or not there or not _blocks(clause.theme) or not _blocks(other):
        return clause
    assert clause.theme is not None and other is not None
    both = Coord(op="and", items=(clause.theme, other), span=clause.theme.span)
    return replace(clause, theme=both, adjuncts=tuple(a for a in clause.adjuncts if a not in with_it))


def _blocks(told: Meaning | None) -> bool:
    if isinstance(told, Coord):
        return all(map(_blocks, told.items))
    return isinstance(told, Noun) and told.head != "patch"
