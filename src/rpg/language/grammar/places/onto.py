""" "Red on green on blue": blocks one on the other, from the top or from the bottom."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Amount, Clause, Meaning, Noun, OrderBy, Structure, Traits, replace

_OVER = (
    "on top of",
    "on",
    "over",
    "above",
    "atop",
    "upon",
    "sitting on",
    "stacked on",
    "resting on",
    "standing on",
    "sits on",
    "is on",
    "stands on",
    "lies on",
    "rests on",
    "lying on",
    "goes on",
    "is on top of",
    "sits on top of",
    "goes on top of",
    "is above",
    *(f"{be}{held} by" for be in ("is ", "") for held in ("carried", "supported", "borne", "held up")),
)
_UNDER = (
    "under", "below", "beneath", "underneath", "is under", "is below", "is beneath", "sits under",
    *(f"is {topped} {by}" for topped in ("topped", "covered", "crowned") for by in ("by", "with")),
)  # fmt: skip


@rule
def one_on_another(p: Parser, i: int) -> Results[OrderBy]:
    """A list of single blocks, each on the next one, or each under it."""
    for words, first in ((_OVER, "top"), (_UNDER, "bottom")):
        for items, j in _more(p, i, words):
            if len(items) > 1:
                joined = int(p.follows(i, ("with",)) and p.stands(j, ("and",)))  # "with C on B and B on A"
                yield OrderBy(by="named", items=items, first=first, span=p.span(i, j), cost=joined), j
    yield from piled_up(p, i)


def counted_pile(p: Parser, i: int, k: int, base: Structure) -> Results[Structure]:
    """ "a tower of two 3 cm cubes, white on black": which of the counted blocks lies on which."""
    blocks = base.members
    if base.kind != "stack" or base.plural or not isinstance(blocks, Noun) or blocks.amount is None:
        return
    plain = replace(blocks.traits, edge=None, size=None) == Traits() and not blocks.part_of and not blocks.conditions
    for order, end in one_on_another(p, p.any_of(k, (",", ":", ", with"))) if plain and p.stands(k, (",", ":")) else ():
        items = [replace(x, traits=replace(x.traits, edge=x.traits.edge or blocks.traits.edge)) for x in order.items
                 if isinstance(x, Noun)]  # fmt: skip
        if blocks.amount.low == blocks.amount.high == len(items):
            told = replace(order, items=tuple(items))
            yield replace(base, members=None, details=(*base.details, told), span=p.span(i, end)), end


_ON_IT = ("on it", "on top of it", "on that", "on top of that", "above it", "above that", "over it", "on this")
_UNDER_IT = ("under it", "below it", "beneath it", "underneath it", "under that", "below that", "under this")
_WAYS = tuple(
    (words, first, tuple(f"{at}{of}" for at in ends for of in ("", " of the tower", " of the stack", " of a tower")))
    for words, first, ends in (
        (_ON_IT, "bottom", ("at the bottom", "at the very bottom", "at the base")),
        (_UNDER_IT, "top", ("on top", "at the top", "on the top", "at the very top")),
    )
)
"""Where a tower is begun, and what is said of each block that comes next."""
_AND = (", and", ", then", ", and then", "and then", "and", "then", ",", ";", "with", ", with")


@rule
def piled_up(p: Parser, i: int) -> Results[OrderBy]:
    """ "red, on it orange, on it yellow", "red at the bottom, blue on it, green on that"."""
    for words, first, ends in _WAYS:
        for item, j in simple(p, i):
            if isinstance(item, Noun) and single(item):
                j = p.any_of(j, ends) or p.one(j, "first") or j
                for items, end in _next_on_it(p, j, words, (item,)):
                    yield OrderBy(by="named", items=items, first=first, span=p.span(i, end)), end


@rule
def piled_from_an_end(p: Parser, i: int) -> Results[Clause]:
    """The same by itself, which makes a tower: "red at the bottom, blue on it", "at the top is red, under it blue"."""
    for words, first, ends in _WAYS:
        led = p.any_of(i, ends)
        led = (p.any_of(led, _COMES) or led) if led else 0
        start = p.any_of(i, ("put", "place", "have", "set", "i want", "we want")) or i
        for item, j in simple(p, led or start):
            k = j if led else p.any_of(p.opt(j, "is", "goes", "sits", "lies"), ends)
            for items, end in (
                _next_on_it(p, k, words, (item,)) if k and isinstance(item, Noun) and single(item) else ()
            ):
                order = OrderBy(by="named", items=items, first=first, span=p.span(i, end))
                tower = Structure(kind="stack", det="the", span=order.span)
                yield Clause(verb="part", theme=tower, adjuncts=(order,), mode="goal", span=order.span), end


_COMES = ("is", "goes", "comes", "sits", "lies", ",", ":", "put", "place", "there is")
_LYING = ("is", "goes", "lies", "sits", "should be", "should go", "must be", "rests", "sitting", "lying", "resting",
          "stacked", "stands", "standing")  # fmt: skip


def _next_on_it(p: Parser, i: int, words: tuple[str, ...], had: tuple[Meaning, ...]) -> Results[tuple[Meaning, ...]]:
    j = p.any_of(i, _AND)
    if not j or len(had) > 12:
        return
    lead = p.any_of(j, words)
    for item, k in simple(p, lead or j):
        end = k if lead else p.any_of(p.any_of(k, _LYING) or k, words)
        if end and isinstance(item, Noun) and single(item):
            closed = _last_of_it(p, end, words, (*had, item))
            yield from [closed] if closed is not None else [((*had, item), end)]
            yield from _next_on_it(p, end, words, (*had, item))


def _last_of_it(
    p: Parser, i: int, words: tuple[str, ...], had: tuple[Meaning, ...]
) -> tuple[tuple[Meaning, ...], int] | None:
    """ "(red at the bottom, white above it), blue on top": the other end, with which all of the tower is told."""
    far = next(ends for told, _, ends in _WAYS if told is not words)
    for item, k in simple(p, j) if (j := p.any_of(i, _AND)) else ():
        end = p.any_of(p.opt(k, "is", "goes", "sits"), far)
        if end and not p.stands(end, ("of",)) and isinstance(item, Noun) and single(item):
            return (*had, item), end
    return None


def _more(p: Parser, i: int, words: tuple[str, ...]) -> Results[tuple[Meaning, ...]]:
    for item, j in simple(p, i):
        half = p.lex(j, lexicon.PATCH) is not None or p.lex(j, lexicon.BLOCK) is not None
        if half or not isinstance(item, Noun) or not single(item):
            continue
        following = p.any_of(j, words)
        further = list(_more(p, following, words)) if following else []
        yield from (((item, *rest), end) for rest, end in further)
        if not further:
            yield (item,), j


def single(item: Noun) -> bool:
    """One block, told by its look."""
    one = not item.plural and item.amount in (None, Amount(1, 1)) and item.det in ("bare", "a", "the")
    told = len(item.traits.colors) + len(item.traits.labels) == 1 and item.traits.rank is None
    return one and told and item.head != "patch" and item.part_of is None and not item.conditions
