"""Blocks that stand behind others which are put in an order."""

from __future__ import annotations

from itertools import pairwise

from rpg.language.grammar.clauses.verb_again import alike, in_an_order, merely_placed, several
from rpg.language.meaning import Chain, Clause, replace
from rpg.passes.schema.resolve.things.world import refuse


def check_order_again(chain: Chain) -> None:
    """Refuse "sort A, C and B, and behind them 3, 1 and 2": these could be in an order, too."""
    told = [x for x in chain.clauses if isinstance(x, Clause)]
    for before, item in pairwise(told):
        ordered = before.verb in ("sort", "arrange", "stack") and before.mode == "command" and in_an_order(before)
        again = replace(item, verb="be", mode="goal", word=None) if item.word == before.word else item
        if ordered and merely_placed(again) and several(item.theme) and not alike(item.theme):
            raise refuse("ambiguous", "are these in an order as well, or merely there?", item.span,
                         "say 'put ... there', or in which order they are")  # fmt: skip
