""" "A wall with four layers, each a different colour", "three towers of two, each a different colour": "each" is of
what is told right before it, and not of every block. "A row in front of each of two patches": one row, or two? "Two
on each" are so many."""

from __future__ import annotations

import re

from rpg.language import lexicon
from rpg.language.meaning import (
    Chain,
    Clause,
    Coord,
    Loc,
    Manner,
    Meaning,
    Noun,
    Pronoun,
    Quality,
    Size,
    Structure,
    parts_of,
)
from rpg.passes.schema.resolve.things.world import refuse, which_one

EACH_TOWER = "say for example 'build two towers, each with a blue block at the bottom and two red ones on top'"
"""What to say of blocks that are to carry several each."""
_PARTS = frozenset({"layers", "rows", "columns"})


def check_each(chains: tuple[Chain, ...], text: str) -> None:
    """Refuse a reading that gives each block a colour where "each" is of layers, rows, columns or towers."""
    mats = any(isinstance(x, Noun) and x.head == "patch" for chain in chains for x in parts_of(chain))
    for clause in (part for chain in chains for part in chain.clauses if isinstance(part, Clause)):
        for place in (a for a in clause.adjuncts if isinstance(a, Loc) and not a.negated):
            _one_for_each(clause.theme, place, mats)
        _check_so_many(clause, text)
        theme = clause.theme
        told = next(filter(_of_different_colors, clause.adjuncts), None)
        if told is None or not isinstance(theme, Structure):
            continue
        if "each" not in text[theme.span[1] : told.span[1]].lower().split():
            continue
        sizes = (*theme.sizes, *(a for a in clause.adjuncts if isinstance(a, Size)))
        last = max(sizes, key=lambda size: size.span, default=None)
        if last is not None and last.what in _PARTS:
            raise refuse("misplaced", "this is said of each of the parts", told.span, "say 'each block'")
        if theme.plural and theme.kind == "stack":
            raise refuse("ambiguous", "each of the blocks, or each of the towers?", told.span,
                         "say 'each tower' or 'each block'")  # fmt: skip


def _of_different_colors(said: Meaning) -> bool:
    if isinstance(said, Manner):
        return (said.kind, said.value) == ("colors", "different")
    return isinstance(said, Quality) and said.traits.scheme == "different"


_BESIDE = frozenset({"left", "right", "front", "behind", "beside", "next", "adjacent", "near"})


def _one_for_each(theme: Meaning | None, place: Loc, mats: bool) -> None:
    """Refuse "a row in front of each patch", "two towers on each patch", "each red block on a tower of two".
    `mats`: patches are spoken of, which "both" may be."""
    mark = place.landmark
    if _each(theme) and place.rel == "on" and isinstance(mark, Structure) and _new(mark) and mark.kind in _NARROW:
        raise refuse("ambiguous", "one for all of them, or one for each?", mark.span,
                     "say 'two towers of two blue blocks, with a red block on each'")  # fmt: skip
    both = isinstance(mark, Pronoun) and mark.word in ("both", "both of them") and place.rel == "on"
    both = both and mats  # "a pyramid of two red ones and a blue one on both"
    if not _each(mark) and not both:
        return
    items = theme.items if isinstance(theme, Coord) and theme.op == "and" else (theme,)
    shapes = [x for x in items if isinstance(x, Structure)]
    if len(shapes) != len(items) or not all(map(_new, shapes)):
        return
    several = len(shapes) > 1 or (shapes[0].plural and shapes[0].amount is not None and shapes[0].amount.low > 1)
    if several and place.rel == "on" and isinstance(mark, Noun) and mark.head == "patch":
        raise refuse("ambiguous", "one of these on each, or all of them on each?", place.span,
                     "say on which patch each of them is")  # fmt: skip
    if not several and (place.rel in _BESIDE or both):
        hint = "name what is at each in a sentence of its own"
        raise which_one("one for all of them, or one for each?", place.span, hint)


_NARROW = ("stack", "pyramid")
"""Figures with room for one block on top."""


def _each(thing: Meaning | None) -> bool:
    if isinstance(thing, Pronoun):
        return thing.word in ("each", "each one", "each of them")
    return isinstance(thing, Noun) and thing.det == "each"


def _new(shape: Structure) -> bool:
    return shape.det in ("a", "bare", "some", "another")


_SO_MANY_EACH = re.compile(
    r"\b(\w+)(?: of (?:them|these|those))?(?: (?:on|onto|to|for|per))? each(?: one| of them)?\s*(?:$|[.;!?])"
)


def _check_so_many(clause: Clause, text: str) -> None:
    """Refuse "the red blocks on the blue ones, two on each" as of one on each: one block carries one other."""
    marks = [x.landmark for x in clause.adjuncts if isinstance(x, Loc) and x.rel == "on" and not x.negated]
    for mark in marks if isinstance(clause.theme, Noun) and clause.theme.plural else ():
        if not isinstance(mark, Noun) or mark.head == "patch" or not mark.plural:
            continue
        told = _SO_MANY_EACH.search(text.lower(), mark.span[0])
        many = told[1] if told is not None else ""
        if told is not None and (lexicon.NUMBER.get(many, 0) > 1 or (many.isdigit() and int(many) > 1)):
            raise refuse("ambiguous", "it is not clear how so many are to lie on one block", told.span(1),
                         EACH_TOWER)  # fmt: skip


def first_and_last(mark: Meaning | None) -> bool:
    """ "(A block behind) the first and the last one": one for both, or one for each?"""
    return isinstance(mark, Coord) and all(isinstance(item, Noun) and item.traits.rank for item in mark.items)
