"""Quantities of several counted kinds: "none of the two white and two black blocks"."""

from __future__ import annotations

from rpg.language.meaning import Coord, Meaning, Noun


def of_both(first: Meaning, item: Meaning) -> bool:
    """Whether what follows "none of the two white" goes with these, and is nothing of its own: "and two black blocks",
    "and the black block"."""
    whole = first.part_of if isinstance(first, Noun) else None
    if not isinstance(first, Noun) or not isinstance(whole, Noun) or whole.det != "the":
        return False
    return _goes_on(item, first.det) and (first.det == "no" or (whole.head == "any" and whole.amount is not None))


def counted_kinds(found: Meaning, det: str) -> bool:
    """ "the two white and two black blocks": of all of them is spoken, of which so many are meant."""
    return isinstance(found, Coord) and found.op == "and" and all(_goes_on(item, det) for item in found.items[1:])


def _goes_on(item: Meaning, det: str) -> bool:
    if not isinstance(item, Noun) or item.part_of is not None:
        return False
    return (item.det == "bare" and item.amount is not None) or (det == "no" and item.det in ("the", "bare"))
