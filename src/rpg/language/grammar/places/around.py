"""Blocks around another one: "surround the red block with four blue ones", "a blue one on each of its four sides"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.core.diagnostics import Span
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.places.four_sides import one_on_each, touching
from rpg.language.grammar.places.regions import of_table
from rpg.language.grammar.things.nouns import simple
from rpg.language.later import later
from rpg.language.meaning import (
    Absolute,
    Amount,
    At,
    Chain,
    Clause,
    Coord,
    In,
    Loc,
    Manner,
    Meaning,
    Noun,
    Places,
    Spacing,
    Structure,
    That,
    Traits,
    replace,
)

if TYPE_CHECKING:
    from rpg.language.grammar.things.nouns import noun_phrase
else:
    (noun_phrase,) = later(__name__, "rpg.language.grammar.things.nouns", "noun_phrase")

_IS = (
    "is",
    "are",
    "goes",
    "lies",
    "stands",
    "sits",
    "must go",
    "should go",
    "should be",
    "must be",
    "has to be",
    "shall be",
    "is to be",
    "being",
    "be",
    "needs to be",
)
_FLANKED = ("flanked on both sides by", "flanked by", "flanked left and right by", "flanked on either side by",
            "flanked on each side by", "flanked on the left and right by", "flanked with")  # fmt: skip
_FLANK = ("flank", "should flank", "must flank", "are flanking", "are to flank", "have to flank", "enclose", "frame")
_BOTH_SIDES = ("on both sides", "on either side", "on each side", "left and right", "on the left and on the right")
_SURROUNDED = ("surrounded by", "encircled by", "surrounded on all sides by", "surrounded on all four sides by",
               "enclosed by", "ringed by")  # fmt: skip
_SIDES = ("each of its four sides", "all four sides", "all four of its sides", "all its sides", "every side",
          "all sides",
          "each of the four sides")  # fmt: skip
_ALL_SIDES = tuple(f"{on} {sides}{of}" for on in ("on", "at") for sides in _SIDES for of in ("", " of it"))
_SIDES_OF = ("on each of the four sides of", "on all four sides of", "on every one of the four sides of",
             "at each of the four sides of", "at all four sides of")  # fmt: skip
_EACH_SIDE = tuple(f"on {sides}" for sides in ("each side", "each of its sides", "each side of it"))
"""Which with one block could be two sides or four."""
_AROUND = tuple(
    f"{how}{around}" for how in ("", "directly ", "immediately ", "right ")
    for around in ("around it", "all around it", "round it", "surrounding it", "placed around it", "arranged around it",
                   "standing around it", "around that one"))  # fmt: skip
_IN_SHAPE = (
    "in a",
    ", in a",
    "as a",
    ", as a",
    "forming a",
    ", forming a",
    "like a",
    ", like a",
    "to form a",
    "so that they form a",
    ", so that they form a",
    "so that it forms a",
    "so that all nine form a",
    ", so that all nine form a",
)
_SHAPES = {"circle": "circle", "ring": "circle", "square": "square"}
_MIDDLE = ("in the middle", "in the center", "at the center", "to the middle", "to the center", "at the middle")
_JOINTS = tuple(f"{joint}{put}" for joint in (", and", "and", ", with", ",", "with", "and then", ", then")
                for put in ("", " put", " place", " arrange", " set"))  # fmt: skip
_GO = ("go", "goes", "stand", "lie", "are", "are placed", "are arranged", "must go", "should go", "must be",
       "should be")  # fmt: skip


@rule
def surrounded(p: Parser, i: int) -> Results[Meaning]:
    """One block with so many others around it: a plus of five, or the outline that is named with it in the middle."""
    if j := p.any_of(i, _ENCLOSE):
        for hub, k in _hubs(p, j):
            for ring, end in _rings(p, p.any_of(k, ("with", "by", "in with", "in by"))):
                yield from _shaped(p, i, end, hub, ring)
            for ring, end in _rings(p, p.any_of(k, _IN_A_RING)):
                yield _outlined(p, i, end, hub, ring, "circle"), end
    if j := p.one(i, "flank"):
        for hub, k in _hubs(p, j):
            for sides, end in _two(p, p.any_of(k, ("with", "by"))):
                yield _between(p, i, p.any_of(end, _BOTH_SIDES) or end, hub, sides), end
    if p.anywhere(_MARKS):
        yield from _told(p, i)
        yield from around_told(p, i)


_ENCLOSE = ("surround", "encircle", "enclose", "fence in", "fence", "box in", "hem in")
_IN_A_RING = tuple(f"{inside} a {ring} of" for inside in ("in", "within", "inside", "with", "by")
                   for ring in ("ring", "circle"))  # fmt: skip
_MARKS = frozenset({"around", "round", "surrounded", "encircled", "enclosed", "ringed", "flanked", "sides", "side",
                    "surrounding", "flank", "flanking", "enclose"})  # fmt: skip


_COMMANDS = ("put", "place", "have", "set", "lay", "i want", "we want", "there is", "there are", "arrange", "build",
             "make")  # fmt: skip


@choice
def _told(p: Parser, i: int) -> Results[Meaning]:
    begin = p.any_of(i, _COMMANDS) or i
    for hub, j in _hubs(p, begin):
        be = p.any_of(j, _IS) or j
        for sides, k in _two(p, p.any_of(be, _FLANKED)):
            yield _between(p, i, k, hub, sides), k
        for ring, k in _rings(p, p.any_of(be, _SURROUNDED)):
            yield from _shaped(p, i, k, hub, ring)
        owns = p.any_of(j, ("has", "should have", "must have", "with", "having", "gets"))
        there = p.any_of(be, _MIDDLE)
        table = of_table(p, there) if there else 0
        start = owns or (p.any_of(table or there, _JOINTS) if there else 0)
        for ring, k in _rings(p, start):
            told: list[tuple[Clause, int]] = []
            four = p.any_of(k, _ALL_SIDES) or (p.any_of(k, _EACH_SIDE) if ring.amount == _FOUR else 0)
            if four and ring.amount in (None, _ONE, _FOUR) and not p.anywhere(_BY_THE_FACE):
                told += _plus(p, i, four, hub, ring)
            if end := p.any_of(p.any_of(k, _GO) or k, _AROUND):
                told += _shaped(p, i, end, hub, ring)
            for whole, last in told:
                yield _so(whole, _there(hub, In(region="middle", span=p.span(be, table)))) if table else whole, last
    yield from _in_the_middle(p, i, begin)
    ahead = p.any_of(i, _ROUND)
    for hub, j in _hubs(p, ahead) if ahead else ():
        for ring, k in _rings(p, p.any_of(p.opt(j, ","), _THERE)):
            yield from _shaped(p, i, k, hub, ring)
    for sides, j in _two_at(p, begin):
        flanks = p.any_of(j, _FLANK)
        for hub, k in _hubs(p, flanks) if flanks else ():
            yield _between(p, i, k, hub, sides), k
    for ring, j in _rings_at(p, begin):
        around = p.any_of(j, _SIDES_OF)
        for hub, k in _hubs(p, around) if around and ring.amount in (None, _ONE, _FOUR) else ():
            yield from _plus(p, i, k, hub, ring)
    ringed = p.any_of(begin, ("a ring of", "a circle of"))
    others = p.any_of(begin, _OTHERS)
    for hub, k in _hubs(p, p.any_of(others, _ROUND) or p.end) if others else ():
        yield _with_all_others(p, i, k, hub, p.span(begin, others)), k
    yield from _kept_inside(p, i)
    for ring, j in _rings_at(p, ringed or begin):
        mark = p.any_of(p.any_of(j, _GO) or j, ("around", "all around", "round", "surrounding"))
        for hub, k in _hubs(p, mark) if mark else ():
            if ringed:
                yield _outlined(p, i, k, hub, ring, "circle"), k
            else:
                yield from _shaped(p, i, k, hub, ring)


def _in_the_middle(p: Parser, i: int, begin: int) -> Results[Clause]:
    """ "In the middle a white block, and around it four red ones"."""
    there = p.any_of(begin, _MIDDLE)
    for hub, j in _hubs(p, p.any_of(there, _THERE_IS) or there) if there else ():
        joint = p.any_of(j, _JOINTS)
        ahead = p.any_of(joint, _AROUND) if joint else 0
        for ring, k in _rings(p, (p.any_of(ahead, _THERE_IS) or ahead) if ahead else joint):
            if end := k if ahead else p.any_of(p.any_of(k, _GO) or k, _AROUND):
                yield from _shaped(p, i, end, hub, ring)


_THERE_IS = ("there is", "there are", "is", "are", "lies", "lie", "stands", "stand", "there must be", "there should be",
             "put", "place")  # fmt: skip
_THERE = (*_COMMANDS, "are", "stand", "go", "there must be", "there should be", "there shall be", "must be",
          "should be")  # fmt: skip
"""What stands between "around the red block" and the blocks there."""
_KEEP = ("keep", "leave", "do not move", "don't move")
_WHERE_IT_IS = ("where it is", "in place", "in its place", "at its place", "there")
_ALL_OTHERS = ("the others", "all the others", "all others", "the other blocks", "the other cubes", "the rest",
               "all other blocks", "all other cubes", "all the other blocks", "all the other cubes", "everything else",
               "all the rest", "the other ones", "the rest of the blocks", "the rest of the cubes")  # fmt: skip
_REST = tuple(f"{put}{rest}" for put in ("put ", "place ", "arrange ", "move ", "set ", "") for rest in _ALL_OTHERS)
_ROUND_IT = (*_AROUND, "in a circle around it", "in a ring around it")


def _kept_inside(p: Parser, i: int) -> Results[Clause]:
    """ "Keep the yellow block where it is and put the others (four red ones) around it": that one is not moved."""
    kept = p.any_of(i, _KEEP)
    begin = kept or p.any_of(i, _COMMANDS) or i
    for hub, j in _hubs(p, begin):
        there = p.any_of(j, _WHERE_IT_IS) if kept else p.any_of(j, _MIDDLE)
        there = there or (j if kept and "move" in p.words[i:begin] else 0)
        joint = (
            p.any_of(there, (", and", "and", ", with", ",", "with", "but", ";", ", then", "and then")) if there else 0
        )
        rest = p.any_of(joint, _REST) if joint else 0
        end = p.any_of(rest, _ROUND_IT) if rest else 0
        told: list[tuple[Clause, int]] = []
        if end:
            told = [(_with_all_others(p, i, end, hub, p.span(there, rest)), end)]
        for ring, k in _rings(p, p.any_of(joint, ("put", "place", "arrange", "set"))) if joint and kept else ():
            told += _shaped(p, i, around, hub, ring) if (around := p.any_of(k, _AROUND)) else ()
        stays = Clause(verb="keep", lemma="leave", theme=replace(hub, det="the"), mode="command",
                       adjuncts=(Manner(kind="stay", span=p.span(j, there)),), span=p.span(i, there))  # fmt: skip
        for whole, k in told:
            yield _so(whole, stays) if kept else whole, k


def _there(hub: Noun, place: In) -> Clause:
    return Clause(
        verb="be", theme=replace(hub, det="the", amount=None), adjuncts=(place,), mode="goal", span=place.span
    )


def _so(whole: Clause, told: Clause) -> Clause:
    """A clause with what is told besides of one of its blocks."""
    so = That(kind="so", clauses=Chain(clauses=(told,), links=("and",), span=told.span), span=told.span)
    return replace(whole, adjuncts=(*whole.adjuncts, so))


def _with_all_others(p: Parser, i: int, j: int, hub: Noun, span: Span) -> Clause:
    """A circle of whatever other blocks there are."""
    return _outlined(p, i, j, hub, Noun(head="block", det="the", plural=True, span=span), "circle")


_OTHERS = ("all the blocks", "all blocks", "everything", "all of the blocks", *_ALL_OTHERS)
"""Around one of them go all the others."""
_BY_THE_FACE = frozenset({"touching", "touch", "touches"})
"""Sides that are touched: a plus of touching blocks might touch by its edges alone."""
_ONE, _FOUR = Amount(1, 1), Amount(4, 4)


def _hubs(p: Parser, i: int) -> Results[Noun]:
    for hub, j in simple(p, i) if i < p.end else ():
        if isinstance(hub, Noun) and not hub.plural and hub.amount in (None, _ONE) and _one_look(hub):
            yield hub, j


def _rings(p: Parser, i: int) -> Results[Noun]:
    yield from _rings_at(p, i) if i else ()


def _rings_at(p: Parser, i: int) -> Results[Noun]:
    for ring, j in simple(p, i):
        if isinstance(ring, Noun) and ring.det in ("a", "bare", "the") and (_one_look(ring) or _of_any_look(ring)):
            yield ring, j


def _two(p: Parser, i: int) -> Results[Meaning]:
    yield from _two_at(p, i) if i else ()


def _two_at(p: Parser, i: int) -> Results[Meaning]:
    """Two blocks: "a black block (on both sides)", "two black ones", "red and blue"."""
    for sides, j in noun_phrase(p, i):
        if isinstance(sides, Coord) and sides.op == "and" and len(sides.items) == 2:
            if all(isinstance(x, Noun) and not x.plural and x.amount in (None, _ONE) for x in sides.items):
                yield sides, j
        elif isinstance(sides, Noun) and sides.amount == Amount(2, 2) and _one_look(sides):
            yield sides, j
        elif isinstance(sides, Noun) and sides.amount == _ONE and sides.det == "a" and _one_look(sides):
            pair = replace(sides, det="bare", amount=Amount(2, 2), plural=True)
            end = p.any_of(j, _BOTH_SIDES)
            if end or p.words[i - 2] in ("sides", "side"):
                yield pair, end or j


def _one_look(noun: Noun) -> bool:
    marks = noun.traits
    told = len(marks.colors) + len(marks.labels) == 1 and not (marks.rank or marks.extra)
    return told and noun.head != "patch" and noun.part_of is None and not noun.conditions


def _between(p: Parser, i: int, j: int, hub: Noun, sides: Meaning) -> Clause:
    place = Loc(rel="between", landmark=sides, span=sides.span)
    return Clause(verb="be", theme=hub, adjuncts=(place,), mode="goal", span=p.span(i, j))


def _shaped(p: Parser, i: int, j: int, hub: Noun, ring: Noun) -> Results[Clause]:
    """Four blocks around one are a plus; of others the shape must be said."""
    for kind, k in _shapes(p, j):
        if ring.amount is not None and (kind == "circle" or ring.amount == Amount(8, 8)):
            yield _outlined(p, i, k, hub, ring, kind), k
    each = one_on_each(p, j)
    if ring.amount == _FOUR or (each and ring.amount is None and ring.plural):
        yield from _plus(p, i, each or j, hub, ring)
    elif not each and ring.plural and (ring.amount is None or _makes_a_circle(ring.amount)):
        yield _outlined(p, i, j, hub, ring, "circle"), j


def _shapes(p: Parser, i: int) -> Results[str]:
    """ "in a circle", "so that they form a 3x3 square": the figure that the blocks around one make (with it)."""
    j = p.any_of(i, _IN_SHAPE)
    if not j:
        return
    three = j + 1 if j < p.end and p.tokens[j].kind == "dims" and p.tokens[j].value == (3, 3) else 0
    three = three or p.any_of(j, ("three by three", "3 by 3"))
    if k := p.one(three or j, _SHAPES):
        kind = _SHAPES[p.words[k - 1]]
        if kind == "square" or not three:
            yield kind, k


def _of_any_look(ring: Noun) -> bool:
    """ "(put) the blocks (around the red one)", "six blocks"."""
    mere = ring.head == "block" and ring.traits == Traits(size=ring.traits.size) and ring.plural
    return mere and ring.part_of is None and not ring.conditions


def _makes_a_circle(many: Amount) -> bool:
    """Whether so many blocks around one can only be a circle: four are a plus, and eight a square as well."""
    return many.low == many.high and many.low > _FOUR.low and many.low != 2 * _FOUR.low


_SIDE = {
    **{f"{lead}{side}": (side,) for lead in ("", "on the ", "to the ", "on its ", "to its ", "at the ")
       for side in ("left", "right")},
    "in front": ("front",), "in front of it": ("front",), "behind": ("behind",), "behind it": ("behind",),
    "at the back": ("behind",), "on each side": ("left", "right"), "on either side": ("left", "right"),
    "left and right": ("left", "right"), "in front and behind": ("front", "behind"),
}  # fmt: skip
_ALL_FOUR = frozenset({"left", "right", "front", "behind"})
_THEN = (", and", "and", ",")


@choice
def around_told(p: Parser, i: int) -> Results[Clause]:
    """ "around the white block: red on its left, blue on its right": which block stands on which side of it."""
    start = p.any_of(i, ("put", "place", "arrange", "there are")) or i
    mark, many = p.any_of(start, _ROUND), None
    if not mark:
        mark, many = next(((p.any_of(j, _ROUND), blocks.amount) for blocks, j in _bare_blocks(p, start)), (0, None))
    for hub, j in _hubs(p, mark) if mark else ():
        colon = p.one(j, (":", ","))
        for told, k in _on_sides(p, colon, hub, ()) if colon else ():
            if len(told) > 1 and (many is None or many.low == many.high == len(told)):
                rest = Chain(clauses=told[1:], links=("and",) * (len(told) - 1), span=p.span(colon, k))
                so = That(kind="so", clauses=rest, span=rest.span)
                yield replace(told[0], adjuncts=(*told[0].adjuncts, so), span=p.span(i, k)), k


_ROUND = ("around", "all around", "round", "in a circle around", "in a ring around")


def _bare_blocks(p: Parser, i: int) -> Results[Noun]:
    """ "three blocks (around ...)": told of one by one behind it."""
    for blocks, j in simple(p, i):
        if isinstance(blocks, Noun) and blocks.head == "block" and blocks.traits == Traits() and not blocks.part_of:
            yield blocks, j


def _on_sides(p: Parser, i: int, hub: Noun, had: tuple[Clause, ...]) -> Results[tuple[Clause, ...]]:
    for theme, j in simple(p, i):
        side = p.standing(p.any_of(j, ("is", "goes", "stands")) or j, _SIDE) if isinstance(theme, Noun) else []
        if not side or not isinstance(theme, Noun) or theme.plural or len(_SIDE[side[-1][0]]) > 1:
            continue
        phrase, k = side[-1]
        it = replace(hub, det="the", amount=None) if had else hub
        place = Loc(rel=_SIDE[phrase][0], landmark=it, span=p.span(j, k))
        told = (*had, Clause(verb="be", theme=theme, adjuncts=(place,), mode="goal", span=p.span(i, k)))
        yield told, k
        if (more := p.any_of(k, _THEN)) and len(told) < len(_ALL_FOUR):
            yield from _on_sides(p, more, hub, told)


def _plus(p: Parser, i: int, j: int, hub: Noun, ring: Noun) -> Results[Clause]:
    arms = replace(ring, det="bare", amount=_FOUR, plural=True)
    middle = replace(hub, det="a") if hub.det == "another" else hub
    centre = Absolute(theme=middle, adjuncts=(At(side="middle", span=hub.span),), span=hub.span)
    rest = Absolute(theme=arms, adjuncts=(Places(side="rest", unit="block", span=ring.span),), span=ring.span)
    shape = Structure(
        kind="plus", members=Coord(op="and", items=(hub, arms), span=hub.span),
        details=(Coord(op="absolutes", items=(centre, rest), span=hub.span),), span=p.span(i, j),
    )  # fmt: skip
    yield Clause(verb="build", theme=shape, mode="goal", span=p.span(i, j)), j
    if k := touching(p, j, ring.traits):
        gapless = (Spacing(kind="touching", span=p.span(j, k)),)
        yield Clause(verb="build", theme=shape, adjuncts=gapless, mode="goal", span=p.span(i, k)), k


def _outlined(p: Parser, i: int, j: int, hub: Noun, ring: Noun, kind: str) -> Clause:
    inside = At(side="middle", whole=kind, span=hub.span)
    centre = Absolute(theme=replace(hub, head="block"), adjuncts=(inside,), span=hub.span)
    outline = Structure(kind=kind, members=replace(ring, det="bare"), span=p.span(i, j))
    return Clause(verb="build", theme=outline, adjuncts=(centre,), mode="goal", span=p.span(i, j))
