"""What several clauses say together, told in full in each of them before they are read one by one."""

from __future__ import annotations

from rpg.language.meaning import Chain
from rpg.passes.schema.resolve.clauses.but_swapped import but_swapped
from rpg.passes.schema.resolve.clauses.left_over import left_over
from rpg.passes.schema.resolve.clauses.uncovered import uncovered


def told_fully(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    return uncovered(but_swapped(left_over(chains)))
