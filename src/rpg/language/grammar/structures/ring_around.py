"""Outlines told by the block inside of them: "a circle of blue blocks around the red one"."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from rpg.core.diagnostics import Span
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.adjectives import color
from rpg.language.later import later
from rpg.language.meaning import Absolute, Amount, At, Meaning, Noun, Structure, Traits, replace

if TYPE_CHECKING:
    from rpg.language.grammar.structures.structures import structure
    from rpg.language.grammar.things.nouns import simple
else:
    (structure,) = later(__name__, "rpg.language.grammar.structures.structures", "structure")
    (simple,) = later(__name__, "rpg.language.grammar.things.nouns", "simple")

_AROUND = ("around", "all around", "round", "surrounding", "enclosing", "that surrounds", "which surrounds")
_AROUND_IT = tuple(f"{joint}{around} it" for joint in ("", "and ", ", and ", ", ", "with ") for around in (
    "around", "all around", "round"))  # fmt: skip
_IT = ("around it", "all around it", "round it", "surrounding it")
_MARKS = frozenset({"around", "round", "surrounding", "enclosing", "surrounds"})
_OUTLINES = ("circle", "square")


def ring_around(p: Parser, i: int, j: int, shape: Meaning) -> Iterator[tuple[Structure, int]]:
    """The outline with that block in its middle, behind its noun."""
    if not p.anywhere(_MARKS) or not isinstance(shape, Structure) or shape.kind not in _OUTLINES or shape.plural:
        return
    for hub, k in simple(p, around) if (around := p.any_of(j, _AROUND)) else ():
        if isinstance(hub, Noun) and _is_hub(hub):
            yield _ringed(shape, hub, p.span(i, k)), k


@choice
def with_a_ring(p: Parser, i: int) -> Results[Structure]:
    """ "A white cube and around it a square of eight orange ones": the same the other way round."""
    if not p.stands(i, ("a", "an", "the")) or not p.anywhere(_MARKS):
        return
    det = "the" if p.stands(i, ("the",)) else "a"
    for named, j in color(p, i + 1):
        k = p.opt(j, "block", "cube", "brick", "one")
        hub = Noun(head="block", det=det, amount=Amount(1, 1), traits=Traits(colors=(named,)), span=p.span(i, k))
        around = p.any_of(k, _AROUND_IT)
        inside = p.any_of(k, ("with", "and")) if not around else 0
        for shape, end in structure(p, around or inside) if around or inside else ():
            end = end if around else p.any_of(end, _IT)
            if (
                end
                and isinstance(shape, Structure)
                and shape.kind in _OUTLINES
                and shape.det == "a"
                and not shape.plural
            ):
                yield _ringed(shape, hub, p.span(i, end)), end


def _is_hub(hub: Noun) -> bool:
    one = hub.amount == Amount(1, 1) or (hub.amount is None and hub.det in ("a", "the"))
    return one and hub.head != "patch" and not hub.plural and hub.det in ("a", "the", "bare")


def _ringed(shape: Structure, hub: Noun, span: Span) -> Structure:
    inside = At(side="middle", whole=shape.kind, span=hub.span)
    middle = Absolute(theme=replace(hub, head="block"), adjuncts=(inside,), span=hub.span)
    return replace(shape, details=(*shape.details, middle), span=span)
