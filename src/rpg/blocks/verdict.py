"""The value of a goal on a state: whether it holds, and by how much."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import NamedTuple


class Verdict(NamedTuple):
    """`value` and its `margin`: the slack over the tolerance; not negative when true, not positive when false.

    Verdicts combine with `&` (least margin), `|` (greatest) and `~`.
    """

    value: bool
    margin: float

    def __bool__(self) -> bool:
        return self.value

    def __and__(self, other: Verdict) -> Verdict:
        return every((self, other))

    def __or__(self, other: Verdict) -> Verdict:
        return some((self, other))

    def __invert__(self) -> Verdict:
        return Verdict(not self.value, -self.margin)


TRUE = Verdict(True, 1.0)
FALSE = Verdict(False, -1.0)


def as_verdict(value: Verdict | bool) -> Verdict:
    """What a hook returns; a plain truth value has no slack to tell of."""
    if isinstance(value, Verdict):
        return value
    if isinstance(value, bool):
        return Verdict(value, 1.0 if value else -1.0)
    raise TypeError(f"_success and _fail return a verdict, not {value!r}")


ROUNDING = 1e-6
"""Exactly at a tolerance counts as within it, whatever the last bits of a sum of floats say."""


def holds(margin: float) -> Verdict:
    """A verdict from a margin: true when it is not negative."""
    return Verdict(True, margin if margin > 0.0 else 0.0) if margin >= -ROUNDING else Verdict(False, margin)


def at_most(value: float, limit: float, scale: float | None = None) -> Verdict:
    """`value <= limit`, with the slack over `scale` (the limit itself unless given)."""
    return holds((limit - value) / (scale or limit or 1.0))


def at_least(value: float, limit: float, scale: float | None = None) -> Verdict:
    """`value >= limit`, with the slack over `scale` (the limit itself unless given)."""
    return holds((value - limit) / (scale or limit or 1.0))


def every(verdicts: Iterable[Verdict]) -> Verdict:
    """All hold; the least margin. An empty conjunction holds."""
    held, broken = math.inf, math.inf
    for value, margin in verdicts:
        if value:
            if margin < held:
                held = margin
        elif margin < broken:
            broken = margin
    if broken < math.inf:
        return Verdict(False, broken)
    return Verdict(True, held) if held < math.inf else TRUE


def some(verdicts: Iterable[Verdict]) -> Verdict:
    """At least one holds; the greatest margin. An empty disjunction does not hold."""
    held, broken = -math.inf, -math.inf
    for value, margin in verdicts:
        if value:
            if margin > held:
                held = margin
        elif margin > broken:
            broken = margin
    if held > -math.inf:
        return Verdict(True, held)
    return Verdict(False, broken) if broken > -math.inf else FALSE


def between(count_at_least: int, count_at_most: int | None, verdicts: Iterable[Verdict]) -> Verdict:
    """At least / at most so many of `verdicts` hold."""
    ranked = sorted(verdicts, key=lambda v: (v.value, v.margin), reverse=True)
    parts = []
    if count_at_least > 0:
        parts.append(ranked[count_at_least - 1] if count_at_least <= len(ranked) else FALSE)
    if count_at_most is not None and count_at_most < len(ranked):
        parts.append(~ranked[count_at_most])
    return every(parts)
