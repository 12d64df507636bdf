"""Sentences that say when: "Put red on blue last. Put green on yellow first."."""

from __future__ import annotations

from itertools import pairwise

from rpg.core.diagnostics import Span
from rpg.language.meaning import Chain, Clause, Meaning
from rpg.passes.schema.resolve.clauses.chains import time_of, unsaid
from rpg.passes.schema.resolve.things.world import refuse


def in_time(links: list[str], chains: tuple[Chain, ...], spans: Span) -> tuple[list[str], tuple[int, ...]]:
    """Sentences that say when ("..., last"): how each follows the one before it, and in which order they come."""
    done = [[c for c in chain.clauses if getattr(c, "mode", "") not in ("start", "given")] for chain in chains]
    said = [time_of(clauses[0]) if len(clauses) == 1 else None for clauses in done]
    if all(when is None for when in said):
        asked = [n for n, chain in enumerate(chains) if any(map(_asks, chain.clauses))]
        if links[:1] == ["then"] and asked[:1] == [0] and [links[n] for n in asked[1:]].count("and"):
            raise refuse("ambiguous", "it is not clear what comes before this, and what is done with it",
                         chains[0].span, "say all in the order in which it is done")  # fmt: skip
        return links, tuple(range(len(chains)))
    if "before" in links:
        raise refuse("ambiguous", "one sentence says that it comes before another, one that it is first or last",
                     chains[links.index("before")].span, "say all in the order in which it is done")  # fmt: skip
    if len(chains) == 1 and (said[0] or 0.0) > 1.0:
        raise refuse(
            "misplaced", "this speaks of an order in time, but nothing else is to be done", spans, "leave the word out"
        )
    times: list[float] = []
    for when in said:
        times.append(when if when is not None else unsaid(times))
    order = tuple(sorted(range(len(times)), key=lambda n: (times[n], n)))
    joined = ["and"] * len(times)
    for before, after in pairwise(order):
        joined[after] = "then" if times[before] != times[after] else links[after]
    return joined, order


def _asks(clause: Meaning) -> bool:
    return isinstance(clause, Clause) and clause.mode in ("command", "goal") and not clause.negated
