"""Clauses of which the one before tells more than they say: those without a verb, and "rebuild it"."""

from __future__ import annotations

from itertools import pairwise

from rpg.language.grammar.clauses.verb_again import alike, in_an_order, merely_placed, several
from rpg.language.meaning import (
    At,
    Chain,
    Clause,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Structure,
    Traits,
    Using,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse


def check_order_again(chain: Chain) -> None:
    """Refuse "sort A, C and B, and behind them 3, 1 and 2": these could be in an order, too."""
    told = [x for x in chain.clauses if isinstance(x, Clause)]
    for before, item in pairwise(told):
        _check_spared(before, item)
        ordered = before.verb in ("sort", "arrange", "stack") and before.mode == "command" and in_an_order(before)
        again = replace(item, verb="be", mode="goal", word=None) if item.word == before.word else item
        if ordered and merely_placed(again) and several(item.theme) and not alike(item.theme):
            raise refuse("ambiguous", "are these in an order as well, or merely there?", item.span,
                         "say 'put ... there', or in which order they are")  # fmt: skip


def _check_spared(before: Clause, item: Clause) -> None:
    """Refuse "clear the red mat but not the blue one": a mat, or a block?"""
    mark, spared = before.theme, item.theme
    patch = isinstance(mark, Noun) and mark.head == "patch" and before.verb == "remove"
    if patch and item.lemma == "spare" and isinstance(spared, Noun) and (spared.head, spared.det) == ("any", "the"):
        raise refuse("ambiguous", "this could be a block or a patch", spared.span, "say 'block' or 'patch'")


def check_rebuilt(clause: Clause, told: bool) -> None:
    """Refuse "rebuild this tower with green on top" where nothing is said of what it is made of."""
    shape = clause.theme
    if clause.lemma != "rebuild" or told or not isinstance(shape, Structure) or shape.det != "the" or shape.members:
        return
    if not any(isinstance(part, OrderBy | Using) for part in parts_of(clause)):
        raise refuse("no-referent", "nothing is told of what is to be built again", shape.span,
                     "say how it starts: 'there is a tower with red on blue'")  # fmt: skip


def check_borne_again(chain: Chain) -> None:
    """Refuse "the leftmost has a blue one on it and the rightmost a green one": this is on it, or is the rightmost?"""
    told = [x for x in parts_of(chain) if isinstance(x, Clause) and x.verb == "be" and len(x.adjuncts) == 1]
    borne = any(_on_an_end(x.adjuncts[0]) for x in told)
    for item in told if borne else ():
        side, theme = item.adjuncts[0], item.theme
        bare = item.word is None and isinstance(theme, Noun) and theme.det == "a"
        if bare and theme is not None and isinstance(side, At) and side.utmost and side.span < theme.span:
            raise refuse("ambiguous", "is it there, or does the block there have it?", item.span,
                         "say 'has ... on it' once more")  # fmt: skip


def _on_an_end(place: Meaning) -> bool:
    mark = place.landmark if isinstance(place, Loc) else None
    return isinstance(mark, Noun) and mark.traits.rank is not None and mark.traits == Traits(rank=mark.traits.rank)
