"""Orders, directions, patterns, spacing: how the members of a structure are laid out."""

from __future__ import annotations

import string
from typing import TYPE_CHECKING

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.places.sides import TOWERS, toward
from rpg.language.grammar.places.slopes import slope
from rpg.language.grammar.structures.alternation import alternation, what_alternates
from rpg.language.grammar.structures.ascents import ascent, counted
from rpg.language.grammar.structures.gradients import from_to
from rpg.language.grammar.structures.kinds_first import kinds_first
from rpg.language.grammar.structures.order_phrases import NAMED
from rpg.language.grammar.structures.parted import parted
from rpg.language.grammar.structures.patterns import pattern, spacing
from rpg.language.grammar.structures.reading import read_out
from rpg.language.grammar.structures.rising import whither
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.amounts import makes_number
from rpg.language.grammar.things.classes import classes
from rpg.language.grammar.things.labels import run
from rpg.language.grammar.things.lists import listed, ranks
from rpg.language.later import later
from rpg.language.meaning import Meaning, Noun, OrderBy, Toward, Traits

if TYPE_CHECKING:
    from rpg.language.grammar.things.nouns import simple
else:
    (simple,) = later(__name__, "rpg.language.grammar.things.nouns", "simple")

_LEADS = frozenset(
    {
        "both",
        "each",
        "all",
        "reading",
        "read",
        "readable",
        "legible",
        "sorted",
        "ordered",
        "arranged",
        "lined",
        "organized",
        "organised",
        "going",
        "running",
        "placed",
        "runs",
        "run",
        "stretching",
        "extending",
        "leading",
    }
)

_WHICH_ARE = ("which is", "that is", "which are", "that are", "and is", "which should be", "that should be",
              "which has to be", "which must be", "that must be")  # fmt: skip
_ARRANGED = frozenset({"sorted", "ordered", "arranged", "organized"})
_EXACTLY = ("strictly", "exactly", "precisely", ", strictly", ", exactly", ", precisely")
READABLE = (
    "so that they can be read in",
    "so they can be read in",
    "so that it can be read in",
    "so that you can read them in",
)
"""What an order follows, and no statement of its own."""
_READABLE = (
    "row by row", "so that they can be read", "so they can be read", "so that it can be read", "to be read",
    "so that you can read them",
    *(f"{so} {they} {run}" for so in ("so that", "such that", "so")
      for they in ("they", "the letters", "the cubes", "the blocks", "the numbers", "the digits", "the colors")
      for run in ("are", "read", "stand", "run", "go", "come", "appear", "follow", "are lined up", "are arranged")),
)  # fmt: skip
_NAMED = {
    said: (by, extra.get("descending", False))
    for phrase, by, extra in NAMED
    for said in (phrase, *([f"into {phrase[3:]}"] if phrase.startswith("in ") else ()))
}
"""The named orders; what is said with "in" is said with "into" as well."""


_SIZES = frozenset({"smallest", "largest", "biggest", "small", "large", "big"})
_NUMBERS = frozenset({"number", "numbers", "digit", "digits", "numeral", "value"})
"""Behind "from smallest to largest" these say that it is not of the size of the blocks."""


def _sort(p: Parser, by: str, i: int, j: int) -> str:
    """What blocks that show nothing are told apart by, where they go "from smallest to largest"."""
    sized = by == "ascending" and not _SIZES.isdisjoint(p.words[i:j])
    return "size" if sized and _NUMBERS.isdisjoint(p.words[i : j + 1]) else "color"


