""" "Put one block on each mat, all of different colours", "a tower of three, all in one colour": it is said of the
blocks."""

from __future__ import annotations

from rpg.language.meaning import Clause, Manner, Meaning, Noun, Structure, Traits, replace


def colors_told(clause: Clause) -> Clause:
    """The clause with what its blocks have in common told of them."""
    told = [a for a in clause.adjuncts if isinstance(a, Manner) and a.kind == "colors"]
    alike = _alike(clause.theme, str(told[0].value)) if len(told) == 1 else None
    if alike is None:
        return clause
    return replace(clause, theme=alike, adjuncts=tuple(a for a in clause.adjuncts if a is not told[0]))


def _alike(theme: Meaning | None, scheme: str) -> Meaning | None:
    """Blocks of so many colours, or one structure of them; None where it is told how they look, or which they are."""
    if isinstance(theme, Structure):
        if theme.plural or theme.det == "the" or theme.traits != Traits():
            return None
        if not isinstance(theme.members, Noun):
            return replace(theme, traits=Traits(scheme=scheme)) if theme.members is None else None
        plain = theme.members.traits == Traits(kind=theme.members.traits.kind) and theme.members.det == "bare"
        marked = replace(theme.members.traits, scheme=scheme)
        return replace(theme, members=replace(theme.members, traits=marked)) if plain else None
    if not isinstance(theme, Noun) or theme.head == "patch" or theme.amount is None or theme.part_of is not None:
        return None
    plain = theme.traits == Traits(kind=theme.traits.kind)
    return replace(theme, traits=replace(theme.traits, scheme=scheme)) if plain else None
