""" "Put one block on each mat, all of different colours": it is said of the blocks."""

from __future__ import annotations

from rpg.language.meaning import Clause, Manner, Noun, Traits, replace


def colors_told(clause: Clause) -> Clause:
    """The clause with what its blocks have in common told of them."""
    told = [a for a in clause.adjuncts if isinstance(a, Manner) and a.kind == "colors"]
    theme = clause.theme
    if len(told) != 1 or not isinstance(theme, Noun) or theme.head == "patch" or theme.amount is None:
        return clause
    if theme.traits != Traits(kind=theme.traits.kind) or theme.part_of is not None:
        return clause
    rest = tuple(a for a in clause.adjuncts if a is not told[0])
    alike = replace(theme, traits=replace(theme.traits, scheme=str(told[0].value)))
    return replace(clause, theme=alike, adjuncts=rest)