@rule
def order(p: Parser, i: int) -> Results[Meaning]:
    """An order, a direction, a pattern, a spacing."""
    if (exact := p.any_of(i, _EXACTLY)) and p.stands(exact, ("in",)):
        yield from ((found, k) for found, k in order(p, exact) if isinstance(found, OrderBy) and found.by == "given")
    which = p.any_of(i, _WHICH_ARE)
    j = (p.one(which, _ARRANGED) if which else p.one(i, _LEADS)) or p.any_of(i, _READABLE) or i
    for start in {i: None, j: None}:
        for phrase, k in p.standing(start, _NAMED):
            by, descending = _NAMED[phrase]
            paged = p.any_of(k, (", row by row", "row by row", ", row after row", "row after row"))
            for ends, end in from_to(p, k) if by == "rainbow" else ():
                yield OrderBy(by=by, values=ends, span=p.span(i, end)), end
            for end in dict.fromkeys((paged or k, k)):
                sort = _sort(p, by, start, k)
                told = what_alternates(by, p.words[start:k]) or _which_end(p, start, k)
                yield OrderBy(by=by, values=told, span=p.span(i, end), descending=descending, attribute=sort), end
        if (
            start > i and p.words[i] == "sorted"
        ):  # "sorted from left to right": by what they show, not as they are listed
            yield from ((_sorted_from(p, i, k, x), k) for x, k in toward(p, start) if isinstance(x, Toward))
        else:
            yield from toward(p, start)
        yield from _explicit(p, start)
        yield from _run(p, start)
        yield from ascent(p, start)
        yield from counted(p, start)
        yield from _grown(p, start)
        yield from _by_attribute(p, start, j > i)
        yield from temporal(p, start)
        yield from _toward_list(p, start)
    yield from slope(p, i)
    yield from pattern(p, i)
    yield from spacing(p, i)
    yield from alternation(p, i)
    yield from read_out(p, i)
    yield from kinds_first(p, i)


_HEIGHTS = frozenset({"lowest", "highest", "low", "high"})


def _which_end(p: Parser, i: int, j: int) -> tuple[str, ...]:
    """ "From lowest to highest": of numbers in a tower it may be that of the values, or of the places."""
    high = not _HEIGHTS.isdisjoint(p.words[i:j]) and not p.all.isdisjoint(TOWERS)
    return ("end",) if high else ()


def _sorted_from(p: Parser, i: int, k: int, way: Toward) -> OrderBy:
    return OrderBy(by="ascending", first=way.first, span=p.span(i, k))


@rule
def temporal(p: Parser, i: int) -> Results[Meaning]:
    """ "in exact temporal order (blue first, then red)"."""
    j = p.any_of(
        i,
        (
            "in exact temporal order",
            "in temporal order",
            "in the temporal order",
            "in strict temporal order",
            "in the order",
            "one after the other",
            "in time order",
            "in this order",
        ),
    )
    if not j:
        return
    opened = p.one(p.opt(j, ",", ":"), ("(", "["))
    k = opened or p.opt(j, ",", ":")
    k = p.opt(k, "first")
    for items, end in firsts(p, k):
        close = p.one(end, (")", "]")) if opened else end
        if close:
            yield OrderBy(by="temporal", items=items, span=p.span(i, close)), close


@rule
def firsts(p: Parser, i: int) -> Results[tuple[Meaning, ...]]:
    """ "blue first, then red": an explicit order in time."""
    for first, j in simple(p, i):
        j = p.opt(j, "first")
        for rest, k in _after_first(p, j):
            yield (first, *rest), k


def _after_first(p: Parser, at: int) -> Results[tuple[Meaning, ...]]:
    j = p.opt(at, ",")
    j = p.any_of(j, ("and then", "then", "and finally", "finally", "and", "followed by"))
    if not j:
        return
    for item, k in simple(p, j):
        k = p.opt(k, "second", "last", "third", "afterwards", "after that")
        yield (item,), k
        for rest, end in _after_first(p, k):
            yield (item, *rest), end


