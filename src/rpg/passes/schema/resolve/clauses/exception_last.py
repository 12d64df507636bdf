"""Exceptions told behind the place: "put all of them on the mat except the black one"."""

from __future__ import annotations

from rpg.language.meaning import Clause, Coord, Loc, Meaning, Noun, Pronoun, TableTop, replace

_ALL = frozenset({"everything", "all", "all of them", "them", "they", "these", "those", "all of it"})


def exception_last(clause: Clause) -> Clause:
    """The clause with the exception said of the blocks: a block is none to a patch, to the table, or to "it"."""
    clause = _cleared_but_for(clause)
    places = [x for x in clause.adjuncts if isinstance(x, Loc) and isinstance(x.landmark, Coord)]
    mark = places[0].landmark if len(places) == 1 else None
    if not isinstance(mark, Coord) or mark.op != "except" or clause.theme is None or not _universal(clause.theme):
        return clause
    blocks = all(isinstance(x, Noun) and x.head != "patch" and x.det in ("the", "bare") for x in mark.items[1:])
    if not blocks or not _no_block(mark.items[0]):
        return clause
    theme = Coord(op="except", items=(clause.theme, *mark.items[1:]), span=clause.theme.span)
    placed = replace(places[0], landmark=mark.items[0])
    return replace(clause, theme=theme, adjuncts=tuple(placed if x is places[0] else x for x in clause.adjuncts))


def _cleared_but_for(clause: Clause) -> Clause:
    """ "Clear the mat except for the green block": everything else is taken off it."""
    told = clause.theme
    if clause.verb != "remove" or clause.adjuncts or not isinstance(told, Coord) or told.op != "except":
        return clause
    mat, *left = told.items
    blocks = all(isinstance(x, Noun) and x.head != "patch" and x.det in ("the", "bare") for x in left)
    if not isinstance(mat, Noun) or mat.head != "patch" or not blocks:
        return clause
    others = Coord(op="except", items=(Pronoun(word="everything", span=mat.span), *left), span=told.span)
    off = Loc(rel="off", landmark=mat, span=mat.span)
    return replace(clause, verb="use", lemma="take", theme=others, adjuncts=(off,))


def _universal(theme: Meaning) -> bool:
    if isinstance(theme, Pronoun):
        return theme.word in _ALL
    whole = isinstance(theme, Noun) and theme.amount is None and theme.head != "patch"
    return whole and isinstance(theme, Noun) and (theme.det == "all" or (theme.det == "the" and theme.plural))


def _no_block(mark: Meaning) -> bool:
    """A patch, the table, or "it"."""
    patch = isinstance(mark, Noun) and mark.head == "patch" and not mark.plural
    return patch or isinstance(mark, TableTop) or (isinstance(mark, Pronoun) and mark.word == "it")
