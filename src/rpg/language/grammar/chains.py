"""Chains of clauses: "and", "then", "or", "before", commas."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.grammar.clauses import clause
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.frames import THEN
from rpg.language.grammar.inventory import inventory
from rpg.language.grammar.nouns import noun_phrase, restates
from rpg.language.grammar.verbs import gapped, gerund_clause, gerund_single
from rpg.language.meaning import Chain, Clause, Meaning, Structure

_LEADS = (("after", False), ("once", False), ("as soon as", False), ("when", False), ("before", True))
"""What stands before the clause that comes first in time, or (True) after the other one."""


@rule
def chain(p: Parser, i: int) -> Results[Chain]:
    """Clauses joined by "and", "then", "or", "before", commas."""
    for lead, late in _LEADS:
        if j := p.seq(i, lead):
            j = p.opt(j, "you", "that")
            fronts = [*gerund_clause(p, j), *chain(p, j)]
            for front, k in fronts:
                for main, end in chain(p, p.one(k, ",") or k) if k < p.end else ():
                    both = (main, front) if late else (front, main)
                    clauses = (*both[0].clauses, *both[1].clauses)
                    links = (*both[0].links, "then", *both[1].links[1:])
                    yield Chain(clauses=clauses, links=links, span=p.span(i, end), cost=1), end
    if j := p.one(i, "either"):
        yield from ((found, k) for found, k in chain(p, j) if "or" in found.links)
    for first, j in clause(p, i):
        yield Chain(clauses=(first,), links=("and",), span=p.span(i, j)), j
        yield from _more(p, i, (first,), ("and",), j)


def _more(p: Parser, i: int, had: tuple[Meaning, ...], links: tuple[str, ...], at: int) -> Results[Chain]:
    if len(had) > 16:
        return
    if colon := p.one(at, ":"):
        for item, k in inventory(p, colon):
            whole = (*had, item)
            yield Chain(clauses=whole, links=(*links, "and"), span=p.span(i, k)), k
            yield from _more(p, i, whole, (*links, "and"), k)
    for link, j in _link(p, at):
        previous = had[-1] if isinstance(had[-1], Clause) else None
        items = [*clause(p, j), *(gerund_single(p, j) if link in ("before", "after") else ())]
        bare = previous is not None and not previous.adjuncts and link == "and" and p.words[j - 1] in (",", ";")
        for item, k in items:
            if previous is not None and p.words[j - 1] == "," and _apposed(previous, item):
                continue
            if bare and isinstance(item, Clause) and item.cost and not isinstance(item.theme, Structure):
                item = replace(item, cost=item.cost + 2)
            whole = (*had, item)
            yield Chain(clauses=whole, links=(*links, link), span=p.span(i, k)), k
            yield from _more(p, i, whole, (*links, link), k)
        if previous is not None:
            denied = p.words[p.opt(at, ",")] == "but" if p.opt(at, ",") < p.end else False
            if link in ("before", "after"):
                for theme, k in noun_phrase(p, j):
                    whole = (*had, replace(previous, theme=theme, span=p.span(j, k)))
                    yield Chain(clauses=whole, links=(*links, link), span=p.span(i, k)), k
            for item, k in gapped(p, j, replace(previous, negated=False) if denied else previous):
                if p.words[j - 1] == "," and _apposed(previous, item):
                    continue
                whole = (*had, item)
                yield Chain(clauses=whole, links=(*links, link), span=p.span(i, k)), k
                yield from _more(p, i, whole, (*links, link), k)


def _apposed(before: Clause, item: Meaning) -> bool:
    """ "make a square of red blocks, three rows of three": a comma alone brings no structure without blocks of its own."""
    theme = item.theme if isinstance(item, Clause) and not item.adjuncts else None
    return isinstance(before.theme, Structure) and isinstance(theme, Structure) and restates(before.theme, theme)


def _link(p: Parser, i: int) -> Results[str]:
    j = p.opt(i, ",", ";")
    if k := p.any_of(j, ("but first", "but before that", "and before that", "but only after")):
        yield "after", p.opt(k, ",")
    elif (k := p.any_of(j, THEN)) and not (p.words[k - 1] == "next" and p.words[k] == "to"):
        yield "then", p.opt(k, ",")
    elif k := p.any_of(j, ("before you", "before the robot", "before")):
        yield "before", k
    elif k := p.any_of(j, ("after",)):
        yield "after", k
    elif k := p.any_of(j, ("or else", "or")):
        yield "or", k
    elif k := p.any_of(j, _ALSO):
        k = p.opt(k, "also", "both")
        yield "and", k
    elif j > i:
        yield "and", j


_ALSO = ("and also", "and make sure that", "and ensure that", "and", "while also", "while", "but also", "but",
    "as well as", "also", "whereas", "&",
         "yet", "although", "though")  # fmt: skip
