"""Gradients by the colours that they run through: "from yellow through green and cyan to blue", "from red to green"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.adjectives import color
from rpg.language.grammar.things.lists import listed
from rpg.language.lexicon import RAINBOW
from rpg.language.meaning import Coord, Noun, Structure, Toward, Traits, replace

_ALONG = tuple(f"{along} {a} {line}" for along in ("along", "in", "across") for a in ("a", "one", "a single")
               for line in ("row", "line"))  # fmt: skip
_FROM = ("from", "going from", "running from", "that goes from", "that runs from", "which goes from", "starting from",
         "ranging from", "passing from")  # fmt: skip
_THROUGH = ("through", "via", "over", "by way of", "passing through", "past")
_TO = ("to", "up to", "until", "towards", "on to", "and on to", "and then to", "and finally to", "and to")


def gradient(p: Parser, i: int, j: int, base: Structure) -> Results[Structure]:
    """The blocks of a gradient: its colours as they are named, or all of the rainbow from one to the other."""
    for items, end in listed(p, p.one(j, ":")) if p.stands(j, (":",)) else ():
        if all(isinstance(x, Noun) and x.traits == Traits(colors=x.traits.colors[:1]) for x in items):
            yield replace(base, members=Coord(op="and", items=items, span=p.span(j, end)), span=p.span(i, end)), end
    along = p.any_of(j, _ALONG)
    lead = p.any_of(p.opt(along or j, ","), _FROM)
    named, at = _colors(p, lead) if lead else ((), 0)
    if len(named) != 1:
        return
    inner, after = _colors(p, p.any_of(p.opt(at, ","), _THROUGH))
    to = p.any_of(p.opt(after or at, ","), _TO)
    last, end = _colors(p, to) if to else ((), 0)
    if not last:
        return
    told = (*named, *inner, last[0]) if inner else _between(named[0], last[0])
    end = end if len(last) == 1 else next((k for _, k in color(p, to)), end)
    ranks = [RAINBOW.index(one) for one in told if one in RAINBOW]
    if len(told) > 1 and (ranks == sorted(ranks) or ranks == sorted(ranks)[::-1]):
        span = p.span(j, end)
        items = tuple(Noun(head="any", traits=Traits(colors=(one,)), span=span) for one in told)
        row = (Toward(axis="y", span=p.span(j, along)),) if along and p.words[along - 1] == "row" else ()
        whole = Coord(op="and", items=items, span=span)
        yield replace(base, members=whole, details=(*base.details, *row), span=p.span(i, end)), end


def from_to(p: Parser, i: int) -> Results[tuple[str, ...]]:
    """ "(in rainbow order) from purple to red": the colours at its two ends."""
    named, at = _colors(p, p.any_of(p.opt(i, ","), _FROM))
    to = p.any_of(p.opt(at, ","), _TO) if len(named) == 1 else 0
    for last, end in color(p, to) if to else ():
        if _between(named[0], last):
            yield (*named, last), end


def _colors(p: Parser, i: int) -> tuple[tuple[str, ...], int]:
    """Colours in a row, with the position behind them."""
    found: list[str] = []
    end = at = i
    while at and (one := next(iter(color(p, at)), None)) is not None and len(found) < len(RAINBOW):
        found.append(one[0])
        end = one[1]
        at = p.any_of(end, (", and", ",", "and", "then"))
    return tuple(found), end


def _between(first: str, last: str) -> tuple[str, ...]:
    if first not in RAINBOW or last not in RAINBOW:
        return ()
    return between(first, last)


def between(first: str, last: str) -> tuple[str, ...]:
    """The colours of the rainbow from one to the other."""
    a, b = RAINBOW.index(first), RAINBOW.index(last)
    return tuple(RAINBOW[a : b + 1] if a < b else RAINBOW[b : a + 1][::-1])