@choice
def _explicit(p: Parser, i: int) -> Results[Meaning]:
    """ "in the order red, yellow, green", "in this order: A, B, C", "red first, then blue"."""
    j = p.any_of(i, ("in the following order", "in the order of", "in the order", "in order", "in this order",
        "in the sequence", "in color order",
                     "following the order", "with the order", "with order", "with the color order",
                     "in the color order", "order",
                     "in that order", "ordered as", "ordered", "in the pattern", "as", "like this", "as follows",
                     "that goes", "that go", "which goes", "in order from", "going",
                     "so they are", "so that they are", "so it goes", "in a sequence of",
                     "in the sequence of"))  # fmt: skip
    if not j:
        return
    for way, k in toward(p, p.opt(j, ",", "(")):
        k = p.opt(p.opt(k, ")"), ":", ",")
        if isinstance(way, Toward) and way.first and p.words[k - 1] in (":", ","):
            for items, end in listed(p, k):
                yield OrderBy(by="given", items=items, first=way.first, span=p.span(i, end)), end
    j = p.opt(j, ":", ",", "of")
    j = p.opt(j, "first") if p.words[j : j + 1] == ["first"] else j
    j = p.opt(j, "from") if p.words[j : j + 1] == ["from"] and j + 1 < p.end and p.words[j + 1] in lexicon.COLOR else j
    yield from ((OrderBy(by="given", items=items, span=p.span(i, k)), k) for items, k in listed(p, j))
    yield from ((OrderBy(by="given", items=items, span=p.span(i, k)), k) for items, k in ranks(p, j))


_FROM_TO = ("smallest", "to", "largest")
_GROWING = Patterns(
    "smallest to largest|biggest",
    "from the? smallest|lowest|least|small|low number|digit|one|block|cube? up? to the? "
    "largest|highest|biggest|greatest|large|big|high number|numbers|digit|digits|one|block|cube?",
    "so_that|so|such_that the|it|they tower|row|stack|line|column|numbers|digits|blocks|cubes? "
    "count|counts|go|goes|run|runs|increase|increases up|upward|upwards?",
    "counting|increasing up|upward|upwards",
)
_SHRINKING = Patterns(
    "largest|biggest to smallest",
    "from the? largest|highest|biggest|greatest|large|big|high number|digit|one|block|cube? down? to the? "
    "smallest|lowest|least|small|low number|numbers|digit|digits|one|block|cube?",
    "so_that|so|such_that the|it|they tower|row|stack|line|column|numbers|digits|blocks|cubes? "
    "count|counts|go|goes|run|runs|decrease|decreases down|downward|downwards?",
    "counting|decreasing down|downward|downwards",
)
"""Numbers, or sizes, that grow or shrink along a line; what counts up a tower begins at its bottom."""


@choice
def _grown(p: Parser, i: int) -> Results[Meaning]:
    for patterns, descending in ((_GROWING, False), (_SHRINKING, True)):
        for j in patterns.matches(p, i):
            counted = p.words[j - 1].startswith(("up", "down"))
            if counted and p.stands(j, ("from",)) and p.tokens[j + 1 : j + 2] and p.tokens[j + 1].kind == "number":
                continue  # "counting down from 5 to 1" tells them all
            if counted and any(whither(p, j)):
                continue  # "the numbers go up to the right": no tower, and no half of the table
            number = counted or p.words[j - 1] in ("number", "numbers", "digit", "digits")
            by = "number" if number else "ascending"
            if counted and descending:
                yield OrderBy(by="countdown", descending=True, span=p.span(i, j)), j
            elif counted:
                yield OrderBy(by="count_up", span=p.span(i, j)), j
            elif p.words[i] == "from" or (p.words[i] in _SIZES and j == i + len(_FROM_TO)):
                sort = _sort(p, by, i, j)
                told = _which_end(p, i, j)
                yield OrderBy(by=by, values=told, descending=descending, attribute=sort, span=p.span(i, j)), j


@choice
def _run(p: Parser, i: int) -> Results[Meaning]:
    """ "from 1 to 5", "from E down to A": those symbols, in that order."""
    j = p.one(i, "from")
    for labels, k in run(p, j) if j else ():
        if labels[-1].isalpha() and len(labels) == len(string.ascii_uppercase):
            continue
        if labels[-1].isalpha() or not makes_number(p, k):
            items = tuple(Noun(head="any", traits=Traits(labels=(x,)), span=p.span(j, k)) for x in labels)
            cost = 1 if p.follows(i, _NAMING) and p.any_of(k, _SORTED) else 0
            yield OrderBy(by="run", items=items, span=p.span(i, k), cost=cost), k


