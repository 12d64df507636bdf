"""Lists that tell again what was counted: "two blocks, one red and one blue"."""

from __future__ import annotations

from rpg.language.meaning import Meaning, Noun, Traits


def tally(items: tuple[Meaning, ...]) -> int:
    """How many blocks "red, blue and two green ones" are; 0 where an item is no such description."""
    total = 0
    for item in items:
        if not (isinstance(item, Noun) and item.head == "any" and item.traits != Traits()):
            return 0
        total += item.amount.low if item.amount is not None else 1
    return total


def retold(items: tuple[Meaning, ...]) -> bool:
    """ "two blocks, one red and one blue": the list tells the first item again, it does not add to it."""
    whole = items[0]
    if not isinstance(whole, Noun) or whole.traits != Traits() or whole.amount is None or len(items) < 3:
        return False
    return tally(items[1:]) == whole.amount.low
