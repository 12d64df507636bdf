"""Requests for one more tower: "add three blue blocks as a third tower", "... in a tower of their own"."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rpg.steer.requests import requests as r
from rpg.steer.requests.language import Parser, count, lexicon, longest, m, phrases
from rpg.steer.requests.phrases import fresh, labelled, things


@dataclass(frozen=True, slots=True, kw_only=True)
class NewTower(r.Request):
    """New blocks form a tower of their own. `ordinal`: the how manieth it is."""

    theme: m.Meaning
    ordinal: int | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class SoManyTowers(r.Request):
    """So many towers like those that there are. `only`: fewer of them, not others of the same blocks."""

    amount: int
    only: bool = False


_MANY = phrases(
    "make that | make it | make them | only | just | use only | with only | build only | make only | have only | "
    "now with | use just | only build | we need only | i only need | i need only | only have"
)


def _so_many(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "only two towers", "make that three towers"."""
    lead = longest(p, i, _MANY) or i
    skipped = i > 0 and p.words[i - 1] in ("only", "just")
    for n, j in count(p, lead):
        k = p.one(j, frozenset({"towers", "stacks"}))
        end = longest(p, k, "only | will do | are enough | is enough | suffice | instead | like that | of them") or k
        only = skipped or bool({"only", "just"} & set(p.words[i:lead])) or (end > k and p.words[k] != "instead")
        if k and (lead > i or end > k or skipped):
            yield SoManyTowers(amount=n, only=only, span=p.span(i, end)), end


_LEADS = (
    "add | put | include | have | with | i want | insert | bring in | let there be | there should be | i would like | "
    "it would be great to have | it would be nice to have | it would be good to have | we need | i need | form | "
    "make | now with | throw in | i would also like"
)
_KINDS = frozenset({"tower", "stack", "towers", "stacks"})


def parties(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Every such request."""
    yield from _so_many(p, i)
    lead = longest(p, i, _LEADS) or i
    for theme, j in things(p, lead):
        if fresh(theme) or labelled(theme):
            for ordinal, k in _as(p, j):
                yield NewTower(theme=theme, ordinal=ordinal, span=p.span(i, k)), k


def _as(p: Parser, i: int) -> Iterator[tuple[int | None, int]]:
    """Phrases such as "as a third tower", "in a tower of their own"."""
    if j := longest(p, i, "as a | as the | as an | as | forming a | to form a | in a | for a | making a | in"):
        ordinal = p.lex(j, lexicon.ORDINAL) if j < p.end else None
        k = j + 1 if ordinal else longest(p, j, "new | separate | further | another | extra | additional | own") or j
        if k < p.end and p.words[k] in _KINDS:
            end = longest(p, k + 1, "of their own | of its own | by themselves | on their own")
            if end or k > j:
                yield ordinal, end or p.reach(k + 1)
    j = longest(p, i, "in their own | as their own | in its own | as its own | into their own")
    if j and j < p.end and p.words[j] in _KINDS:
        yield None, p.reach(j + 1)