_NAMING = frozenset({"digits", "numbers", "letters", "numerals", "symbols"})
_SORTED = ("in order", "in reading order", "in sequence", "in the right order")
"""Between these "from 1 to 5" tells which ones are meant, and their order is told after it."""


_ATTRIBUTES = {
    "color": "color", "colour": "color", "colors": "color", "letter": "label", "label": "label", "number": "label",
    "kind": "kind",
    "type": "kind", "size": "size", "symbol": "label", "letters": "label", "parity": "parity", "value": "label",
    "shade": "color", "category": "kind",
}  # fmt: skip


_COLORS_ARE = ("whose colors are", "that are", "which are", "with colors that are", "whose colors should be")
_COLORS = ("whose colors", "so that the colors", "with the colors", "with colors", "so that", "where the colors",
           "such that", "in which the colors", "where", "so")  # fmt: skip
_THEY_ARE = ("they are", "are", "it is", "they read", "is", "read", "it reads", "the blocks are", "the colors are")


@rule
def _toward_list(p: Parser, i: int) -> Results[Meaning]:
    """ "whose colors from top to bottom are red, white and black", "so that from left to right they are ...", "that
    are, from top to bottom, red, white and black"."""
    are = p.any_of(i, _COLORS_ARE)
    j = are or p.any_of(i, _COLORS) or i
    start = p.opt(j, ",") if j > i else j
    for found, k in toward(p, start) if start < p.end else ():
        if not isinstance(found, Toward) or not found.first:
            continue
        k = p.opt(k, "order")
        comma = p.opt(k, ",") if j > i else k
        end = comma if are else p.any_of(comma, _THEY_ARE) or (p.one(k, ":") if j == i else 0)
        if not end and j == i and i and p.words[i - 1] in (",", ":"):
            end = k
        for items, last in listed(p, p.opt(end, ":")) if end else ():
            yield OrderBy(by="given", items=items, first=found.first, span=p.span(i, last)), last


_SHOWN = Patterns(
    "by|according_to|based_on what is printed|written|shown|painted|marked? on|upon them|it|each|top|each_of_them|"
    "each_one|each_block|each_cube|the_blocks|the_cubes",
    "by|according_to|based_on what they|each_one|each_of_them|each_block|each_cube show|shows|say|says|display",
    "by|according_to|based_on the|their symbol|letter|number|label|digit|glyph on_them|on_it|they_show|they_have|"
    "they_display|they_bear|printed_on_them|shown_on_them|written_on_them|on_each|that_they_show",
)
"""What tells blocks apart by their symbols."""


@choice
def _by_attribute(p: Parser, i: int, led: bool) -> Results[Meaning]:
    """ "by colour", "according to size", "by even and odd", "into vowels and consonants"."""
    yield from classes(p, i)
    yield from parted(p, i)
    j = p.any_of(i, ("by", "according to", "based on", "by their", "according to their", "by the", "depending on",
        "by whether they are", "according to whether they are", "on the basis of", "based on their",
                     "by same", "by different", "by block"))  # fmt: skip
    for k in _SHOWN.matches(p, i):
        yield OrderBy(by="attribute", attribute="label", span=p.span(i, k)), k
    if j:
        word = p.words[j] if j < p.end else ""
        further = word == "size" and any(k > j + 1 for _, k in ascent(p, i))  # "by size in descending order"
        if word in _ATTRIBUTES and not further:
            k = p.reach(j + 1)
            k = p.opt(k, "of")
            yield OrderBy(by="attribute", attribute=_ATTRIBUTES[word], span=p.span(i, k)), k
        for phrase, attribute in (("even and odd", "parity"), ("odd and even", "parity"),
            ("whether they are even or odd", "parity"), ("even or odd", "parity"),
                                  ("vowel and consonant", "vowel"), ("vowels and consonants", "vowel"),
                                  ("whether they are vowels or consonants", "vowel"),
                                  ("vowel or consonant", "vowel"), ("odd or even", "parity")):  # fmt: skip
            if k := p.seq(j, phrase):
                yield OrderBy(by="attribute", attribute=attribute, span=p.span(i, k)), k
