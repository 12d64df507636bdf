""" "Take the yellow one out of the row and close the gap": a block leaves the line that it is part of."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.structures.structures import structure
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import Clause, Loc, Meaning, Noun, Pronoun, Spacing, Structure

_FROM = ("out of", "out from", "from", "off")
_OUT = frozenset({"out", "away"})
_KINDS = frozenset({"row", "line", "column", "stack"})
_CLOSE = Patterns(
    ",? and|then|, close up? the|any gap|hole|space that_is_left|left_behind?",
    ",? and|then|, close it|them up", ",? and|then|, push|move|slide the rest|others|other_cubes|other_blocks together",
    ",? closing the gap|hole",
)  # fmt: skip
"""What closes the gap that a block leaves."""
_IT = frozenset({"it", "them"})
_TAKING = frozenset({"remove", "take", "pull", "get", "move", "pick", "lift"})


def out_of_line(p: Parser, i: int, k: int, theme: Meaning) -> Results[Clause]:
    """What follows a verb of taking and its theme, which ends at k."""
    lemma = p.words[i]
    if lemma not in _TAKING or not isinstance(theme, Noun | Pronoun):
        return
    for places, j in _sources(p, i, k):
        ends = [(True, end) for end in _CLOSE.matches(p, j)] + ([(False, j)] if j >= p.end else [])
        for closed, end in ends:
            gap = (Spacing(kind="closed", span=p.span(j, end)),) if closed else ()
            span, word = p.span(i, end), p.span(i, i + 1)
            out = Clause(verb="remove", lemma="out", theme=theme, adjuncts=(*places, *gap), span=span, word=word)
            yield out, end


def _sources(p: Parser, i: int, k: int) -> Results[tuple[Meaning, ...]]:
    """The line that is left; nothing where it is not named: "take the yellow one out", "remove it"."""
    j = p.any_of(k, _FROM)
    if j and p.stands(j, _IT):
        yield (
            (Loc(rel="off", landmark=Pronoun(word="it", span=p.span(j, j + 1)), span=p.span(k, j + 1)),),
            p.reach(j + 1),
        )
    for whole, end in structure(p, j) if j else ():
        known = isinstance(whole, Structure) and whole.det == "the" and not whole.plural and whole.members is None
        if known and isinstance(whole, Structure) and whole.kind in _KINDS:
            yield (Loc(rel="off", landmark=whole, span=p.span(k, end)),), end
    out = p.one(k, _OUT) or (k if p.follows(k, _OUT) or p.stands(i, ("remove",)) or p.stands(i + 1, _OUT) else 0)
    if out:
        yield (), out
