"""Blocks of several sizes: "three blue blocks with edges of 3, 4 and 5 cm"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.amounts import length
from rpg.language.grammar.things.nth_largest import NTH_LARGEST
from rpg.language.later import later
from rpg.language.meaning import Amount, Coord, Noun, Pronoun, Traits, replace

if TYPE_CHECKING:
    from rpg.language.grammar.things.adjectives import adjectives
    from rpg.language.grammar.things.nouns import simple
else:
    (adjectives,) = later(__name__, "rpg.language.grammar.things.adjectives", "adjectives")
    (simple,) = later(__name__, "rpg.language.grammar.things.nouns", "simple")

_LEADS = (
    "with edges of", "of", "with edges", "with sides of", "with edge lengths of", "of edge length", "of size",
    "of sizes", "measuring", "with sizes", "with sizes of", "of edge lengths", "in sizes", "in sizes of", "of edge",
    "of the sizes", "in the sizes", "with side lengths of", "with sides", "that are", "which are",
)  # fmt: skip


def of_edges(p: Parser, i: int, j: int, noun: Noun) -> Results[Coord | Noun]:
    """As many blocks as there are lengths, each with its own."""
    yield from _of_so_many(p, i, j, noun)
    if noun.plural and noun.traits.edge is None:
        yield from _of_any_edges(p, i, j, noun)
    k = p.any_of(j, _LEADS) if noun.plural and noun.head == "block" and noun.traits.edge is None else 0
    for edges, end in lengths(p, k) if k else ():
        many = noun.amount
        if many is None or many == Amount(len(edges), len(edges), many.strict):
            one = replace(noun, amount=Amount(1, 1), det="the" if noun.det == "the" else "bare", plural=False)
            items = tuple(replace(one, traits=replace(noun.traits, edge=edge), span=p.span(i, end)) for edge in edges)
            yield Coord(op="and", items=items, span=p.span(i, end)), end


_UTMOST = frozenset({"largest", "smallest"})
_RANKS = _UTMOST | {"larger", "smaller", *(rank for _, rank in NTH_LARGEST.values())}


def _of_so_many(p: Parser, i: int, j: int, noun: Noun) -> Results[Noun]:
    """ "the smaller of the two red blocks", "the two biggest of them": among those."""
    ranked = noun.det == "the" and noun.traits == Traits(rank=noun.traits.rank) and noun.part_of is None
    several = noun.plural and noun.amount is not None and noun.traits.rank in _UTMOST
    of = p.one(j, "of") if ranked and noun.traits.rank in _RANKS and (several or not noun.plural) else 0
    for whole, k in simple(p, of) if of else ():
        them = isinstance(whole, Pronoun) and whole.word in ("them", "these", "those")
        counted = isinstance(whole, Noun) and whole.plural and whole.amount is not None
        if them or (counted and isinstance(whole, Noun) and whole.det in ("the", "bare") and not whole.part_of):
            head = "patch" if isinstance(whole, Noun) and whole.head == "patch" else "block"
            yield replace(noun, head=head, part_of=whole, span=p.span(i, k)), k


_DIFFERENT = (
    "of different sizes", "in different sizes", "of different size", "with different sizes", "of increasing size",
    "of various sizes", "each of a different size", ", each of a different size", "of unequal size", "in various sizes",
    "of three sizes", "in three sizes", "of two sizes", "in two sizes", "with different edges",
)  # fmt: skip
_EDGES = {many: tuple(round(0.03 + 0.02 * n / (many - 1), 4) for n in range(many)) for many in range(2, 7)}
"""Sizes that are told apart, for so many blocks."""


def _of_any_edges(p: Parser, i: int, j: int, noun: Noun) -> Results[Coord]:
    """ "three cubes of different sizes": each of a size of its own."""
    k = p.any_of(j, _DIFFERENT) if noun.head == "block" and noun.amount is not None else 0
    edges = _EDGES.get(noun.amount.low, ()) if k and noun.amount is not None and noun.traits.size is None else ()
    said = {"two": 2, "three": 3}.get(p.words[k - 2], len(edges)) if k else 0
    if edges and said == len(edges) and noun.amount == Amount(len(edges), len(edges)):
        one = replace(noun, amount=Amount(1, 1), det="bare", plural=False)
        items = tuple(replace(one, traits=replace(noun.traits, edge=edge), span=p.span(i, k)) for edge in edges)
        yield Coord(op="and", items=items, span=p.span(i, k)), k


def lengths(p: Parser, i: int) -> Results[tuple[float, ...]]:
    """ "3, 4 and 5 cm", "3 cm, 4 cm and 5 cm": different lengths, the unit with each or with the last."""
    numbers: list[tuple[float, float | None]] = []
    at = i
    while (value := p.figure(at)) is not None:
        unit = p.lex(at + 1, lexicon.UNIT)
        numbers.append((value, unit))
        at += 2 if unit is not None else 1
        last = unit
        found = tuple(round(v * (u or last or 0), 6) for v, u in numbers)
        if len(numbers) > 1 and last is not None and len(set(found)) == len(found):
            yield found, at
        at = p.opt(p.opt(at, ","), "and", "&")


_ONE = frozenset({"a", "an", "one"})


@choice
def one_of_each_edge(p: Parser, i: int) -> Results[Coord]:
    """ "3, 5 and 6 cm red cubes", "a 3 cm, a 5 cm and a 6 cm red cube": what the noun says is said of each."""
    found = list(lengths(p, i)) if p.token(i) is not None and p.tokens[i].kind == "number" else []
    edges: list[float] = []
    at = i
    while (one := p.one(at, _ONE)) and (told := next(iter(length(p, one)), None)) is not None:
        edges.append(told[0])
        found += [(tuple(edges), told[1])] if len(set(edges)) == len(edges) > 1 else []
        at = p.opt(p.opt(told[1], ","), "and", "&")
    for each, j in found:
        for marks, k in adjectives(p, j):
            if marks.keys() <= {"colors"} and len(marks.get("colors", ())) < 2 and p.lex(k, lexicon.BLOCK) is not None:
                span = p.span(i, k + 1)
                traits = [Traits(**marks, edge=edge) for edge in each]
                items = tuple(Noun(head="block", amount=Amount(1, 1), traits=x, span=span) for x in traits)
                yield Coord(op="and", items=items, span=span), k + 1


USUAL = frozenset({"standard", "normal", "usual", "ordinary", "default", "regular"})
STANDARD = tuple(
    f"{of} {the}{usual} size"
    for of in ("of", "in", "with", "having")
    for the in ("", "the ", "a ", "its ")
    for usual in ("standard", "normal", "usual", "ordinary", "default", "regular")
)
"""What says of a block no more than is so anyway."""
_WIDE = ("wide", "long", "edge", "edges", "edge length", "side length", "on each side", "across", "in size", "on edge",
         "along the edge", "per side", "a side", "on a side", "in width", "along each edge")  # fmt: skip
_EDGE_IS = ("edge length", "edge", "side length", "size", "an edge of", "edge length of", "edge of", "edge :", "size :",
            "edge length :", "size of", "with an edge length of", "its edge is", "its edge")  # fmt: skip


def edge_told(p: Parser, i: int) -> Results[float]:
    """ ", 5 cm wide", ", edge length 5 cm,", "of 5 cm edge": the edge of one block, set off or not."""
    comma = p.opt(i, ",")
    lead = p.any_of(comma, _EDGE_IS) if comma > i else 0
    for metres, j in length(p, lead or comma) if lead or comma > i else ():
        end = j if lead else p.any_of(j, _WIDE)
        if end and p.words[end] not in ("apart", "away", "from", "to", "of"):
            for last in {end, p.opt(end, ",")}:
                yield metres, last


@choice
def each_long(p: Parser, i: int) -> Results[float]:
    """ "(three blocks,) 5 cm each", "each 5 cm wide": the edge of every one of them."""
    j = p.opt(i, ",")
    every = p.one(j, _EVERY)
    for metres, k in length(p, every or j):
        k = p.opt(k, "wide", "large", "long", "high", "tall", "cubes", "edge", "edges")
        end = k if every else p.any_of(k, ("each", "apiece"))
        if end and p.words[end] not in ("apart", "away", "from", "to", "of"):
            yield metres, end


_EVERY = frozenset({"each", "all", "both"})
