""" "The blocks are stacked A on B on C", "make it C on B on A": a tower told by what lies on what."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Amount, Clause, Loc, Meaning, Noun, OrderBy, Pronoun, Structure, Traits

_BE = ("is", "are")
_STACKED = ("stacked up as", "stacked up :", "stacked up", "stacked as", "stacked like this :", "stacked so :",
            "stacked :", "stacked ,", "stacked", "piled up as", "piled up :", "piled up", "in a tower :",
            "in a stack :", "in a tower ,", "in a tower as", "in a stack as")  # fmt: skip
"""What stands before what lies on what."""
_THEY = frozenset({"they", "it", "these", "those"})


def told_piled(p: Parser, i: int, k: int, theme: Meaning, mode: str) -> Results[Clause]:
    """ "the blocks are stacked A on B on C", with its subject before k."""
    be = p.any_of(k, _BE)
    j = p.any_of(be, _STACKED) if be and _all_of_them(theme) else 0
    for first, places, end in _upright(p, j) if j else ():
        tower = _tower(p, j, end, first, places)
        lemma = "begun" if mode == "start" else ""
        yield Clause(verb="exist", lemma=lemma, theme=tower, mode="given", span=p.span(i, end)), end


def begun_piled(p: Parser, i: int, j: int, theme: Meaning) -> Results[Clause]:
    """ "the cubes start stacked as A on B on C", with what follows "start" at j."""
    k = p.any_of(j, _STACKED) if _all_of_them(theme) else 0
    for first, places, end in _upright(p, k) if k else ():
        tower = _tower(p, k, end, first, places)
        yield Clause(verb="exist", lemma="begun", theme=tower, mode="given", span=p.span(i, end)), end


def made_piled(p: Parser, i: int, j: int) -> Results[Clause]:
    """ "make it C on B on A", "restack them as C on B on A"."""
    for theme, k in simple(p, j):
        if not isinstance(theme, Pronoun) and not (isinstance(theme, Structure) and _all_of_them(theme)):
            continue
        for first, places, end in _upright(p, p.opt(k, "as", "to", "into")):
            span, word = p.span(i, end), p.span(i, i + 1)
            yield Clause(verb="place", lemma="put", theme=first, adjuncts=places, span=span, word=word), end


def _tower(p: Parser, j: int, end: int, first: Noun, places: tuple[Meaning, ...]) -> Structure:
    """The tower whose top block was named first."""
    below = [x.landmark for x in places if isinstance(x, Loc) and x.landmark is not None]
    order = OrderBy(by="named", items=(first, *below), first="top", span=p.span(j, end))
    return Structure(kind="stack", det="a", amount=Amount(1, 1), details=(order,), span=p.span(j, end))


def _all_of_them(theme: Meaning) -> bool:
    """ "They", "the blocks", "the tower": what the pile is made of."""
    if isinstance(theme, Pronoun):
        return theme.word in _THEY
    if isinstance(theme, Structure):
        return theme.kind == "stack" and theme.det == "the" and theme.members is None and not theme.plural
    return isinstance(theme, Noun) and theme.head == "block" and theme.det == "the" and theme.traits == Traits()


def _upright(p: Parser, j: int) -> Iterator[tuple[Noun, tuple[Meaning, ...], int]]:
    """One block on another, and so on."""
    for first, k in simple(p, j):
        if isinstance(first, Noun) and not first.plural and first.head != "patch":
            for places, end in adjuncts(p, k):
                if places and all(_on_block(x) for x in places):
                    yield first, places, end


def _on_block(place: Meaning) -> bool:
    mark = place.landmark if isinstance(place, Loc) and place.rel == "on" and not place.negated else None
    return isinstance(mark, Noun) and mark.head != "patch"
