"""How large a figure is, told by its sides or by how wide it is: "a square with sides of 20 cm"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.places.measures import bounds
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import Loc, Pronoun

_OUTLINES = frozenset({"square", "triangle", "circle", "ring"})
_SIDES = Patterns(
    ",? with|of|having|whose|each|every? a|the|its? every|each? side|sides|side_length|side_lengths "
    "of|is|are|being|measuring?",
    ",? each|every side of|is|measures|measuring|being?",
)
_WIDTH = Patterns(",? with|of|having|whose? a|the|its? diameter|width of|is?")
_RADIUS = Patterns(",? with|of|having|whose? a|the|its? radius of|is?")
_LEADS = (("side", _SIDES), ("across", _WIDTH), ("radius", _RADIUS))
"""What the length of a side follows, or that from one side to the other."""
_PER_SIDE = Patterns(
    "on|along|at each|every|a side", "per side", "sides|side_length", "long on|along each|every side",
)  # fmt: skip
_ACROSS = Patterns("across|wide", "in? diameter", "from side to side")
_OF_RADIUS = Patterns("in? radius")
_BEHIND = (("side", _PER_SIDE), ("across", _ACROSS), ("radius", _OF_RADIUS))
"""What follows it."""
_BEFORE = Patterns(",? with|of|that_is|which_is|having|measuring|each|about?")


@choice
def side_length(p: Parser, i: int) -> Results[Loc]:
    """ "(a square) with sides of 20 cm", ", 20 cm on each side", "(a circle) 20 cm across"."""
    if not p.rarely(_OUTLINES):
        return
    for measure, leads in _LEADS:
        for j in leads.matches(p, i):
            for (low, high), k in bounds(p, j) if _of_an_outline(p, i) else ():
                end = p.opt(k, "long", "each")
                yield _size(p, i, end, low, high, measure), end
    for begin in {i, p.opt(i, ","), *_BEFORE.matches(p, i)}:
        for (low, high), j in bounds(p, begin):
            for measure, behind in _BEHIND if _of_an_outline(p, i) else ():
                for k in behind.matches(p, j):
                    yield _size(p, i, k, low, high, measure), k


def _of_an_outline(p: Parser, i: int) -> bool:
    """Whether the last figure named before is one, and no patch."""
    named = [k for k in range(i) if p.words[k] in _OUTLINES]
    return bool(named) and p.words[named[-1] + 1] not in lexicon.PATCH


def _size(p: Parser, i: int, j: int, low: float | None, high: float | None, measure: str) -> Loc:
    span = p.span(i, j)
    return Loc(rel="distance", landmark=Pronoun(word="each other", span=span), low=low, high=high, measure=measure,
               span=span)  # fmt: skip
