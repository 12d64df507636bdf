"""One kind of symbol before the other in a line, and what is sorted within each of them."""

from __future__ import annotations

import string

from rpg.core.diagnostics import Refusal, Span
from rpg.ir.order import Order
from rpg.language.meaning import Meaning, OrderBy
from rpg.passes.schema.resolve.orders.agreeing import Ranks, sorted_ranks
from rpg.passes.schema.resolve.things.things import quality_fits
from rpg.passes.schema.resolve.things.world import Scene, Thing, refuse

SORTING = ("label", "number", "ascending")


def check_which_sorted(orders: list[OrderBy]) -> None:
    """Refuse "first the vowels and then the consonants in alphabetical order": are both sorted, or the last ones?"""
    for told in orders:
        pair = told.by.endswith("_first") and told.values and not told.items
        after = [o for o in orders if o.by in SORTING and 0 <= o.span[0] - told.span[1] <= 1] if pair else []
        if after:
            raise refuse("ambiguous", "is each of the two kinds in this order, or only the last one?", after[0].span,
                         "say 'each kind' before it, or name the order of either kind behind it")  # fmt: skip


def by_kind(order: OrderBy, things: list[Thing]) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The blocks of the kind that comes first, and the others; symbols are chosen where they were left open."""
    letters = order.by.startswith(("vowel", "consonant"))
    row = string.ascii_uppercase if letters else "123456789"
    taken = {t.label for t in things}
    for thing in things:
        if thing.label is None:
            thing.label = next(x for x in row if x not in taken)
            thing.kind = "letter" if letters else "digit"
            taken.add(thing.label)
    head = order.by.split("_")[0]
    one = tuple(t.name for t in things if quality_fits(t, head))
    two = tuple(t.name for t in things if t.name not in one)
    if not one or not two:
        raise refuse(
            "order-misfit",
            "all the blocks are of one sort, so that none comes before the other",
            order.span,
            "use blocks of both sorts",
        )
    return one, two


def each_sorted(kinds: Ranks, inner: tuple[Meaning, ...], things: list[Thing], scene: Scene) -> Ranks:
    """Each kind in its own order."""
    digits = {t.kind for t in things} <= {"digit", None}
    ranks: Ranks = ()
    for names, order in zip(kinds, inner, strict=True):
        by = getattr(order, "by", "")
        if by != "ascending" and (by == "number") != digits:
            raise _unfit(order.span)
        descending = getattr(order, "descending", False)
        found = sorted_ranks((names,), Order(by="number" if digits else "label", descending=descending), scene)
        ranks += found or (names,)
    return ranks


def _unfit(span: Span) -> Refusal:
    return refuse("misplaced", "this order does not fit these symbols", span, "say 'from small to large' of digits")
