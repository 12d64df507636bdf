"""Clauses about parts of a structure that was spoken of before: "the middle row is red and the others are white"."""

from __future__ import annotations

from rpg.language.grammar.absolutes import more_parts, one_more
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.each import each_clause
from rpg.language.grammar.each_line import each_line
from rpg.language.grammar.parts import part_statement
from rpg.language.grammar.patterns import pattern
from rpg.language.grammar.wholes import wholes_told
from rpg.language.meaning import Absolute, Clause, Coord, Meaning


@rule
def part_clause(p: Parser, i: int) -> Results[Meaning]:
    """ "its top is red", "make the middle one blue", "the two ends should be white"."""
    yield from each_clause(p, i)
    for lines, j in each_line(p, i):
        if isinstance(lines, Coord):
            yield Clause(verb="part", adjuncts=(lines,), mode="goal", span=p.span(i, j)), j
    for agreed, j in pattern(p, i) if p.stands(i, ("each", "every")) else ():
        yield Clause(verb="part", adjuncts=(agreed,), mode="goal", span=p.span(i, j)), j
    for several, j in wholes_told(p, i):
        yield _said(p, i, j, several), j
    start = p.any_of(i, ("make", "let", "have", "keep")) or i
    told = dict.fromkeys(part_statement(p, start))
    for first, j in told:
        yield _said(p, i, j, first), j
    for first, j in {**told, **dict.fromkeys(one_more(p, start))}:
        for whole, k in more_parts(p, start, j, first):
            if isinstance(whole, Coord):
                yield _said(p, i, k, whole), k


def _said(p: Parser, i: int, j: int, found: Absolute | Coord) -> Clause:
    return Clause(verb="part", adjuncts=(found,), mode="goal", span=p.span(i, j), cost=1)
