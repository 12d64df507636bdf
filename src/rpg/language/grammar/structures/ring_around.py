"""Outlines told by the block inside of them: "a circle of blue blocks around the red one"."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from rpg.language.grammar.core import Parser
from rpg.language.later import later
from rpg.language.meaning import Absolute, Amount, At, Meaning, Noun, Structure, replace

if TYPE_CHECKING:
    from rpg.language.grammar.things.nouns import simple
else:
    (simple,) = later(__name__, "rpg.language.grammar.things.nouns", "simple")

_AROUND = ("around", "all around", "round", "surrounding", "enclosing", "that surrounds", "which surrounds")
_MARKS = frozenset({"around", "round", "surrounding", "enclosing", "surrounds"})
_OUTLINES = ("circle", "square")


def ring_around(p: Parser, i: int, j: int, shape: Meaning) -> Iterator[tuple[Structure, int]]:
    """The outline with that block in its middle, behind its noun."""
    if not p.anywhere(_MARKS) or not isinstance(shape, Structure) or shape.kind not in _OUTLINES or shape.plural:
        return
    for hub, k in simple(p, around) if (around := p.any_of(j, _AROUND)) else ():
        if isinstance(hub, Noun) and hub.head != "patch" and not hub.plural and hub.amount in (None, Amount(1, 1)):
            inside = At(side="middle", whole=shape.kind, span=hub.span)
            middle = Absolute(theme=replace(hub, head="block"), adjuncts=(inside,), span=hub.span)
            yield replace(shape, details=(*shape.details, middle), span=p.span(i, k)), k
