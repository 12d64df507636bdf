"""Several structures that are all the same: "two identical towers: red, blue, green", "the same tower twice", "three
copies of the tower red, blue"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.core.diagnostics import Span
from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.places.sides import toward
from rpg.language.grammar.structures.each import items_of, made_of
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.lists import listed
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Amount, Coord, Meaning, Noun, OrderBy, Structure, Toward
from rpg.language.tokens import Token

_MARKED = frozenset(
    {"like", "looks", "copy", "again", "identical", "same", "alike", "copies", "twice", "thrice", "times"}
)
_SEVERAL = {"towers": "stack", "stacks": "stack", "rows": "row", "lines": "row", "columns": "column"}
_ONE = {"tower": "stack", "stack": "stack", "row": "row", "line": "row", "column": "column"}
_IDENTICAL = ("identical", "exactly identical", "completely identical", "exactly the same", "same", "identical looking",
              "same looking", "alike")  # fmt: skip
_LOOKING = (
    *(f"{that} {same}" for that in ("that", "which", ", that both", "that both", ", both", "they")
      for same in ("look the same", "look alike", "are the same", "are identical", "look exactly the same",
                   "are exactly the same", "look identical", "identical", "the same")),
    "looking the same", "exactly alike", "alike", ", identical", ", exactly the same",
)  # fmt: skip
_COPIES = ("copies of", "identical copies of", "exact copies of", "times", "of the same", "copies")
_SAME = ("the same", "the exact same", "exactly the same", "one and the same", "the very same", "the identical",
         "this", "a", "the", "this same")  # fmt: skip
_LISTING = (":", ",", ", each", ": each", "each", "both", ", both", ", namely", ", from bottom to top :")
_OF = ("of", "with", "each of", ", each of", "each with", ", each with", "made of", ", both of", "both of",
       ", each made of", "consisting of")  # fmt: skip
_FROM = ("from", "out of", "using", "made from", "made out of", "built from")
_MADE = (*_OF, *_FROM)
_LIKE_FIRST = tuple(
    f"{like} {first}"
    for like in ("like", "just like", "exactly like", "that looks like", "that looks exactly like", "which looks like",
                 "identical to", "that is the same as", "that is identical to", "the same as", "looking like")
    for first in ("the first one", "the first", "the first tower", "the first row", "this one")
)  # fmt: skip
_AGAIN = tuple(
    f"and {again}"
    for again in (
        *(f"{another} {like}" for another in ("another one", "another", "a second one", "a second", "one more",
                                              "another tower", "a second tower", "another row", "a second row")
          for like in (*_LIKE_FIRST, "like it", "just like it", "exactly like it", "like that", "just like that",
                       "that looks the same",
                       "that is the same", "that is identical", "that looks like it", "which looks the same")),
        "the same tower again", "the same again", "the same row again", "a copy of it", "an exact copy of it",
        "an identical one", "an identical tower", "an identical row",
    )
)  # fmt: skip
_FIRST = {"stack": "bottom", "row": "left", "column": "front"}
_WAYS = {"stack": ("top", "bottom"), "row": ("left", "right"), "column": ("front", "back")}
ALIKE = "alike"
"""The order is that of none in particular, but of all the same one."""
LISTED = "listed"
"""The order is the one in which blocks are listed, though no side is said where it begins."""
SHARED = ("shared",)
"""What is told is there for all of them together."""


_BUILDS = frozenset({"build", "make", "create", "construct"})
_NEXT_TO = Patterns("directly|right? next_to|beside it|the_first|the_first_one|the_first_tower|that|that_one")


def in_one_sentence(parts: list[list[Token]]) -> list[list[Token]]:
    """ "Build a tower: red, blue. Build a second tower that looks like the first one (next to it).": two of them are
    built."""
    out: list[list[Token]] = []
    for part in parts:
        begin = next((n for n, token in enumerate(part) if token.word not in _POLITE), len(part))
        joint = [part[0].saying("and"), *part[begin + 1 :]]
        p = Parser(joint)
        end = p.any_of(0, _AGAIN) if begin < len(part) and part[begin].word in _BUILDS else 0
        beside = end and max(_NEXT_TO.matches(p, end), default=0) == p.end
        if out and out[-1][0].word in _BUILDS and end and (beside or end == p.end):
            other = [part[0].saying(word) for word in ("next", "to", "each", "other")]
            out[-1] = [*out[-1], *joint[:end], *(other if beside else ())]
        else:
            out.append(part)
    return out


_POLITE = frozenset({"then", "now", "please", "and", "next", ","})


@choice
def copies(p: Parser, i: int) -> Results[Structure]:
    """So many structures, each of which is told at once."""
    if not p.rarely(_MARKED):
        return
    for kind, many, j in (*_several(p, i), *_one_again(p, i)):
        for order, k in _told(p, j, kind):
            yield _alike(kind, many, order, p.span(i, k)), k
        yield _alike(kind, many, OrderBy(by="each", attribute=ALIKE, span=p.span(i, j), cost=2), p.span(i, j)), j
    noun = p.opt(i, "the", "a", "this")
    if (named := p.peek(noun, _ONE)) is not None:
        for order, j in _told(p, p.reach(noun + 1), named):
            if times := _times(p, p.opt(j, ",")):
                yield _alike(named, times[0], order, p.span(i, times[1])), times[1]
    for looks, j in listed(p, noun) if p.lex(noun, lexicon.COLOR) is not None else ():
        joined = p.lex(j, _ONE) if "," not in p.words[noun:j] else None
        if joined is not None and (times := _times(p, j + 1)) and (lot := _lot(looks, p.span(noun, j))):
            order = OrderBy(by="each", items=lot, first=_FIRST[joined], attribute=LISTED, span=p.span(noun, j))
            yield _alike(joined, times[0], order, p.span(i, times[1])), times[1]


def _alike(kind: str, many: int, order: OrderBy, span: Span) -> Structure:
    return Structure(kind=kind, det="bare", amount=Amount(many, many), plural=True, details=(order,), span=span)


def _several(p: Parser, i: int) -> Iterator[tuple[str, int, int]]:
    """ "two identical towers", "two towers that look the same", "two copies of the tower": of what kind, how many."""
    many = p.number(i)
    if many is None or many < 2:
        return
    alike = p.any_of(i + 1, _IDENTICAL)
    if alike and (kind := p.lex(alike, _SEVERAL)) is not None:
        yield kind, many, alike + 1
    elif (kind := p.peek(i + 1, _SEVERAL)) is not None and (j := p.any_of(p.reach(i + 2), _LOOKING)):
        yield kind, many, j
    elif j := p.any_of(i + 1, _COPIES):
        noun = p.any_of(j, _SAME) or j
        if (kind := p.lex(noun, _ONE)) is not None:
            yield kind, many, noun + 1


def _one_again(p: Parser, i: int) -> Iterator[tuple[str, int, int]]:
    """ "the same tower twice"."""
    noun = p.any_of(i, _SAME)
    kind = p.peek(noun, _ONE) if noun else None
    if kind is not None and (times := _times(p, p.reach(noun + 1))):
        yield kind, *times


def _times(p: Parser, i: int) -> tuple[int, int] | None:
    """ "twice", "three times", "and another one like it": how often, and the position behind it."""
    if j := p.any_of(i, _AGAIN):
        return 2, j
    if j := p.one(i, ("twice", "thrice")):
        return 2 + (p.words[i] == "thrice"), j
    many = p.number(i)
    return (many, p.reach(i + 2)) if many is not None and many > 1 and p.stands(i + 1, ("times",)) else None


def _told(p: Parser, i: int, kind: str) -> Results[OrderBy]:
    """Which blocks each of them has, in which order."""
    plain = p.any_of(i, _LISTING) or (i if not p.any_of(i, _MADE) else 0)
    for looks, j in listed(p, plain) if plain else ():
        if lot := _lot(looks, p.span(plain, j)):
            yield OrderBy(by="each", items=lot, first=_FIRST[kind], attribute=LISTED, span=p.span(i, j)), j
            yield from _along(p, i, j, lot, kind)
    for order, j in made_of(p, i, p.one(i, "with") or plain) if plain or p.stands(i, ("with",)) else ():
        if order.first and kind == "stack":
            yield order, j
    of = p.any_of(i, _OF)
    for blocks, j in noun_phrase(p, of or p.any_of(i, _FROM)) if of or p.any_of(i, _FROM) else ():
        if lot := items_of(blocks, p.span(i, j)):
            shared = () if of else SHARED
            yield OrderBy(by="each", items=lot, attribute=ALIKE, values=shared, span=p.span(i, j)), j
            yield from _along(p, i, j, lot, kind) if of else ()


def _along(p: Parser, i: int, j: int, lot: tuple[Noun, ...], kind: str) -> Results[OrderBy]:
    for way, k in toward(p, p.opt(j, ",")):
        if isinstance(way, Toward) and way.first in _WAYS[kind]:
            yield OrderBy(by="each", items=lot, first=way.first, span=p.span(i, k)), k


def _lot(looks: tuple[Meaning, ...], span: Span) -> tuple[Noun, ...]:
    return items_of(Coord(op="and", items=looks, span=span), span) if len(looks) > 1 else ()
