"""The blocks at some places of a structure: "each end block", "every block of the near row", "the corner of the L"; and
structures that are told where a block of them is named: "(the middle block) of a row of three"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.amounts import quantity
from rpg.language.later import later
from rpg.language.meaning import At, Noun, PartOf, Places, Structure, replace

if TYPE_CHECKING:
    from rpg.language.grammar.structures.parts import part
    from rpg.language.grammar.structures.structures import structure
    from rpg.language.grammar.things.nouns import simple
else:
    (part,) = later(__name__, "rpg.language.grammar.structures.parts", "part")
    (structure,) = later(__name__, "rpg.language.grammar.structures.structures", "structure")
    (simple,) = later(__name__, "rpg.language.grammar.things.nouns", "simple")

_BLOCKS = frozenset({"block", "blocks", "cube", "cubes", "brick", "bricks", "box", "boxes", "one", "ones"})
_PARTS = {"end": "ends", "corner": "corners"}
_CORNER = frozenset({"corner"})
_LINES = ("row", "line", "column")
_LINED = ("row", "column", "layer")
_DETS = frozenset({"each", "all", "both", "the", "its", "some", "any"})
_FORMING = Patterns("that|which? stand|lie|are|sit|standing|lying|sitting in",
                    "that|which form|make", "that|which make up", "forming|in")  # fmt: skip
"""What joins blocks and the structure that they form: "(the nearest of) three blocks that stand in a column"."""


@choice
def at_places(p: Parser, i: int) -> Results[Noun]:
    """So many of the blocks there, or all of them."""
    for found, j in quantity(p, i):
        if found.det not in _DETS:
            continue
        for part_of, end in _there(p, i, j, found.partitive):
            det, amount = found.det, found.amount
            if found.det in ("the", "its"):
                several = isinstance(part_of.places, Places) and part_of.places.several
                det, amount = "all" if several else "the", None
            yield Noun(head="any", det=det, amount=amount, plural=True, part_of=part_of, span=p.span(i, end)), end
    for place, j in part(p, i) if p.stands(i, ("the",)) else ():
        of = p.one(j, ("of", "in")) if isinstance(place, At) and place.own else 0
        for whole, end in (*brought_up(p, of), *_described(p, of)) if of else ():
            there = PartOf(part="blocks", whole=whole, places=place, span=p.span(i, end))
            yield Noun(head="any", det="the", part_of=there, span=there.span), end


def _there(p: Parser, i: int, j: int, partitive: bool) -> Results[PartOf]:
    """ "(each of) the end blocks of the row", "(each of) three blocks in a row"."""
    for places, k in _places(p, p.one(j, ("the", "its", "all")) or j if partitive else j):
        for whole, end in (*_owner(p, k), *(((None, k),) if places is not None else ())):
            yield PartOf(part="blocks", whole=whole, places=places, span=p.span(i, end)), end
    for whole, end in brought_up(p, j) if partitive and p.number(j) is not None else ():
        yield PartOf(part="blocks", whole=whole, span=p.span(i, end)), end


def _owner(p: Parser, i: int) -> Results[Structure | None]:
    """ "of the row", "of a row of three"; None for the one that was spoken of."""
    of = p.one(i, ("of", "in"))
    if end := p.one(of, "it") if of else 0:
        yield None, end
    for whole, end in structure(p, of) if of else ():
        if isinstance(whole, Structure) and whole.det == "the" and not whole.plural:
            yield whole, end
    yield from brought_up(p, of) if of else ()


def _described(p: Parser, i: int) -> Results[Structure]:
    """ "the row of three blue blocks": one that was spoken of, or is there."""
    for whole, j in structure(p, i):
        the_one = isinstance(whole, Structure) and whole.det == "the" and not whole.plural
        if the_one and isinstance(whole, Structure) and whole.kind in _LINES and (whole.members or whole.sizes):
            yield whole, j


@choice
def brought_up(p: Parser, i: int) -> Results[Structure]:
    """A structure that is told here for the first time: "a row of three", "three blocks that stand in a row"."""
    for whole, j in structure(p, i):
        if isinstance(whole, Structure) and _new(whole) and (whole.members or whole.sizes or whole.dims):
            yield whole, j
    if p.number(i) is None:
        return
    for blocks, j in simple(p, i):
        counted = isinstance(blocks, Noun) and blocks.det == "bare" and blocks.amount is not None
        if not counted or not isinstance(blocks, Noun) or blocks.head == "patch" or blocks.part_of is not None:
            continue
        for k in _FORMING.matches(p, j) if not blocks.conditions else ():
            for whole, end in structure(p, k):
                if isinstance(whole, Structure) and _new(whole) and whole.members is None:
                    yield replace(whole, members=blocks, span=p.span(i, end)), end


def _new(whole: Structure) -> bool:
    return whole.det in ("a", "bare") and not whole.plural


def _places(p: Parser, i: int) -> Results[Places | None]:
    """Which places; None for all of them."""
    many = p.number(i)
    j = i + 1 if many is not None else i
    if (side := p.peek(j, _PARTS)) is not None:
        k = p.one(j + 1, _BLOCKS)
        if k or side == "corners":
            span = p.span(i, k or j + 1)
            yield Places(side=side, unit="block", several=many, span=span), p.reach(k or j + 1)
    elif p.words[j] == "corners":
        yield Places(side="corners", unit="block", several=many, span=p.span(i, j + 1)), p.reach(j + 1)
    for cell, k in part(p, i) if p.anywhere(_CORNER) else ():
        if isinstance(cell, Places) and cell.unit == "cell":
            yield cell, p.one(k, _BLOCKS) or k
    if not (k := p.one(j, _BLOCKS)):
        return
    yield None, k
    for place, end in part(p, of) if (of := p.one(k, ("of", "in", "from"))) else ():
        if isinstance(place, Places) and place.unit in _LINED:
            yield place, end
