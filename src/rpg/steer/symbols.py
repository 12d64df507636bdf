"""Requests about what cubes with symbols show together: another equation, letters or numbers that go on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rpg.language.grammar.equations import equation
from rpg.language.grammar.labels import symbol
from rpg.steer import requests as r
from rpg.steer.language import Parser, longest


@dataclass(frozen=True, slots=True, kw_only=True)
class Equate(r.Request):
    """The equation is another one."""

    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Continue(r.Request):
    """Symbols in a line go on to `upto`."""

    upto: str


_EQUATE = (
    "change it to | change it into | change that to | turn it into | make it | make that | make | use | i want | "
    "let it be | let it read | let it say | it should be | it should say | it should read | show | write | spell | "
    "do | with | have | change the equation to | the equation should be | make the equation | use the equation | "
    "switch to | try | replace it with | replace it by | replace the equation with | replace the equation by | "
    "let it show"
)
_CONTINUE = (
    "continue | go on | carry on | keep going | go | count | count on | count up | count down | extend it | "
    "extend the row | extend the line | extend the tower | extend the sequence | continue it | continue the row | "
    "continue the sequence | continue the line | continue the tower | add the letters | add the numbers | "
    "add the digits | keep counting | it should go | they should go | go all the way | let it go"
)


def symbols(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "change it to 2 + 3 = 5", "continue up to E"."""
    start = longest(p, i, _EQUATE) or i
    for text, j in equation(p, start):
        if "=" in text and not text.endswith("="):
            yield Equate(text=text, span=p.span(i, j)), j
    j = longest(p, i, _CONTINUE)
    k = longest(p, j, "up to | down to | to | until | till | through | as far as | on to | all the way to") if j else 0
    last = symbol(p, k, True) if k else None
    if last is not None and last.isalnum():
        yield Continue(upto=last, span=p.span(i, k + 1), cost=1), k + 1
