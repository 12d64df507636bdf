"""Blocks that are among those named in front of a colon."""

from __future__ import annotations

from rpg.language.meaning import Absolute, Amount, Clause, Noun, parts_of
from rpg.passes.schema.resolve.things.world import refuse


def check_further_ones(clause: Clause) -> None:
    """Refuse "two red blocks and a blue one: one red block is on it" as it stands: one of those, and no further one."""
    lots = {x.traits for x in parts_of(clause.theme) if isinstance(x, Noun) and x.plural and x.amount}
    told = [x.theme for x in parts_of(clause.adjuncts) if isinstance(x, Absolute)] if clause.verb == "be" else []
    if any(isinstance(x, Noun) and x.amount == Amount(1, 1) and x.traits in lots for x in told):
        raise refuse("ambiguous", "one of these blocks, or a further one?", clause.span, "say 'one of the ...'")
