"""Statements about how many: numbers that are equal or compared, how high stacks are, and groups that are listed."""

from __future__ import annotations

from rpg.language.grammar.clauses.equal_numbers import equal_numbers
from rpg.language.grammar.clauses.groups_told import groups_told
from rpg.language.grammar.clauses.heights_bounded import heights_bounded
from rpg.language.grammar.clauses.numbers_compared import numbers_compared
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.meaning import Clause


@rule
def amounts_told(p: Parser, i: int) -> Results[Clause]:
    yield from equal_numbers(p, i)
    yield from numbers_compared(p, i)
    yield from heights_bounded(p, i)
    yield from groups_told(p, i)
