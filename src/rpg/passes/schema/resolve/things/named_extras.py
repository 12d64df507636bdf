"""Distractors that are counted and then named: "two distractors, one green and one yellow" are two, not four."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Coord, Meaning, Noun, Traits, replace
from rpg.passes.schema.resolve.things.world import refuse


def named_extras(chain: Chain) -> Chain:
    """The sentence with the distractors that are named in the place of their number."""
    clauses = tuple(_named(c) if isinstance(c, Clause) and isinstance(c.theme, Coord) else c for c in chain.clauses)
    return chain if clauses == chain.clauses else replace(chain, clauses=clauses)


def _named(clause: Clause) -> Clause:
    theme = clause.theme
    if not isinstance(theme, Coord) or theme.op != "and" or not _counted(theme.items[0]):
        return clause
    first, *rest = theme.items
    if not all(isinstance(x, Noun) and x.amount is not None and not x.traits.extra for x in rest):
        return clause
    told = [x.amount.low for x in rest if isinstance(x, Noun) and x.amount is not None]
    if not isinstance(first, Noun) or first.amount is None or sum(told) != first.amount.low:
        raise refuse("ambiguous", "are these the distractors, or further blocks?", rest[0].span,
                     "say what each distractor looks like")  # fmt: skip
    extra = (replace(x, traits=replace(x.traits, extra=True)) for x in rest if isinstance(x, Noun))
    return replace(clause, theme=replace(theme, items=tuple(extra)))


def _counted(item: Meaning) -> bool:
    """ "two distractors", of which no look is said."""
    many = isinstance(item, Noun) and item.amount is not None and item.amount.low == item.amount.high != 1
    return many and isinstance(item, Noun) and item.traits == Traits(extra=True)
