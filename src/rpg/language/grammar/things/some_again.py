""" "Two red blocks, one red block on the patch": a lot, and some of it, where who means three counts them at once."""

from __future__ import annotations

from itertools import pairwise

from rpg.language.meaning import Meaning, Noun, Traits


def some_again(items: tuple[Meaning, ...]) -> bool:
    """Whether blocks of one look are counted twice in a row in a list."""
    return any(_of_it(lot, other) for lot, other in pairwise(items))


def _of_it(lot: Meaning, other: Meaning) -> bool:
    if not isinstance(lot, Noun) or not isinstance(other, Noun) or lot.traits == Traits():
        return False
    counted = lot.amount is not None and lot.amount.low > 1 and other.amount is not None
    plain = lot.head == other.head == "block" and lot.det == other.det == "bare" and not other.conditions
    return counted and plain and lot.traits == other.traits
