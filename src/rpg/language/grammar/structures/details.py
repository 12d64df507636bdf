"""Clauses about parts of a structure that was spoken of before: "the middle row is red and the others are white"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language import lexicon
from rpg.language.grammar.clauses.pointing import pointed
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.places.absolutes import more_parts, one_more
from rpg.language.grammar.places.around import surrounded
from rpg.language.grammar.places.onto import piled_from_an_end
from rpg.language.grammar.places.sides import OPPOSITE, at
from rpg.language.grammar.structures.apposed import layers_alone
from rpg.language.grammar.structures.each import each_clause
from rpg.language.grammar.structures.each_line import each_line, lines_of
from rpg.language.grammar.structures.ends_filled import ends_filled
from rpg.language.grammar.structures.levels import levels
from rpg.language.grammar.structures.opening import opens
from rpg.language.grammar.structures.ordered_whole import ordered_whole
from rpg.language.grammar.structures.part_words import IS, THERE
from rpg.language.grammar.structures.parts import part, part_statement
from rpg.language.grammar.structures.patterns import DIAGONALS, pattern
from rpg.language.grammar.structures.steps import steps_alone
from rpg.language.grammar.structures.succession import succession
from rpg.language.grammar.structures.wholes import wholes_told
from rpg.language.grammar.things.bodies import body_clause
from rpg.language.grammar.things.nouns import simple
from rpg.language.grammar.things.strangers import strangers_told
from rpg.language.later import later
from rpg.language.meaning import (
    Absolute,
    Amount,
    At,
    Clause,
    Coord,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Places,
    Structure,
    Traits,
    replace,
)

if TYPE_CHECKING:
    from rpg.language.grammar.structures.structures import structure
else:
    (structure,) = later(__name__, "rpg.language.grammar.structures.structures", "structure")


@rule
def part_clause(p: Parser, i: int) -> Results[Meaning]:
    """ "its top is red", "make the middle one blue", "the two ends should be white"."""
    yield from _comes_next(p, i)
    yield from _first_then(p, i)
    yield from each_clause(p, i)
    yield from strangers_told(p, i)
    yield from piled_from_an_end(p, i)
    yield from surrounded(p, i)
    yield from body_clause(p, i)
    yield from succession(p, i)
    yield from levels(p, i)
    yield from (*lines_of(p, i), *ends_filled(p, i), *ordered_whole(p, i))
    for lines, j in each_line(p, i):
        if isinstance(lines, Coord):
            yield Clause(verb="part", adjuncts=(lines,), mode="goal", span=p.span(i, j)), j
    for agreed, j in pattern(p, i) if p.stands(i, ("each", "every")) or p.rarely(DIAGONALS) else ():
        yield Clause(verb="part", adjuncts=(agreed,), mode="goal", span=p.span(i, j)), j
    for said, j in [*pointed(p, i), *opens(p, i), *steps_alone(p, i), *layers_alone(p, i)]:
        yield Clause(verb="part", adjuncts=(said,), mode="goal", span=p.span(i, j)), j
    for several, j in wholes_told(p, i):
        yield _said(p, i, j, several), j
    yield from _of_a_whole(p, i)
    yield from _in_a_whole(p, i)
    start = _begun(p, i)
    put = p.any_of(i, ("put", "place", "add"))
    ends = part_statement(p, put) if put else ()
    for at_end, j in ends:
        if "at" in p.words[put:j] and isinstance(at_end.adjuncts[0], Places) and at_end.adjuncts[0].side == "ends":
            yield _said(p, i, j, at_end), j
    told = dict.fromkeys(part_statement(p, start))
    for first, j in told:
        yield _said(p, i, j, first), j
    for first, j in {**told, **dict.fromkeys(one_more(p, start))}:
        for whole, k in more_parts(p, start, j, first):
            if isinstance(whole, Coord):
                yield _said(p, i, k, whole), k


_MAKE = ("make", "let", "have", "keep", "paint", "color")
_USE = ("use", "take", "i want", "we want", "i would like", "with")
_FOR = frozenset({"for", "blocks", "cubes", "bricks", "ones"})
"""What is said before "red for the top, blue for the rest", and in it behind the colour."""
_ONWARD = (", and then", ", then", "and then", "then", ", and finally", ", and lastly", "and finally", "and lastly",
           ", finally", ", lastly", "followed by", ", followed by", ", next", ", and last", "and last",
           ", and after that", ", after that")  # fmt: skip
_IS_LAST = ("is last", "comes last", "last", "at the end", "is at the end")


def _begun(p: Parser, i: int) -> int:
    """Behind "make", and behind "use" where a colour for a part follows."""
    if j := p.any_of(i, _MAKE):
        return j
    use = p.any_of(i, _USE)
    return use if use and p.stands(use + 1, _FOR) else i


@choice
def _first_then(p: Parser, i: int) -> Results[Clause]:
    """ "First (comes) red, then white, and blue is last.": the blocks of a line from its beginning on."""
    start = p.any_of(i, ("first", "first comes", "first there is", "first of all", "the first is", "first :"))
    items: list[Meaning] = []
    at, begin = start, None
    while at and len(items) < 12:
        theme, k = next(((x, k) for x, k in simple(p, at) if isinstance(x, Noun) and _one(x)), (None, 0))
        if theme is None:
            return
        items.append(theme)
        there, k = _at_an_end(p, k)
        begin = there if len(items) == 1 else begin
        end = p.any_of(k, _IS_LAST) or k
        if there and len(items) > 1 and (end < p.end or OPPOSITE[there] != (begin or OPPOSITE[there])):
            return
        if end >= p.end and len(items) > 1:
            begin = begin or OPPOSITE.get(there)
            order = OrderBy(by="named", items=tuple(items), first=begin, span=p.span(i, end))
            yield Clause(verb="part", adjuncts=(order,), mode="goal", span=p.span(i, end), cost=1), end
        on = p.any_of(end, _ONWARD)
        last = p.any_of(end, (", and", "and"))
        at = (p.any_of(on, _COMES) or on) if on else last


def _at_an_end(p: Parser, k: int) -> tuple[str, int]:
    """ "(pink,) which is closest to me": at which end of the line a block is, if that is told."""
    told = p.any_of(k, _WHICH_IS)
    side, end = max(p.standing(p.opt(told, "the"), THERE), key=lambda x: x[1], default=("", 0)) if told else ("", 0)
    return (THERE[side], end) if end and THERE[side] != "middle" else ("", k)


_WHICH_IS = (", which is", "which is", ", that is", "is", ", being", ", and it is", "must be", "should be")


def _one(theme: Noun) -> bool:
    """One block, told by its look."""
    one = theme.amount in (None, Amount(1, 1)) and not theme.plural and theme.head != "patch" and theme.det != "each"
    return one and len(theme.traits.colors + theme.traits.labels) == 1 and theme.part_of is None


_COMES = ("comes", "come", "there comes", "follows", "follow", "there follows", "comes the", "there is", "is")


@choice
def _comes_next(p: Parser, i: int) -> Results[Clause]:
    """ "(red is on the left,) then comes blue": next to what was told before."""
    j = p.any_of(i, _COMES)
    if not j or not p.follows(i, ("then", "next", "that", "it")):
        return
    for theme, k in simple(p, j):
        if isinstance(theme, Noun) and theme.head != "patch" and theme.amount in (None, Amount(1, 1)):
            follows = At(side="next", span=p.span(i, j))
            yield Clause(verb="be", theme=theme, adjuncts=(follows,), mode="goal", span=p.span(i, k), cost=1), k


def _of_a_whole(p: Parser, i: int) -> Results[Clause]:
    """ "the four corners of a 3x3 grid are pink": builds the grid, and says so of its corners."""
    for place, j in part(p, i):
        of = p.one(j, ("of", "in"))
        for whole, k in structure(p, of) if of else ():
            sized = isinstance(whole, Structure) and whole.det in ("a", "bare") and not whole.plural
            if not sized or not isinstance(whole, Structure) or not (whole.sizes or whole.dims or whole.members):
                continue
            told = p.any_of(k, IS)
            for theme, end in simple(p, told) if told else ():
                if not isinstance(theme, Noun) or theme.det != "bare" or theme.traits.rank or not theme.traits.colors:
                    continue
                first = Absolute(theme=theme, adjuncts=(place,), span=p.span(i, end))
                built = Clause(verb="build", theme=whole, adjuncts=(first,), mode="goal", span=p.span(i, end))
                yield built, end
                for more, last in more_parts(p, i, end, first):
                    if isinstance(more, Coord):
                        yield replace(built, adjuncts=(more,), span=p.span(i, last)), last


_OUTSIDE = ("in front of", "left of", "right of")
"""What is there is no part of what is named behind it."""


@choice
def _in_a_whole(p: Parser, i: int) -> Results[Clause]:
    """ "the red one is third in a row of five": builds the row, and says so of one of its places."""
    if not p.anywhere(_PLACED):
        return
    start = p.any_of(i, ("put", "place", "set", "have", "i want", "let", "make", "get", "keep")) or i
    for theme, j in simple(p, start):
        if not isinstance(theme, Noun) or not _one(theme) or theme.traits.rank is not None:
            continue
        told = p.any_of(j, _IS_IN) or j
        if p.any_of(told, _OUTSIDE):
            continue
        led = p.any_of(told, ("in", "at", "on", "as"))
        there = [*part(p, told, "block"), *(part(p, led, "block") if led else ()), *at(p, told)]
        for place, k in dict.fromkeys(there):
            upon = p.words[told] == "on" and any(word in lexicon.BLOCK for word in p.words[told:k])
            if upon and not (isinstance(place, At) and place.whole is None):
                continue
            inside = p.any_of(k, ("in", "of"))
            for whole, end in structure(p, inside) if inside else ():
                new = isinstance(whole, Structure) and whole.det in ("a", "bare") and not whole.plural
                if not new or not isinstance(whole, Structure) or not (whole.sizes or whole.members):
                    continue
                if p.words[told] == "on" and whole.kind in _BROAD and whole.members and not upon:
                    continue  # on top of it, or one of its blocks?
                look = replace(theme, det="bare")
                first = Absolute(theme=look, adjuncts=(place,), span=p.span(i, k))
                if upon and isinstance(place, At):
                    on_it = Loc(rel="on", landmark=_block_at(place), span=place.span)
                    first = Absolute(theme=replace(theme, amount=Amount(1, 1)), adjuncts=(on_it,), span=first.span)
                built = Clause(verb="build", theme=whole, adjuncts=(first,), mode="goal", span=p.span(i, end))
                if upon:
                    yield built, end
                    continue
                parts = [(x, last) for x, last in more_parts(p, i, end, first) if isinstance(x, Coord)]
                if not parts:  # "on top of a tower of three" is a fourth one
                    fourth = whole.kind == "stack" and p.words[told] == "on"
                    yield replace(built, cost=int(fourth)), end
                for more, last in parts:
                    yield replace(built, adjuncts=(more,), span=p.span(i, last)), last


def _block_at(place: At) -> Noun:
    """ "On the second block from the left": what lies there is on top of it, no part of the line."""
    rank = f"{place.index} {place.side}" if place.index is not None else place.side
    return Noun(head="any", det="the", traits=Traits(rank=rank), span=place.span)


_BROAD = frozenset({"grid", "square", "cube", "rectangle", "checkerboard"})
"""Figures with an upper side that something may lie on."""
_PLACED = frozenset({"first", "second", "third", "fourth", "fifth", "sixth", "last", "middle", "center", "leftmost",
                     "rightmost", "end", "top", "bottom", "lowest", "highest", "left", "right"})  # fmt: skip
_IS_IN = ("is", "should be", "must be", "comes", "stands", "goes", "has to be", "is to be", "sits", "should stand",
          "must stand", "being", "as")  # fmt: skip


def _said(p: Parser, i: int, j: int, found: Absolute | Coord) -> Clause:
    return Clause(verb="part", adjuncts=(found,), mode="goal", span=p.span(i, j), cost=1)
