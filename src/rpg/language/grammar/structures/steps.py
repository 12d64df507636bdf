"""Stairs by the heights of their steps: "heights 1, 2 and 3", "one, two and three red blocks"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.clauses.manners import manner
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.places.sides import toward
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.adjectives import color
from rpg.language.meaning import Amount, Manner, Size, Toward, replace

_LEADS = Patterns(
    ",|:|;? with|of|having|whose|the|in? the|its? column|step|tower|stair? heights|height|columns|steps|towers|stairs "
    "of|with|are|is|being|that_are|which_are|:? height|heights|heights_of|the_heights? of|:?",
    ",|:? with|of|having :?",
    ",|:",
)
_UNITS = ("blocks high", "blocks tall", "block high", "block tall", "cubes high", "cube high", "high", "tall",
          *(f"{blocks}{piled}" for blocks in ("blocks ", "cubes ", "ones ", "")
           for piled in ("stacked", "on top of each other", "stacked on top of each other", "stacked up")),
         "stacked blocks", "stacked cubes", "blocks", "block", "cubes", "cube", "bricks", "brick")  # fmt: skip
_NEXT = ("and then", "then", "and finally", "and", *(
    f"{joint}{beside} {it}" for joint in ("", "and ", "then ", "and then ") for beside in ("next to", "beside")
    for it in ("it", "that", "them", "those")))  # fmt: skip
_PARTS = frozenset({"steps", "step", "columns", "column", "stairs", "stair", "towers", "tower"})
_NAMES = frozenset({"stairs", "staircase", "stairway", "steps"})
Told = tuple[Size, tuple[Manner, ...], tuple[str, ...]]
"""How many steps, whether they go up or down as they are listed and which way they rise where that is said with them,
and the colour of their blocks."""


@choice
def steps_told(p: Parser, j: int) -> Results[Told]:
    """Behind the word for stairs: as many steps as heights are told, each one block higher than the one before."""
    bare = p.number(j) is not None and (p.stands(j + 1, (",", "and")) or p.number(j + 1) is not None)
    leads = {*_LEADS.matches(p, j), *([j] if bare and p.follows(j, _NAMES) else ())}
    if p.follows(j, lexicon.COLOR) and p.stands(j, _PARTS):  # "of red, white and blue steps": each in one of these?
        return
    for lead in sorted(leads):
        yield from _heights(p, j, lead, None)
    for lead in sorted({j, *leads}):
        for way, k in toward(p, lead):
            if isinstance(way, Toward) and way.first in _SIDES:
                for end in sorted({*_LEADS.matches(p, k), p.opt(k, ":", ",")}):
                    yield from _heights(p, j, end, way.first)
    for way, k in manner(p, p.opt(j, ",")):
        if isinstance(way, Manner) and way.kind == "rising":
            for end in sorted(_LEADS.matches(p, k)):
                yield from (((size, (way, *more), named), e) for (size, more, named), e in _heights(p, j, end, None))


_SIDES = {"left": "right", "right": "left", "front": "back", "back": "front"}


def _heights(p: Parser, i: int, at: int, first: str | None) -> Results[Told]:
    listed: list[int] = []
    while (n := p.number(at)) is not None:
        listed.append(n)
        for named, end in _tail(p, at + 1):
            up = listed == list(range(1, len(listed) + 1))
            down = listed == list(range(len(listed), 0, -1))
            goes_on = p.number(p.any_of(p.opt(end, ","), _NEXT) or p.opt(end, ","))
            if len(listed) < 2 or goes_on is not None or not (up or down):
                continue
            size = Size(what="steps", amount=Amount(len(listed), len(listed)), span=p.span(i, end))
            begin = first
            if begin is None and down:
                ways = toward(p, p.opt(end, ","))
                way, end = next(((w.first, e) for w, e in ways if isinstance(w, Toward)), (None, end))
                begin = way if way in _SIDES else None
            rising = begin if down else _SIDES.get(begin or "")
            told = [Manner(kind="steps", value="down" if down else "up", span=p.span(i, end))]
            told += [Manner(kind="rising", value=rising, span=p.span(i, end))] if rising else []
            yield (size, tuple(told), named), end
        at = p.any_of(at + 1, _UNITS) or at + 1
        at = p.any_of(p.opt(at, ","), _NEXT) or p.opt(at, ",")


def _tail(p: Parser, i: int) -> Results[tuple[str, ...]]:
    """What stands behind the last height: "blocks high", "red blocks"."""
    end = p.any_of(i, _UNITS) or i
    yield (), p.any_of(end, ("each", "high", "tall")) or end
    for named, k in color(p, i):
        if blocks := p.any_of(k, ("blocks", "cubes", "bricks", "ones")):
            yield (named,), p.any_of(blocks, ("high", "tall")) or blocks


def rising_steps(p: Parser, i: int) -> Results[Size]:
    """The same behind what else is said of stairs."""
    for (found, more, named), j in steps_told(p, i) if p.anywhere(_NAMES) else ():
        way_told = len(more) > 1 or (more[0].value == "down" and not _SIDES.keys().isdisjoint(p.words))
        colors = sum(word in lexicon.COLOR for word in p.words[:i])
        one_each = found.amount is not None and 1 < colors >= found.amount.low  # which step would have which of them?
        if not way_told and not named and not one_each and not _NAMES.isdisjoint(p.words[:i]):
            yield replace(found, cost=1), j


def steps_alone(p: Parser, i: int) -> Results[Size]:
    """In a sentence of its own: "(Build stairs.) One, two, three high." """
    for (found, more, named), j in _heights(p, i, i, None) if i == 0 else ():
        if len(more) == 1 and not named and j >= p.end and p.words[j - 1] in ("high", "tall"):
            yield found, j
