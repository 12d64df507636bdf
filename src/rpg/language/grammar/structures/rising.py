"""Which way numbers rise: "they increase towards the top", "they increase with their distance from the robot"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.places.sides import AXIS, OPPOSITE, SIDES, toward
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.meaning import Clause, Coord, Meaning, Noun, OrderBy, Toward, replace

_TOWARDS = ("towards the", "toward the", "to the", "towards", "toward", "in the direction of the")
_FARTHER = Patterns(
    "with|by their|the|its? distance|distances from the|your? robot|arm|camera|viewer|me|you|us",
    "with their|the|its? distance|distances",
)
_RISE = {
    **dict.fromkeys(("increase", "rise", "ascend", "grow", "climb"), False),
    **dict.fromkeys(("decrease", "fall", "descend", "shrink", "drop"), True),
}
_WAYS = frozenset(_RISE)


def whither(p: Parser, i: int) -> Iterator[tuple[str, int]]:
    """ "towards the top", "to the right", "with their distance from the robot": the side where an order begins."""
    j = p.any_of(i, _TOWARDS)
    side = p.peek(j, SIDES) if j else None
    if side is not None and not p.stands(end := p.opt(p.reach(j + 1), "end", "side"), ("of", "half")):
        yield OPPOSITE[side], end
    if end := max(_FARTHER.matches(p, i), default=0):
        yield "front", end


def they_rise(p: Parser, i: int, k: int, theme: Meaning, mode: str) -> Results[Clause]:
    """ "the cubes 2, 4, 6 and 8 increase towards the top": in ascending order, from the other end on."""
    if not p.rarely(_WAYS) or not isinstance(theme, Noun | Coord) or not getattr(theme, "plural", True):
        return
    descending = p.lex(k, _RISE)
    for first, end in whither(p, k + 1) if descending is not None else ():
        order = OrderBy(by="ascending", descending=bool(descending), span=p.span(k, k + 1))
        way = Toward(first=first, axis=AXIS[first], span=p.span(k + 1, end))
        yield Clause(verb="be", theme=theme, adjuncts=(order, way), mode=mode, span=p.span(i, end)), end


_RISING = {
    **dict.fromkeys(("increasing", "rising", "ascending", "growing", "climbing"), False),
    **dict.fromkeys(("decreasing", "falling", "descending", "shrinking", "dropping"), True),
}
_RISES = {**_RISE, **{f"{word}s": down for word, down in _RISE.items()}}
_GETTING = {f"{gets} {way}": way == "smaller" for gets in ("gets", "get", "getting", "becomes", "become")
            for way in ("bigger", "larger", "smaller")}  # fmt: skip
_LEADS = ("that", "which", "and", "so that it", "so it", "so that they", "so they", "whose numbers", "whose values",
          "where the numbers", "so that the numbers", "with numbers that")  # fmt: skip
_GROWING = frozenset({"growing", "shrinking", "bigger", "larger", "smaller"})
"""What blocks that show no numbers do in size."""
_DIGITS = frozenset({"numbers", "digits", "number", "digit", *lexicon.NUMBER})
_MARKED = frozenset({*_RISING, *_RISES, "bigger", "larger", "smaller"})
_STEPS = frozenset({"staircase", "stairs", "stair", "stairway", "steps", "heights"})
"""What rises by itself."""
_NUMBERS = frozenset({"numbers", "digits", "numerals", "values", "numerical"})
"""Behind these it is said of them: "with the numbers rising to the right"."""


def rising(p: Parser, i: int) -> Iterator[tuple[OrderBy, int]]:
    """ "(a row of 2, 4 and 6,) increasing from left to right", "rising towards the back"."""
    if not p.rarely(_MARKED):
        return
    j = p.opt(i, ",")
    finite = p.any_of(j, _LEADS)
    j = finite or j
    descending = p.lex(j, _RISES if finite else _RISING)
    for phrase, k in p.standing(j, _GETTING):
        descending, j = _GETTING[phrase], k - 1
    if descending is None or not p.all.isdisjoint(_STEPS) or p.follows(j, _NUMBERS):
        return
    if finite and _DIGITS.isdisjoint(p.words) and all(token.kind != "number" for token in p.tokens):
        return  # "a row which rises to the right"
    order = OrderBy(by="ascending", descending=descending, span=p.span(i, j + 1))
    if p.words[j] in _GROWING:
        order = replace(order, attribute="size")
    closed = finite > 0 and (j + 1 >= p.end or p.stands(j + 1, (",", ";")))
    if closed or any(isinstance(way, Toward) and way.first for way, _ in toward(p, j + 1)):
        yield order, j + 1
    yield from ((replace(order, first=first, span=p.span(i, end)), end) for first, end in whither(p, j + 1))
