"""What follows the noun of a structure: its sizes, the blocks that it is made of, and which stand where."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from rpg.core.diagnostics import Span
from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.structures.along import listed_again, listed_along, listed_in_turn
from rpg.language.grammar.structures.apposed import (
    a_lot_each,
    colored_ones,
    layers_told,
    members_told,
    of_all_of_them,
)
from rpg.language.grammar.structures.ascents import measures
from rpg.language.grammar.structures.each_line import one_line_each
from rpg.language.grammar.structures.gradients import gradient
from rpg.language.grammar.structures.heights import with_heights
from rpg.language.grammar.structures.hues import in_colors, members_amount
from rpg.language.grammar.structures.limbs import LIMBED, arms_told, limb
from rpg.language.grammar.structures.outlines import HOLLOW, along_sides, rim_of
from rpg.language.grammar.structures.sizes import (
    IN_TOTAL,
    as_high,
    each_told,
    ends_in_lines,
    in_lines,
    lines_of,
    size_phrase,
)
from rpg.language.grammar.structures.steps import steps_told
from rpg.language.grammar.structures.told_by_one import left_open, placed_inside, shows_it, told_by_one
from rpg.language.grammar.things import amounts
from rpg.language.grammar.things.adjectives import colors
from rpg.language.grammar.things.labels import run
from rpg.language.later import later
from rpg.language.meaning import (
    Absolute,
    Amount,
    Coord,
    Into,
    Meaning,
    Noun,
    Pattern,
    Places,
    Pronoun,
    Size,
    Structure,
    Traits,
)

if TYPE_CHECKING:
    from rpg.language.grammar.places.absolutes import one_more, sided
    from rpg.language.grammar.places.onto import counted_pile, one_on_another
    from rpg.language.grammar.structures.each import each_of
    from rpg.language.grammar.structures.wholes import wholes, with_stranger
    from rpg.language.grammar.things.nouns import noun_phrase
else:
    one_more, sided = later(__name__, "rpg.language.grammar.places.absolutes", "one_more", "sided")
    counted_pile, one_on_another = later(__name__, "rpg.language.grammar.places.onto", "counted_pile", "one_on_another")
    (each_of,) = later(__name__, "rpg.language.grammar.structures.each", "each_of")
    wholes, with_stranger = later(__name__, "rpg.language.grammar.structures.wholes", "wholes", "with_stranger")
    (noun_phrase,) = later(__name__, "rpg.language.grammar.things.nouns", "noun_phrase")

_IN_A_ROW = ("in a row", "in a line", "in one row", "standing in a row", "lined up", "in one line")


def sized_members(p: Parser, i: int, j: int, base: Structure, by: bool = False) -> Results[Meaning]:
    """A structure with what is said of its size, of its blocks, and of single ones among them.

    `by`: "by" is what leads to its blocks, as behind "a tower shall be formed"."""
    if base.plural and base.kind == "stack" and not base.details and (row := p.any_of(j, _IN_A_ROW)):
        into = Into(structure=Structure(kind="row", span=p.span(j, row)), span=p.span(j, row))
        lined = sized_members(p, i, row, replace(base, details=(into,)))
        yield from (
            (whole, end) for whole, end in lined if end > row
        )  # "three towers in a row, each of two red blocks"
    yield from with_heights(p, i, j, base) if base.plural else ()
    if base.kind == "staircase" and not base.sizes:
        for (steps, rising, named), k in steps_told(p, j):
            traits = replace(base.traits, colors=base.traits.colors or named)
            told = replace(base, sizes=(steps,), details=(*base.details, *rising), traits=traits, span=p.span(i, k))
            yield from _sized(p, i, k, told)
    for sized, k in as_high(p, _sized(p, i, j, base)):
        yield sized, k
        yield from gradient(p, i, k, sized) if base.kind == "gradient" and not sized.members else ()
        yield from _one_each(p, i, k, sized)
        for whole, end in _members(p, i, k, sized, by):
            yield from as_high(p, [(whole, end)])
            yield from counted_pile(p, i, end, whole)
            yield from _one_each(p, i, end, whole)
            for lot, last in each_of(p, end) if base.plural else ():
                yield replace(whole, details=(*whole.details, lot), span=p.span(i, last)), last
            yield from _sided(p, i, end, whole)
            yield from in_colors(p, i, end, whole)
            for along, last in listed_again(p, end, _of_so_many(whole)):
                yield replace(whole, details=(*whole.details, along), span=p.span(i, last)), last
            yield from ((more, e) for more, e in _sized(p, i, end, whole) if e > end)
        yield from _sided(p, i, k, sized)
        for lot, end in each_of(p, k) if base.plural else ():
            yield replace(sized, details=(*sized.details, lot), span=p.span(i, end)), end
        yield from _piled(p, i, k, sized, by)
        yield from in_colors(p, i, k, sized)
        if base.kind in ("stack", "row", "line", "column"):
            for along, end in [*listed_in_turn(p, k), *listed_along(p, k)]:
                yield replace(sized, details=(*sized.details, along), span=p.span(i, end), cost=sized.cost + 1), end


def _of_so_many(base: Structure) -> int:
    """ "a row of five", of which no more is said; 0 for others."""
    line = base.members is None and base.kind in ("stack", "row", "line", "column")
    return base.size.low if line and base.size is not None else 0


def _piled(p: Parser, i: int, k: int, base: Structure, by: bool) -> Results[Structure]:
    """ "a tower of red on green on blue"."""
    lead = p.any_of(k, (",", ":", "in which", "where", ", with", "that is", "which is", "that has", "having"))
    lead = p.any_of(p.opt(k, ","), _PILED) or lead or p.any_of(k, _OF) or (p.one(k, "by") if by else 0)
    lead = lead or (k if base.det in ("the", "a") and k < p.end and p.words[k] in lexicon.COLOR else 0)
    if not lead or base.kind != "stack" or base.plural or base.sizes or base.traits.colors:
        return
    for order, end in one_on_another(p, lead):
        yield replace(base, details=(*base.details, order), span=p.span(i, end)), end


_DETAILED = frozenset({"with", ",", "having", "where", ":", "whose", "in", "of", "so", "such", "except", "but",
                       "starting", "that", "which"})  # fmt: skip


def _sided(p: Parser, i: int, k: int, base: Structure) -> Results[Structure]:
    """ "a tower with red at the bottom and blue on top": its parts belong to it, wherever it stands in the sentence."""
    if k < p.end and p.words[k] in _DETAILED:
        for detail, end in sided(p, k):
            whole = of_all_of_them(base, detail) or replace(base, details=(*base.details, detail))
            yield replace(whole, span=p.span(i, end)), end
    if base.sizes and p.one(k, "and"):
        for detail, end in one_more(p, k + 1):
            yield replace(base, details=(*base.details, detail), span=p.span(i, end)), end


def _one_each(p: Parser, i: int, k: int, base: Structure) -> Results[Structure]:
    """ "two towers ..., one red and one blue", "... the left one red and the right one blue"."""
    towers = base.plural and base.kind == "stack" and base.amount is not None
    many = base.amount.low if towers and base.amount is not None else 0
    for named, end in colored_ones(p, k, many) if many else ():
        yield _painted(base, named, Pattern(unit="stack", span=p.span(k, end)), p.span(i, end)), end
    lots = a_lot_each(p, k, many) if many else ()
    for told, end in lots if base.members is None else ():
        yield replace(base, details=(*base.details, told), span=p.span(i, end)), end
    # "each with one red and one blue" is of the blocks of a tower
    of_each = p.stands(k, ("with",)) and p.follows(k, ("each", "apiece"))
    for found, end in wholes(p, k) if base.plural and not of_each else ():
        places = [x.adjuncts[0] for x in found.items if isinstance(x, Absolute)]
        themes = [x.theme for x in found.items if isinstance(x, Absolute)]
        colors = tuple(c for theme in themes if isinstance(theme, Noun) for c in theme.traits.colors)
        plain = not any(isinstance(theme, Noun) and theme.amount is not None for theme in themes)
        alike = plain and len(colors) == len(themes) and all(isinstance(x, Places) and x.side == "one" for x in places)
        if base.kind == "stack" and alike:
            yield _painted(base, colors, Pattern(unit="stack", span=found.span), p.span(i, end)), end
        else:
            yield replace(base, details=(*base.details, found), span=p.span(i, end)), end


def _painted(base: Structure, colors: tuple[str, ...], pattern: Pattern, span: Span) -> Structure:
    members, traits = base.members, base.traits
    if isinstance(members, Noun):
        members = replace(members, traits=replace(members.traits, colors=members.traits.colors or colors))
    else:
        traits = replace(traits, colors=traits.colors or colors)
    return replace(base, members=members, traits=traits, details=(*base.details, pattern), span=span)


@rule
def per_color(p: Parser, i: int) -> Results[Pattern]:
    """ "per colour", "for each colour"."""
    if j := p.any_of(i, ("per color", "for each color", "for every color", "of each color")):
        yield Pattern(unit="stack", span=p.span(i, j)), j


def _counted_behind(p: Parser, i: int, j: int, base: Structure) -> Results[Structure]:
    """ "red row, seven": how many blocks it has."""
    if base.sizes or base.plural or base.kind not in _COUNTED or not p.stands(j, (",", ":")):
        return
    closed = j + 2 >= p.end or (p.words[j + 2] == "," and p.words[j + 3] in ("on", "in", "at", "near"))
    if closed and (many := p.number(j + 1)):
        size = Size(what="size", amount=Amount(many, many), span=p.span(j, j + 2))
        yield replace(base, sizes=(size,), span=p.span(i, j + 2)), j + 2


@rule
def _sized(p: Parser, i: int, j: int, base: Structure) -> Results[Structure]:
    yield base, j
    if len(base.sizes) > 3:
        return
    hollow = p.any_of(j, (",", ", and", ", but", "and", "but", ":")) or j
    if k := max(HOLLOW.matches(p, hollow), default=0):
        yield from _sized(p, i, k, replace(rim_of(p, hollow, k, base), filled=False, span=p.span(i, k)))
    if k := p.any_of(
        j, (", filled", ", filled in", ", solid", "that is filled", "that is filled in", ", completely filled")
    ):
        yield from _sized(p, i, k, replace(base, filled=True, span=p.span(i, k)))
    if p.stands(j, ("filled",)) and p.number(j + 1) is not None:
        yield from _sized(p, i, j + 1, replace(base, filled=True, span=p.span(i, j + 1)))
    drawn = base.kind in LIMBED or base.kind in _DRAWN
    if k := p.any_of(j, _LYING_FLAT) or (p.any_of(j, _DRAWN_FLAT) if drawn else 0):
        yield from _sized(p, i, k, replace(base, upright=False, span=p.span(i, k)))
    plain = base.members is None and not base.traits.colors
    for blocks, k in members_told(p, j, base) if plain else ():
        yield replace(base, members=blocks, span=p.span(i, k)), k
    comma = p.opt(j, ",") if base.kind != "checkerboard" else p.opt(j, ",", "in")
    flat = base.kind in _FLAT
    every = p.any_of(j, _ALL_ARE) if flat else 0
    bare = flat and comma == j and not every and bool(base.dims or base.sizes) and "and" not in p.words[:i]
    if plain and not amounts.of_more(p, comma, i) and (comma > j or every or base.kind == "checkerboard" or bare):
        for (named, either), k in colors(p, every or p.any_of(comma, _ALL_IN) or comma):
            if bare and k < p.end:
                continue  # "filled 3x3 square purple"
            k = p.opt(k, "blocks", "cubes", "bricks", "ones") if len(named) == 1 or not flat else k
            k = p.opt(k, "everywhere", "only") if flat else k
            closed = k >= p.end or p.words[k] == "," or (flat and p.words[k] in _CLOSED)
            if not either and (len(named) == 1 or base.kind == "checkerboard") and closed:
                painted = replace(base.traits, colors=named)
                cost = base.cost + (0 if every or p.words[comma] == "all" else 1)
                yield replace(base, traits=painted, span=p.span(i, k), cost=cost), k
    yield from _counted_behind(p, i, j, base) if base.traits.colors and base.members is None else ()
    for unit, named, k in one_line_each(p, j) if plain and base.kind in _LINED and p.anywhere(_ONE) else ():
        pattern = Pattern(unit=unit, span=p.span(j, k))
        traits = replace(base.traits, colors=named)
        yield replace(base, traits=traits, details=(*base.details, pattern), span=p.span(i, k)), k
    for told, k in along_sides(p, i, j, base):
        yield from _sized(p, i, k, told)
    limbs = limb(p, j, base.kind) if base.kind in LIMBED else ()
    for (arms, way), k in arms_told(p, j) if base.kind == "L" else ():
        yield replace(base, sizes=(*base.sizes, *arms), details=(*base.details, *way), span=p.span(i, k)), k
    if plain and base.kind in _FLAT and (lead := p.any_of(j, ("in", "all in"))):
        for (named, either), k in colors(p, lead):
            if not either and len(named) == 1 and (k >= p.end or p.words[k] in _CLOSED):
                yield replace(base, traits=replace(base.traits, colors=named), span=p.span(i, k)), k
    tiers = layers_told(p, j) if base.kind == "pyramid" and not base.sizes else ()
    for size, k in [*limbs, *tiers, *lines_of(p, j, base.kind), *size_phrase(p, j)]:
        if not base.plural and base.kind in _LINES and not _EACH_ONE.isdisjoint(p.words[j:k]):
            continue  # "a red and a blue tower, each three high": said of both
        k = (p.any_of(k, _EACH) or k) if base.plural else k
        lines = size.what == "dims" and base.kind == "rectangle" and base.filled is not False
        lines = lines and in_lines(p, j, k)
        changed = replace(base, sizes=(*base.sizes, size), span=p.span(i, k), kind="grid" if lines else base.kind)
        yield from _sized(p, i, k, changed)


_DRAWN = ("V", "U", "X", "grid", "square", "circle", "rectangle", "plus", "triangle")
_LYING_FLAT = (
    *(f"{lies} flat{on}" for lies in (", lying", "lying", "which lies", "that lies") for on in (" on the table", "")),
    ", flat on the table", "flat on the table",
)  # fmt: skip
_DRAWN_FLAT = ("lying on the table", ", lying on the table", ", flat")
_COUNTED = ("row", "line", "column", "stack", "circle")
_LINED = ("grid", "square", "rectangle", "wall")
_ONE = frozenset({"one", "other", "another"})
_FLAT = ("grid", "square", "rectangle", "wall", "pyramid", "circle", "plus", "staircase", "cube")
_CLOSED = frozenset({",", "with", "except", "but", "where", ":", "apart", "save"})
_ALL_ARE = (
    *(
        f"{lead}{every}"
        for lead in (", where ", "where ", "in which ", ", in which ", "with ", ", with ")
        for every in ("all blocks are", "all the blocks are", "all cubes are", "all the cubes are", "every block is",
                      "every cube is", "everything is", "each block is", "all blocks being", "all blocks", "all cubes",
                      "all of the blocks are", "all the blocks")
    ),
    ": all", ": all in", ": everything", ": all blocks", ": all cubes",
)  # fmt: skip
"""What says of all blocks of a figure which colour they have."""
_ALL_IN = ("all in", "all", "in", "all blocks", "all cubes", "all of them", "all of it", "every block",
           "all the blocks", "all blocks in", "all are", "everything")  # fmt: skip


_EACH_ONE = frozenset({"each", "both", "apiece", "every"})
_LINES = ("row", "line", "column", "stack", "circle", "pile", "word")
"""Structures of which "two each" says nothing by itself: it is said of the kinds of blocks."""
_OF = ("of", "made of", "made out of", "made from", "made up of", "built from", "consisting of", "composed of",
    "built of", "formed by", "formed of", "comprising",
       "containing", "using", "constructed from", "out of", "built with", "which consists of", "that consists of",
       "which is made of",
       "that is made of", "that consist of", "which consist of", "that are made of", "that contains",
       "which contains", "that uses", "which uses", "made with", "with only", "from", "built out of", "formed from",
       "constructed of", "for", "with", "full of", "filled with", "filled by")  # fmt: skip


_MADE = ("made of", "made out of", "made from", "made up of", "built from", "built of", "composed of", "built with",
         "built out of", "made with", "formed by", "formed from")  # fmt: skip
_WHICH = ("which is ", "that is ", "which are ", "that are ", "")
_BUILT = (*(w + m for w in _WHICH for m in _MADE), "consisting of", "which consists of", "that consists of")
_PILED = (*_BUILT, "which is", "that is")
"""Those of them that a comma may stand in front of."""
_EACH = ("each", "apiece", "in each one", "in each", "in each of them", "in every one", "per tower", "in each tower",
         "per stack", "in each stack")  # fmt: skip
"""What says that a number of blocks is that of each of several structures."""
_OF_EACH = (
    *(f"{each} {of}" for each in ("each", "every", "every one") for of in ("of", "consisting of", "composed of", "with",
                                                                           *_MADE)),
    *(f"{lead}each{one} {has}" for lead in ("", "and ") for one in ("", " of them", " one", " one of them", " tower")
      for has in ("has", "having", "should have", "must have", "consists of", "contains", "is made of")),
)  # fmt: skip


def _members(p: Parser, i: int, j: int, base: Structure, by: bool) -> Results[Structure]:
    if base.filled is None and base.kind in ("square", "rectangle", "triangle") and p.stands(j, ("filled", "full")):
        base = replace(base, filled=True)
    by = by or (p.stands(j, ("by",)) and p.number(j + 1) is not None)
    k = p.any_of(j, _OF) or p.any_of(p.opt(j, ","), _BUILT) or (p.one(j, "by") if by else 0)
    k = k or (p.any_of(p.opt(j, ","), _OF_EACH) if base.plural else 0)
    for members, end in noun_phrase(p, j + 1) if base.plural and not base.sizes and p.stands(j, (",", ":")) else ():
        last = p.any_of(end, _EACH) if isinstance(members, Noun) and members.det == "bare" and members.amount else 0
        if last and isinstance(members, Noun) and members.head == "block" and len(members.traits.colors) < 2:
            whole = replace(base, members=members, each_size=True, details=each_told(base), span=p.span(i, end))
            yield whole, last  # "three towers, two red blocks each"
    if base.sizes and base.sizes[-1].what == "dims" and not k:
        for members, end in noun_phrase(p, j):
            if isinstance(members, Noun) and members.det == "bare" and members.plural and members.amount is None:
                yield replace(base, members=members, span=p.span(i, end)), end
    if not k or (p.words[k - 1] == "from" and run(p, k)):
        return
    for lot, end in with_stranger(p, k) if base.kind == "pile" else ():
        yield replace(base, members=lot, span=p.span(i, end)), end
    for labels, end in run(p, k):
        if not measures(p, end):
            shown = Noun(head="block", plural=True, traits=Traits(labels=labels), span=p.span(k, end))
            yield replace(base, members=shown, span=p.span(i, end)), end
    if base.kind in ("row", "line") and not (base.plural or base.sizes or base.details) and p.words[k - 1] == "of":
        for towers, end in noun_phrase(p, k):
            if isinstance(towers, Structure) and towers.kind == "stack" and towers.plural:
                into = Into(structure=base, span=base.span)
                yield replace(towers, details=(*towers.details, into), span=p.span(i, end)), end
    for start in dict.fromkeys((k, p.one(k, "each"))):
        for members, end in noun_phrase(p, start) if start else ():
            if not _are_members(p, j, k, base, members, end):
                continue
            if base.plural and isinstance(members, Coord) and members.items[0].span[0] > p.tokens[start].span[0]:
                continue
            each = _number_of_each(p, j, k, base, members, end)
            end = end if base.plural else p.any_of(end, IN_TOTAL) or end
            last = (p.any_of(end, _EACH) if base.plural else 0) or end
            own = each_told(base) if each and (last > end or p.words[start - 1] == "each") else base.details
            yield replace(base, members=members, span=p.span(i, end), each_size=each, details=own), last
    if not base.sizes:
        for found, end in amounts.amount(p, k):
            if shows_it(p, j, end):
                continue
            size = Size(what="size", amount=found, span=p.span(k, end))
            cost = base.cost + (0 if base.plural else 1)
            last = p.opt(end, "each", "apiece") if base.plural else end
            yield replace(base, sizes=(size,), span=p.span(i, end), cost=cost), last


def _are_members(p: Parser, j: int, k: int, base: Structure, members: Meaning, end: int) -> bool:
    """Whether a phrase behind the noun can be what the structure is made of."""
    lone = isinstance(members, Noun) and members.det in ("the", "a") and not members.plural and not members.amount
    upon = base.plural and isinstance(members, Noun) and not members.plural and p.stands(end, ("on", "over", "above"))
    beside = lone and not told_by_one(p, base, members, end)
    if upon or (p.words[k - 1] == "with" and (beside or placed_inside(p, members, end))):
        return False
    # "Two towers of three blocks, each on a mat": of the towers.
    each = isinstance(members, Noun) and members.det == "each" and members.part_of is not None
    if each or any(isinstance(x, Noun) and x.traits.extra for x in getattr(members, "items", (members,))):
        return False
    if isinstance(members, Structure) or (isinstance(members, Pronoun) and p.words[k - 1] == "for"):
        return False
    if isinstance(members, Coord):
        again = base.kind == "pile" and "group" in p.words[k:end]  # "a group of red ones and a group of blue ones"
        mixed = any(isinstance(x, Structure | Pronoun) for x in members.items)
        if again or mixed or p.one(end, ("each", "apiece")) or left_open(p, k, end):
            return False
        if base.plural and ("each" in p.words[j:k] or any(map(_mere_number, members.items))):
            return False
    return not (ends_in_lines(p, j) and base.sizes and members_amount(members) is not None)


def _number_of_each(p: Parser, j: int, k: int, base: Structure, members: Meaning, end: int) -> bool:
    """ "two towers of three blocks": three in each of them."""
    if members_amount(members) is None or not base.plural:
        return False
    of = p.words[k - 1] == "of" and p.words[j] != "out"
    of = of or "each" in p.words[j:k] or "every" in p.words[j:k]
    return of or p.words[k - 1] in ("with", "containing") or p.one(end, ("each", "apiece")) > 0


def _mere_number(item: Meaning) -> bool:
    """ "towers of two and three red blocks": so many of each, no members."""
    return isinstance(item, Noun) and item.head == "any" and item.traits == Traits() and item.amount is not None
