""" "Turn the row A B C into C B A": the order that the line has at the start, and the one that it gets."""

from __future__ import annotations

import re

from rpg.language.meaning import Chain, Clause, Into, Meaning, OrderBy, Structure, replace

_INTO = re.compile(r"\binto\b", re.IGNORECASE)


def into_an_order(chain: Chain, text: str) -> Chain:
    """The sentence with what a line that is told block by block is turned into as another such line."""
    clauses = tuple(_turned(clause, text) for clause in chain.clauses)
    return chain if clauses == chain.clauses else replace(chain, clauses=clauses)


def _turned(clause: Meaning, text: str) -> Meaning:
    line = clause.theme if isinstance(clause, Clause) and clause.verb == "arrange" and not clause.negated else None
    if not isinstance(clause, Clause) or not isinstance(line, Structure) or line.det != "the" or line.plural:
        return clause
    begun = [d for d in line.details if isinstance(d, OrderBy) and d.by == "named" and d.items]
    order = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    listed = isinstance(order, OrderBy) and order.by in ("given", "named") and bool(order.items)
    if not begun or not listed or not isinstance(order, OrderBy):
        return clause
    if _INTO.search(text[line.span[1] - 1 : order.items[0].span[0]]) is None:
        return clause
    ended = Structure(kind=line.kind, det="the", details=(replace(order, by="named"),), span=order.span)
    return replace(clause, lemma="turn into", adjuncts=(Into(structure=ended, span=order.span),))
