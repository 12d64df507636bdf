"""Blocks on a figure of which nothing says that it is a patch: "arrange eight cubes on a circle" lays them along it."""

from __future__ import annotations

from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    Coord,
    Into,
    Loc,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    TableTop,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse

_FIGURES = ("circle", "triangle", "line", "square", "rectangle")
_FEW = 3


def drawn(clause: Clause) -> Clause:
    """The clause, with a figure that several blocks are arranged "on" as what they form.

    A circle that they are merely put on could be a round patch, too, and so could any square.
    """
    for place in clause.adjuncts:
        shape = place.landmark if isinstance(place, Loc) and place.rel == "on" and not place.negated else None
        if not isinstance(shape, Structure) or not _bare(shape) or not _several(clause.theme):
            continue
        if clause.verb == "arrange" and shape.kind not in ("square", "rectangle"):
            into = Into(structure=replace(shape, det="a"), span=place.span)
            return replace(clause, adjuncts=tuple(into if a is place else a for a in clause.adjuncts))
        told = f"this could be a {shape.kind} that the blocks form, or a patch that they lie on"
        raise refuse("ambiguous", told, place.span, f"say 'in a {shape.kind}', or 'on a {shape.kind} patch'")
    return clause


def grounded(clause: Clause, chains: tuple[Chain, ...]) -> Clause:
    """ "They are not stacked on anything": they lie on the table, for what else could they lie on but blocks?"""
    place = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    mark = place.landmark if isinstance(place, Loc) and place.rel in ("on", "above") and not place.negated else None
    word = mark.word if isinstance(mark, Pronoun) else ""
    theme, denied = _whom(clause)
    if word not in (_ANYTHING if denied else ("nothing",)) or place is None or clause.verb not in _LYING:
        return clause
    patches = any(isinstance(part, Noun) and part.head == "patch" for chain in chains for part in parts_of(chain))
    if patches and clause.verb != "stack":
        return clause
    table = Loc(rel="on", landmark=TableTop(span=place.span), span=place.span)
    lemma = "" if clause.verb == "place" else clause.lemma
    return replace(clause, verb="be", lemma=lemma, theme=theme, negated=False, adjuncts=(table,))


_ANYTHING = ("anything", "anything else")
_LYING = ("be", "stack", "place")


def _whom(clause: Clause) -> tuple[Meaning | None, bool]:
    """Of which blocks a clause says something, and whether it denies it of them: "neither red nor blue", "none of
    them"."""
    theme = clause.theme
    if isinstance(theme, Coord) and theme.op == "nor":
        return replace(theme, op="and"), not clause.negated
    if isinstance(theme, Pronoun) and theme.word in ("none of them", "neither of them"):
        return replace(theme, word="them" if theme.word == "none of them" else "both"), not clause.negated
    if isinstance(theme, Noun) and theme.det == "no" and theme.part_of is not None:
        return theme.part_of, not clause.negated
    return theme, clause.negated


def _bare(shape: Structure) -> bool:
    """A figure of which nothing is said."""
    said = shape.members or shape.sizes or shape.dims or shape.details or shape.letter or shape.filled is not None
    one = shape.kind in _FIGURES and shape.det in ("a", "bare") and not shape.plural
    return one and not said and shape.traits == Traits()


def _several(theme: Meaning | None) -> bool:
    """More blocks than would lie on a patch just so."""
    if isinstance(theme, Coord):
        return len(theme.items) >= _FEW
    if not isinstance(theme, Noun) or theme.head == "patch":
        return False
    return theme.amount.low >= _FEW if isinstance(theme.amount, Amount) else theme.plural
