""" "(The three blocks lie) directly on top of each other": one on the other, as in a tower."""

from __future__ import annotations

from rpg.language.meaning import Clause, Loc, Pronoun, replace


def heaped(clause: Clause) -> Clause:
    """The clause with blocks that are on each other as heaped up; where it is denied, none of them is on another."""
    if clause.negated or not any(map(_on_each_other, clause.adjuncts)):
        return clause
    told = (
        replace(a, rel="heaped", mods=()) if isinstance(a, Loc) and _on_each_other(a) else a for a in clause.adjuncts
    )
    return replace(clause, adjuncts=tuple(told))


def _on_each_other(adjunct: object) -> bool:
    if not isinstance(adjunct, Loc) or adjunct.rel != "on" or adjunct.negated or adjunct.mods != ("directly",):
        return False
    return isinstance(adjunct.landmark, Pronoun) and adjunct.landmark.word in ("each other", "one another")
