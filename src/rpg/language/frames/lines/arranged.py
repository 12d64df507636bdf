"""The order of the blocks of a row, as far as it follows from what is told of their places and their pattern."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import permutations

from rpg.language.frames.pieces import Unclear
from rpg.language.lexicon import RAINBOW

Fact = tuple[str, int, str, int]
"""What is told of a place: its name, the number from there, the look, and how many blocks."""
OPPOSITE = {"left": "right", "right": "left", "front": "back", "back": "front"}


def filled(size: int, facts: Sequence[Fact], near: str, first: str) -> list[str]:
    """The places of a row from the end `near`, "" where it is not told what is there. `first`: the end where reading
    begins.

    Raises:
        Unclear: two looks at one place, or no such place.
    """
    slots = [""] * size
    middle = sum(many for name, _, _, many in facts if name == "middle")
    for name, nth, look, many in facts:
        end = {"first": first, "last": OPPOSITE[first]}.get(name, name)
        if end in OPPOSITE:
            if end not in (near, OPPOSITE[near]):
                raise Unclear
            at = [nth - 1 + k for k in range(many)]
            at = at if end == near else [size - 1 - n for n in at]
        elif name == "middle":
            if (size - many) % 2:
                raise Unclear
            at = [(size - many) // 2 + k for k in range(many)]
        elif name in ("ends", "each end"):
            at = [0, size - 1]
        elif name == "sides":
            if not middle or many % 2 or (size - middle) % 2:
                raise Unclear
            low = (size - middle) // 2
            at = [low - 1 - k for k in range(many // 2)] + [low + middle + k for k in range(many // 2)]
        else:
            raise Unclear
        for n in at:
            if not 0 <= n < size or slots[n]:
                raise Unclear
            slots[n] = look
    return slots


def completed(slots: Sequence[str], counts: Counter[str], pattern: str) -> list[list[str]]:
    """Every order of the blocks in which the told places are as told; at most two of them, for more are no answer.

    Raises:
        Unclear: there is none.
    """
    found: list[list[str]] = []
    for order in _orders(slots, counts, pattern):
        if order not in found and all(told in ("", look) for told, look in zip(slots, order, strict=True)):
            found.append(order)
        if len(found) > 1:
            break
    if not found:
        raise Unclear
    return found


def follows(slots: Sequence[str], counts: Counter[str], pattern: str) -> bool:
    """Whether what is told of places is so in every order with the pattern, as what is in the middle of a mirrored row
    of which there is an odd number."""
    orders = list(_orders([""] * len(slots), counts, pattern))
    return all(told in ("", look) for order in orders for told, look in zip(slots, order, strict=True))


def _orders(slots: Sequence[str], counts: Counter[str], pattern: str) -> Iterator[list[str]]:
    """The orders with a pattern; without one, those that fill what is left."""
    looks, size = list(counts), len(slots)
    if pattern == "alternating":
        for turn in permutations(looks):
            yield [turn[n % len(turn)] for n in range(size)]
    elif pattern == "rainbow":
        order = [look for look in RAINBOW if look in counts]
        if len(order) < len(counts) or any(many > 1 for many in counts.values()):
            raise Unclear
        yield from (order, order[::-1])
    elif pattern == "grouped":
        for turn in permutations(looks):
            yield [look for look in turn for _ in range(counts[look])]
    elif pattern == "mirrored":
        yield from _mirrored(slots, counts)
    else:
        left = counts - Counter(slots)
        if len(left) > 1:
            yield from ([next(iter(left))], [next(iter(left))] * 2)  # more than one order
        rest = iter(left.elements())
        yield [told or next(rest) for told in slots]


def _mirrored(slots: Sequence[str], counts: Counter[str]) -> Iterator[list[str]]:
    """The orders that read the same from both ends."""
    odd = [look for look, many in counts.items() if many % 2]
    half = [look for look, many in counts.items() for _ in range(many // 2)]
    if len(odd) != len(slots) % 2 or len(half) > 5:
        raise Unclear
    for turn in permutations(half):
        yield [*turn, *odd, *reversed(turn)]
