""" "(Stack four blocks) with red higher than blue but not directly on it": what is denied is said of the red one."""

from __future__ import annotations

from rpg.language.meaning import Absolute, Clause, Loc, Meaning, Pronoun, replace


def denied_of_it(clause: Clause) -> Clause:
    """The clause with a place that is denied told of the block that was placed right before it."""
    out: list[Meaning] = []
    for adjunct in clause.adjuncts:
        before = out[-1] if out else None
        told = before.adjuncts[-1] if isinstance(before, Absolute) and before.adjuncts else None
        denied = isinstance(adjunct, Loc) and adjunct.negated and _it(adjunct.landmark)
        if denied and isinstance(before, Absolute) and isinstance(told, Loc) and told.landmark is not None:
            out[-1] = replace(before, adjuncts=(*before.adjuncts, replace(adjunct, landmark=told.landmark)))
        else:
            out.append(adjunct)
    return replace(clause, adjuncts=tuple(out)) if len(out) < len(clause.adjuncts) else clause


def _it(landmark: Meaning | None) -> bool:
    return isinstance(landmark, Pronoun) and landmark.word == "it"
