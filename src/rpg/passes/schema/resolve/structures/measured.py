"""Outlines with a length in front of their noun: "a 20 cm square", whose sides are so long."""

from __future__ import annotations

from rpg.language.meaning import Loc, Pronoun, Structure, replace
from rpg.passes.schema.resolve.clauses.spec import Spec

_MEASURES = {"square": "side", "triangle": "side", "circle": "across"}
_SLACK = 0.01
"""How much more or less such a length may be, in metres."""


def with_length(shape: Structure, spec: Spec) -> Structure:
    """The outline without the length, which is said of it beside other places."""
    edge, measure = shape.traits.edge, _MEASURES.get(shape.kind)
    if edge is None or measure is None or shape.plural:
        return shape
    each = Pronoun(word="each other", span=shape.span)
    low, high = round(edge - _SLACK, 6), round(edge + _SLACK, 6)
    spec.places.append(Loc(rel="distance", landmark=each, low=low, high=high, measure=measure, span=shape.span))
    return replace(shape, traits=replace(shape.traits, edge=None))
