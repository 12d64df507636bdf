"""Requests about what cubes with symbols show together: another equation, letters or numbers that go on."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rpg.language.grammar.structures.equations import equation
from rpg.language.grammar.things.labels import symbol
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import Parser, literal, longest


@dataclass(frozen=True, slots=True, kw_only=True)
class Equate(r.Request):
    """The equation is another one."""

    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Respell(r.Request):
    """The word is another one; whatever else the task asks for stays."""

    word: str


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


_RESPELL = (
    "spell | spell out | write | write out | read | say | it should spell | it should say | it should read | "
    "it must spell | let it spell | have it spell | make it spell | make it say | make it read | make them spell | "
    "let them spell | have them spell | they should spell | the word should be | the word must be | the word is | "
    "change the word to | the blocks should spell | the cubes should spell"
)


def _respelt(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "spell FUN instead", "write the word DOG"."""
    j = longest(p, i, _RESPELL)
    j = longest(p, j, "the word | the name") or j if j else 0
    text = literal(p, j) if j else None
    if text is not None and len(text) > 1 and text.isalpha():
        end = j + 1
        end = longest(p, end, "instead of that | instead of it") or end
        if n := longest(p, end, "instead of | rather than | and not | , not | not"):
            end = n + 1 if literal(p, n) is not None else end
        yield Respell(word=text.upper(), span=p.span(i, end), cost=1), end


def symbols(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "change it to 2 + 3 = 5", "spell FUN instead", "continue up to E"."""
    yield from _respelt(p, i)
    start = longest(p, i, _EQUATE) or i
    for text, j in equation(p, start):
        if "=" in text and not text.endswith("="):
            yield Equate(text=text, span=p.span(i, j)), j
    j = longest(p, i, _CONTINUE)
    k = longest(p, j, "up to | down to | to | until | till | through | as far as | on to | all the way to") if j else 0
    last = symbol(p, k, True) if k else None
    if last is not None and last.isalnum():
        yield Continue(upto=last, span=p.span(i, k + 1), cost=1), k + 1
