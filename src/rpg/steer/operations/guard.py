"""What a phrase says must be used or refused: nothing that was said is passed over."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import fields

from rpg.core.diagnostics import Diagnostic, Refusal, Span
from rpg.steer.requests.language import m

DESCRIBES = frozenset({"colors", "labels", "kind", "edge", "size", "scheme", "extra", "shade", "target"})
"""Traits that make a new block."""
PATCHES = frozenset({"colors", "shape", "long", "extent", "edge", "size", "shade", "target", "extra"})
"""Traits that make a new patch."""
SELECTS = frozenset(
    {
        "colors",
        "either",
        "labels",
        "kind",
        "quality",
        "edge",
        "size",
        "rank",
        "extra",
        "shade",
        "target",
        "shape",
        "long",
    }
)
"""Traits that pick objects of the task."""
_PLAIN = m.Traits()


def unused(traits: m.Traits, used: Collection[str]) -> tuple[str, ...]:
    """The traits that are said and not among `used`."""
    told = (field.name for field in fields(m.Traits) if getattr(traits, field.name) != getattr(_PLAIN, field.name))
    return tuple(name for name in told if name not in used)


def check_new(phrase: m.Noun) -> None:
    """Refuse a description of a new object that says more than what it looks like."""
    used = PATCHES if phrase.head == "patch" else DESCRIBES
    amount = phrase.amount
    vague = amount is not None and amount.high != amount.low
    if unused(phrase.traits, used) or phrase.conditions or phrase.part_of is not None or vague:
        raise _refused(phrase.span, "a new block is described by its colour, symbol, size and number alone")


def check_picked(phrase: m.Noun) -> None:
    """Refuse a description that picks objects by something that a task does not tell."""
    scheme = phrase.traits.scheme in (None, "some")
    if unused(phrase.traits, SELECTS | ({"scheme"} if scheme else set())):
        raise _refused(phrase.span, "blocks are picked by their colour, symbol, size or place")
    if any((isinstance(c, m.Loc) and c.negated) or not isinstance(c, m.Loc) for c in phrase.conditions):
        raise _refused(phrase.span, "blocks are picked by what they are on, above or beside")


def check_shape(phrase: m.Structure, sizes_used: bool) -> None:
    """Refuse a structure that says more than its kind and its size."""
    extra = phrase.details or unused(phrase.traits, ("target",)) or (phrase.amount and phrase.amount.low > 1)
    if extra or phrase.plural or phrase.each_size or (phrase.sizes and not sizes_used):
        raise _refused(phrase.span, "this says more than the blocks of the task can be turned into")


def _refused(span: Span, message: str) -> Refusal:
    hint = "say the rest as a request of its own, or give the whole instruction"
    return Refusal([Diagnostic(code="edit-unclear", message=message, span=span, hint=hint, origin="steer")])
