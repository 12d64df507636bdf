"""Orders by letters, numbers or sizes, put together from their parts: "reverse alphabetical order", "biggest left"."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.sides import OPPOSITE, SIDES, TOWERS
from rpg.language.grammar.structures.neighbours import by_neighbours
from rpg.language.grammar.structures.rising import rising, whither
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.labels import run, span_of, symbol
from rpg.language.meaning import Meaning, Noun, OrderBy, Traits, replace

_IN = "in|into|by|with|following|to? the|a|an|strict|strictly|proper|correct|normal|usual?"
_ABC = "alphabetical|alphabetic|alphabet|abc|a_to_z"
_ORDER = "order|sequence|ordering|arrangement"
_REVERSED = "reverse|reversed|backward|backwards|inverse|inverted|descending|opposite"
_ALPHABETICAL = Patterns(
    f"{_IN} ascending|forward? {_ABC} {_ORDER}", "by|according_to|following|along the? alphabet",
    "from a to z", "sorted|ordered by|from a to z",
)  # fmt: skip
_BACKWARDS = Patterns(
    f"{_IN} {_REVERSED} {_ABC} {_ORDER}", f"{_REVERSED} alphabet|abc", "the? alphabet backwards|backward|reversed",
    "from z to a", "alphabetically backwards|backward|reversed|in_reverse",
    f"{_IN} {_ABC} {_ORDER} backwards|backward|reversed|but_backwards|but_reversed|from_z_to_a",
)  # fmt: skip
_NUMERICAL = Patterns("in|by|following? the|correct? numerical|numeric|number order|sequence")
_NUMBERS_GO = "with|so_that|such_that|so|where|while? the|their numbers|digits|values|numerals are|is? strictly?"
_INCREASING = Patterns(
    f"{_NUMBERS_GO} going|go|goes|getting|get|run|running up|upward|upwards|bigger|larger|higher",
    f"{_NUMBERS_GO} increasing|increase|rising|rise|ascending|ascend|growing|grow|climbing|climb",
)
_DECREASING = Patterns(
    f"{_NUMBERS_GO} going|go|goes|getting|get|run|running down|downward|downwards|smaller|lower",
    f"{_NUMBERS_GO} decreasing|decrease|falling|fall|descending|descend|shrinking|shrink|dropping|drop",
)
_THEY_GO = (
    "so_that|such_that|so|where|while? they|the_cubes|the_blocks|the_edges? "
    "get|getting|become|becoming|grow|growing|go|going|are_getting"
)
_SIZES_GO = "with|so_that|such_that|so|where the|their|its size|sizes strictly?"
_RISING = "rising|growing|ascending|increasing|upward"
_FALLING = "falling|shrinking|descending|decreasing|downward"
_BY_SIZE = "sorted|ordered|arranged? by|according_to|in_order_of the|their? size|sizes"
_UP = Patterns(
    f"{_THEY_GO} bigger|larger|taller|greater",
    "so_that|such_that|so|where they|the_cubes|the_blocks strictly? increase|rise|grow|ascend in_size|in_value?",
    f"{_SIZES_GO} increasing|increases|increase|growing|grows|grow|rising|rises|rise",
    "and? then|from_there|from_there_on only? ascending|increasing|rising|going_up|growing|upwards|up",
    f"{_IN} {_RISING} number|numeric|numerical|size? {_ORDER}",
    f"{_IN} {_RISING} {_ORDER} of|by|in the|their? size|sizes",
    f"{_IN} {_ORDER} of? {_RISING} size|sizes",
    f"{_BY_SIZE} ,? in? a|an? {_RISING} {_ORDER}",
    f"{_BY_SIZE} ,? {_RISING}",
)
_DOWN = Patterns(
    f"{_THEY_GO} smaller",
    "so_that|such_that|so|where they|the_cubes|the_blocks strictly? decrease|shrink|descend in_size|in_value?",
    f"{_SIZES_GO} decreasing|decreases|decrease|shrinking|shrinks|shrink|falling|falls|fall",
    "and? then|from_there|from_there_on only? descending|decreasing|falling|going_down|shrinking|downwards|down",
    f"{_IN} {_FALLING} number|numeric|numerical|size? {_ORDER}",
    f"{_IN} {_FALLING} {_ORDER} of|by|in the|their? size|sizes",
    f"{_IN} {_ORDER} of? {_FALLING} size|sizes",
    f"{_BY_SIZE} ,? in? a|an? {_FALLING} {_ORDER}",
    f"{_BY_SIZE} ,? {_FALLING}",
)
_PAGED = Patterns(
    "reading|read|going|running|always|ordered|so_that_they_read? from? the? left to the? right "
    "and|,|and_then|,_and|,_then from? the? top|far|back to the? bottom|near|front side|row?",
    "so|so_that you|i|we|one can? read|reads them|it in_order",
    "so|so_that you|i|we|one can? read|reads them|it in_order? like|as a_page|on_a_page|a_book|in_a_book",
    "like a page|book of_a_book?",
    "row by|after row from? left_to_right?",
    "as|like on a page",
    ",? the_way|just_as|as you|we|one|i read|reads a|the page|book|text",
)
"""As a page is read: the far row first, each from left to right."""
_READING = frozenset({"left", "read", "page", "row", "book"})
"""Words without one of which nothing is read as a page is."""
_NAMES = (
    ("label", False, _ALPHABETICAL), ("label", True, _BACKWARDS), ("number", False, _INCREASING),
    ("number", False, _NUMERICAL),
    ("number", True, _DECREASING), ("ascending", False, _UP), ("ascending", True, _DOWN),
)  # fmt: skip
_SIZES = frozenset({"bigger", "larger", "taller", "greater", "smaller", "size", "sizes"})
"""What blocks that show no numbers differ in."""
_TELLING = frozenset(
    f"{_ABC} z alphabetically numerical numeric number size numbers digits values numerals ascending increasing rising "
    "growing upwards upward up descending decreasing falling shrinking downwards downward down bigger larger taller "
    "greater smaller increase rise grow ascend decrease shrink descend sizes".replace("|", " ").split()
)
"""Words without one of which none of these orders is told."""
_EXTREMES = {
    **dict.fromkeys(("smallest", "lowest", "least", "littlest"), False),
    **dict.fromkeys(("biggest", "largest", "highest", "greatest"), True),
}
_SIDES_TOO = frozenset({"highest", "lowest"})
"""By themselves these are places in a tower."""
_AN_END = frozenset({"first", "last"})
_NUMBERS = frozenset({"number", "digit", "numeral", "value", "numbers", "digits"})
_THINGS = ("block", "cube", "one", "brick", "box")
_IS = ("is", "being", "goes", "comes", "should be", "must be", "to be", "stands", "sits", "should come", "should go")
_WHERE = ("with", "where", "and", "so", "so that", "such that")
_AT = ("on the", "at the", "to the", "on", "at", "at the far", "at the very", "on the far", "at the extreme", "in the")
_HERE = frozenset({"left", "right", "bottom", "top", "front", "back", "leftmost", "rightmost"})
_COUNTING = {
    **dict.fromkeys(("count down", "counting down", "counts down", "a countdown", "the countdown", "countdown"), True),
    **dict.fromkeys(("count up", "counting up", "counts up", "count", "counting"), False),
}
_GOING = {
    **dict.fromkeys(("going up", "rising", "increasing", "ascending", "growing", "climbing", "that goes up",
                     "which goes up", "goes up", "that rises"), False),
    **dict.fromkeys(("going down", "falling", "decreasing", "descending", "that goes down", "which goes down",
                     "goes down"), True),
}  # fmt: skip
"""What numbers do along a line; down a tower they do it from its top."""
_NUMERALS = frozenset({"digits", "numbers", "numerals", "number", "digit"})


@rule
def ascent(p: Parser, i: int) -> Results[Meaning]:
    """An order of letters, numbers or sizes."""
    if p.anywhere(_READING):
        yield from ((OrderBy(by="paged", span=p.span(i, j)), j) for j in _PAGED.matches(p, i))
    for by, descending, names in _NAMES if p.anywhere(_TELLING) else ():
        for j in names.matches(p, i):
            order = OrderBy(by=by, descending=descending, span=p.span(i, j))
            ways = [] if by == "label" or p.words[j - 1] == "order" else [*whither(p, j)]
            sized = by == "ascending" and not _SIZES.isdisjoint(p.words[i:j])
            if sized and (ways or p.words[j] == "from" or p.all.isdisjoint(TOWERS)):  # which way a tower grows is open
                order = replace(order, attribute="size")
            yield from ((replace(order, first=first, span=p.span(i, end)), end) for first, end in ways)
            yield from () if ways else ((order, j),)
    yield from rising(p, i)
    yield from by_neighbours(p, i)
    yield from _extreme(p, i)


def _extreme(p: Parser, i: int) -> Results[Meaning]:
    """ "(with the) biggest number (on the) left": sorted, and from which side on."""
    j = p.opt(p.any_of(p.opt(i, ",", ":"), _WHERE) or p.opt(i, ",", ":"), "the")
    down = p.lex(j, _EXTREMES)
    if down is None:
        return
    number = p.one(j + 1, _NUMBERS)
    named = number or p.opt(j + 1, *_THINGS)
    k = p.any_of(named, _IS) or named
    if (end := p.one(k, _AN_END)) and (p.words[j] not in _SIDES_TOO or named > j + 1 or _numbers(p)):
        told = OrderBy(by="number" if number else "extreme", values=("end",), span=p.span(i, end))
        yield replace(told, descending=down == (p.words[k] == "first")), end
    side = p.any_of(k, _AT) or k
    word = p.words[side] if side < p.end else ""
    if word not in _HERE:
        return
    end = p.opt(p.reach(side + 1), "end", "side")
    if p.words[end] == "of":
        return
    by = "number" if number else "extreme"
    yield OrderBy(by=by, first=SIDES[word], descending=down, span=p.span(i, end)), end


def _numbers(p: Parser) -> bool:
    """Whether numbers are spoken of, of which one may be the highest."""
    return any(token.kind == "number" for token in p.tokens)


_ENDS = {"at the": ("bottom", "top", "left", "right"), "on the": ("left", "right"), "on": ("top",), "at": ("top",)}


@rule
def counted(p: Parser, i: int) -> Results[OrderBy]:
    """ "count down from 5 to 1", "(counting) from 3 at the bottom to 1 at the top": those symbols, in that order."""
    for phrase, j in p.standing(i, _COUNTING):
        for labels, k in run(p, p.opt(j, "from")):
            if labels[0].isdigit() and (labels[0] > labels[-1]) == _COUNTING[phrase] and not measures(p, k):
                yield OrderBy(by="run", items=_items(p, j, k, labels), span=p.span(i, k)), k
        yield from _between_ends(p, i, p.one(j, "from"))
    for phrase, j in p.standing(i, _GOING):
        if p.all.isdisjoint(_NUMERALS) or (_GOING[phrase] and not p.all.isdisjoint(TOWERS)):
            continue
        for labels, k in run(p, p.one(j, "from")) if p.stands(j, ("from",)) else ():
            if labels[0].isdigit() and (labels[0] > labels[-1]) == _GOING[phrase] and not measures(p, k):
                yield OrderBy(by="run", items=_items(p, j, k, labels), span=p.span(i, k)), k
    yield from _between_ends(p, i, p.one(i, "from"))


def measures(p: Parser, i: int) -> bool:
    """Whether a unit of length stands here; "in" is none where an article follows."""
    return p.lex(i, lexicon.UNIT) is not None and not (p.words[i] == "in" and p.words[i + 1] in ("a", "one", "the"))


def _between_ends(p: Parser, i: int, j: int) -> Results[OrderBy]:
    """Behind "from": "3 at the bottom to 1 at the top"."""
    first = symbol(p, j) if j else None
    begin, k = _end(p, j + 1) if first is not None else ("", 0)
    to = p.one(k, "to") if k else 0
    last = symbol(p, to) if to else None
    labels = span_of(first, last) if first is not None and last is not None else ()
    other, end = _end(p, to + 1) if labels else ("", 0)
    if end and other == OPPOSITE[begin]:
        yield OrderBy(by="run", items=_items(p, j, end, labels), first=begin, span=p.span(i, end)), end


def _end(p: Parser, i: int) -> tuple[str, int]:
    """ "at the bottom": a side, and the position after it."""
    for lead, sides in _ENDS.items():
        j = p.seq(i, lead)
        if j and p.words[j] in sides:
            return p.words[j], p.opt(p.reach(j + 1), "end", "side")
    return "", 0


def _items(p: Parser, j: int, k: int, labels: tuple[str, ...]) -> tuple[Noun, ...]:
    return tuple(Noun(head="any", traits=Traits(labels=(x,)), span=p.span(j, k)) for x in labels)
