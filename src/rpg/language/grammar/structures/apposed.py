"""What a comma adds to a structure: which symbols it shows, how many blocks each of its layers has."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.structures.each_line import EACH
from rpg.language.grammar.things.adjectives import color, colors
from rpg.language.grammar.things.lists import listed
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Absolute, Amount, At, Coord, Meaning, Noun, Places, Size, Structure, Traits, replace

_LINED = ("grid", "row", "line", "column", "stack", "square", "circle", "rectangle", "wall", "checkerboard")


def members_told(p: Parser, j: int, base: Structure) -> Results[Noun | Coord]:
    """What a structure is made of, set off behind it."""
    yield from apposed_blocks(p, j, not base.plural)
    yield from symbols_told(p, j, base.kind)
    if not (base.plural or base.sizes) and base.kind in ("row", "line", "column", "stack"):
        yield from counted_lots(p, j)


@rule
def symbols_told(p: Parser, j: int, kind: str) -> Results[Noun]:
    """ ", letters A to F", ": digits 1, 2 and 3": the symbols that a structure shows."""
    start = p.one(j, (",", ":")) if kind in _LINED else 0
    if not start:
        return
    the = p.opt(start, "the")
    if p.lex(the, lexicon.LETTER) is None and p.lex(the, lexicon.DIGIT) is None:
        return
    for found, k in simple(p, start):
        marks = found.traits if isinstance(found, Noun) else Traits()
        plain = marks == Traits(labels=marks.labels, kind=marks.kind)
        if isinstance(found, Noun) and plain and len(marks.labels) > 1 and found.amount is None:
            yield found, k


@rule
def apposed_blocks(p: Parser, j: int, alone: bool = False) -> Results[Noun]:
    """ ", red blocks", ", all blocks green", ", five red blocks" of a structure that stands `alone`: what the blocks of
    a structure look like, closed by the next comma."""
    if not p.stands(j, (",", ":") if alone else (",",)):
        return
    start = p.opt(j + 1, "all")
    if every := p.any_of(start, ("blocks", "cubes", "of the blocks", "the blocks", "of the cubes", "the cubes")):
        for (named, either), k in colors(p, p.any_of(every, ("are", "being", "in")) or every) if start > j + 1 else ():
            if not either and len(named) == 1 and (k >= p.end or p.words[k] == ","):
                yield Noun(head="block", plural=True, traits=Traits(colors=named), span=p.span(start, k)), k
    many = p.number(start) if alone and start == j + 1 else None
    amount = Amount(many, many) if many else None
    for (named, either), k in colors(p, start + 1 if many else start):
        end = p.one(k, ("blocks", "cubes", "bricks"))
        if end and not either and len(named) == 1 and (end >= p.end or p.words[end] == ","):
            look = Traits(colors=named)
            yield Noun(head="block", amount=amount, plural=True, traits=look, span=p.span(start, end)), end


@rule
def counted_lots(p: Parser, j: int) -> Results[Coord]:
    """ "(one row,) 3 pink and 3 black, (colours alternating)": of how many blocks of which looks a line is made."""
    start = p.one(j, (",", ":"))
    items: list[Meaning] = []
    at = start
    while at and len(items) < _MOST_LOTS:
        lot = next(((x, k) for x, k in simple(p, at) if isinstance(x, Noun) and _counted_look(x)), None)
        if lot is None:
            return
        items.append(lot[0])
        if len(items) > 1 and p.stands(lot[1], (",", ":")):
            yield Coord(op="and", items=tuple(items), span=p.span(start, lot[1])), lot[1]
        at = p.any_of(lot[1], (", and", "and", ","))


_MOST_LOTS = 6


def _counted_look(lot: Noun) -> bool:
    """ "3 pink", "a white one": a number and a colour."""
    exact = lot.amount is not None and lot.amount.low == lot.amount.high and lot.det in ("bare", "a")
    return exact and len(lot.traits.colors) == 1 and lot.traits == Traits(colors=lot.traits.colors) and not lot.part_of


def of_all_of_them(base: Structure, detail: Meaning) -> Structure | None:
    """ "(a row) with two green blocks and a red one in the middle": made of all of these, and the red one is there."""
    theme, place = (detail.theme, detail.adjuncts[0]) if isinstance(detail, Absolute) else (None, None)
    items = theme.items if isinstance(theme, Coord) and theme.op == "and" else ()
    plain = base.members is None and not (base.sizes or base.dims or base.plural or base.traits.colors)
    if not plain or base.kind not in ("row", "line", "column", "stack") or not isinstance(place, At) or place.index:
        return None
    counts = [x.amount.low if isinstance(x, Noun) and x.amount and x.part_of is None else 0 for x in items]
    last = items[-1] if items else None
    if not counts or 0 in counts or counts[-1] > 1 or max(counts) < 2 or not isinstance(last, Noun):
        return None
    if place.side == "middle" and sum(counts) % 2 == 0:
        return None
    alone = replace(last, det="the", amount=None, plural=False)
    told = Absolute(theme=alone, adjuncts=(place,), span=detail.span)
    return replace(base, members=theme, details=(*base.details, told))


@rule
def a_lot_each(p: Parser, i: int, many: int) -> Results[Coord]:
    """ "(two towers:) 2 red and 3 blue blocks": behind a colon as many lots as there are towers, one for each."""
    at = p.one(i, ":")
    lots: list[Absolute] = []
    while at and len(lots) < many:
        number, j = p.number(at), at + 1
        named = next(iter(color(p, j)), None) if number is not None else None
        if number is None or named is None:
            return
        end = p.any_of(named[1], _BLOCKS) or named[1]
        span = p.span(at, end)
        theme = Noun(head="block", amount=Amount(number, number), plural=number > 1, traits=Traits(colors=(named[0],)),
                     span=span)  # fmt: skip
        lots.append(Absolute(theme=theme, adjuncts=(Places(side="one", unit="whole", span=span),), span=span))
        if len(lots) == many > 1 and (end >= p.end or p.words[end] in (",", ";")):
            yield Coord(op="absolutes", items=tuple(lots), span=p.span(i, end)), end
        at = p.any_of(end, (", and", ",", "and", "+", ";"))


_BLOCKS = ("blocks", "block", "cubes", "cube", "bricks", "ones", "one")
_BELOW = ("at the bottom", "on the bottom", "in the bottom row", "in the bottom layer", "below", "as a base", "first",
          "at the base", "on the ground", "in the first layer", "as the base", "down below", "in the lowest layer",
          "in the lowest row", "on the bottom row", "on the bottom layer", "in the base", "in the base layer",
          "in the base row", "along the bottom", "at the very bottom")  # fmt: skip
_ABOVE = ("above", "on top", "on top of that", "above that", "at the top", "above them", "on them", "on those",
          "on top of those", "on top of them", "at the very top", "in the next", "in the middle", "next",
          *(f"{at} the {part}" for at in ("at", "as", "for") for part in ("tip", "peak", "apex", "summit", "very top")),
          *(f"{at} the {nth} {row}" for at in ("in", "on") for nth in ("second", "middle", "next", "third", "top",
                                                                      "upper") for row in ("layer", "row", "level")),
          "above these", "on these", "over them", "over those", "on it", "on top of these")  # fmt: skip
AMID = ("in the middle", "in the center", "centered", "centrally", "in between", "between them", "over the gap",
        "centered on them", "centered over them", "over the middle", "across both", "across them", "astride them",
        "over the joint", "on the middle", "centered above them")  # fmt: skip
"""Where the next layer of a pyramid lies anyway."""
_THEN = (", then", ", and then", "then", "and then", ", and", "and", ",", ", finally", ", and finally", "followed by",
         ", followed by", ", next", "and finally")  # fmt: skip


_OF_LAYERS = (
    *(",", ":", "with", "of", ", with", "-", "having"),
    *(f"{lead}{base}" for lead in (", ", "with a ", "with ", ", with a ", ": ", "on a ", "with the ", "")
      for base in ("base", "base of", "base :", "bottom layer of", "bottom row of", "base row of")),
)  # fmt: skip
"""What stands before the number of blocks in the lowest layer."""


@rule
def layers_told(p: Parser, j: int) -> Results[Size]:
    """ "(a pyramid,) 3 blocks at the bottom, then 2, then 1": one less from layer to layer, down to one block."""
    if start := p.any_of(j, _OF_LAYERS):
        yield from _layers(p, start)


def layers_alone(p: Parser, i: int) -> Results[Size]:
    """In a sentence of its own: "(A pyramid.) 3 on the bottom row, 2 on those and 1 at the top." """
    if i == 0:
        yield from ((size, k) for size, k in _layers(p, i) if k >= p.end)


def _layers(p: Parser, start: int) -> Results[Size]:
    number = p.number(start)
    if number is None or number < 2:
        return
    left, at = number, start + 1
    while True:
        at = p.any_of(at, _BLOCKS) or at
        at = p.any_of(at, _BELOW if left == number else _ABOVE) or at
        at = p.any_of(p.opt(at, ","), AMID) or at if left < number else at
        if left == 1:
            break
        k = p.any_of(at, _THEN)
        left -= 1
        if not k or p.number(k) != left:
            return
        at = k + 1
    yield Size(what="base", amount=Amount(number, number), span=p.span(start, at)), at


def colored_ones(p: Parser, i: int, many: int) -> Results[tuple[str, ...]]:
    """ "(two towers), a red one and a blue one", "..., one colour each: red and blue": the colours of so many."""
    for j in EACH.matches(p, p.opt(i, ",")) if p.anywhere(_EACHES) else ():
        for items, end in listed(p, lead) if (lead := p.any_of(j, (":", ",", "-", ", namely"))) else ():
            named = tuple(c for x in items if isinstance(x, Noun) and x.amount is None for c in x.traits.colors)
            if len(named) == len(items) == many:
                yield named, end
    lead = p.any_of(i, (",", ":", ", namely"))
    for items, end in listed(p, lead) if lead else ():
        nouns = [x for x in items if isinstance(x, Noun) and x.head == "any" and x.det == "a" and not x.part_of]
        looks = [x.traits.colors for x in nouns if x.traits == Traits(colors=x.traits.colors[:1])]
        named = tuple(color for look in looks for color in look)
        if len(named) == len(items) == len(set(named)) == many:
            yield named, end


_EACHES = frozenset({"each", "every"})
