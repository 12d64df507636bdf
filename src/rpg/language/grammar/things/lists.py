"""Explicit lists: "red, yellow, green", "red to yellow to green", "A B C", "first the red one, then ..."."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from rpg.language import lexicon
from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.things.adjectives import color
from rpg.language.grammar.things.labels import label_list
from rpg.language.grammar.things.retold import sized_alike
from rpg.language.later import later
from rpg.language.meaning import Meaning, Noun, Traits, replace
from rpg.language.tokens import Token

if TYPE_CHECKING:
    from rpg.language.grammar.things.nouns import noun_phrase, simple
else:
    noun_phrase, simple = later(__name__, "rpg.language.grammar.things.nouns", "noun_phrase", "simple")

_NEXT = ("and then", "and", "then", "followed by", "and finally", "finally", "and last", "and lastly", "lastly",
         "and at last", "at last", "and then finally", "then finally", "and last of all", "and after that",
         "after that", "and next", "next")  # fmt: skip
"""What a further thing of a list may come after."""


@rule
def listed(p: Parser, i: int) -> Results[tuple[Meaning, ...]]:
    """An explicit list, at least two long: "red, yellow, green", "red to yellow to green", "A B C", noun phrases."""
    yield from _colors(p, i)
    for (labels, more), j in label_list(p, p.any_of(i, _SYMBOLS) or i):
        if len(labels) > 1 and not more:
            span = p.span(i, j)
            yield tuple(Noun(head="any", traits=Traits(labels=(a,)), span=span) for a in labels), j
    for first, j in simple(p, i):
        if isinstance(first, Noun) and not (first.plural and len(first.traits.labels) == 1):
            yield from ((_one_by_one(p, sized_alike(p, items)), k) for items, k in _more(p, (first,), j))


def _one_by_one(p: Parser, items: tuple[Meaning, ...]) -> tuple[Meaning, ...]:
    """ "A red block, A, B, C, a blue block", "green, blue and white blocks": these come one after the other as well."""
    found: list[Meaning] = []
    for item in items:
        run = _run(item) if isinstance(item, Noun) else []
        single = isinstance(item, Noun) and len(run) > 1
        found += [replace(item, plural=False, traits=look, cost=0) for look in run] if single else [item]
    nouns = [item for item in found if isinstance(item, Noun)]
    shared = len(nouns) == len(found) > 1 and all(_run(x) and x.head == "any" and not x.plural for x in nouns[:-1])
    ahead = [token.word for token in p.tokens if token.span[1] <= nouns[-1].span[0]][-1:] if shared else []
    if (
        ahead == ["and"] and nouns[-1].plural and len(_run(nouns[-1])) == 1
    ):  # "green, blue and white blocks": one of each
        found[-1] = replace(nouns[-1], plural=False)
    return tuple(found)


def _run(item: Noun) -> list[Traits]:
    """The looks of "red", "red and blue blocks", "A, B, C", of which nothing else is said."""
    looks = item.traits
    plain = looks in (Traits(labels=looks.labels), Traits(colors=looks.colors))
    bare = plain and (item.det, item.amount, item.part_of, item.conditions) == ("bare", None, None, ())
    told = [Traits(labels=(x,)) for x in looks.labels] or [Traits(colors=(x,)) for x in looks.colors]
    return told if bare else []


_SYMBOLS = tuple(f"{the}{noun}" for the in ("the ", "") for noun in ("blocks", "cubes", "letters", "digits", "numbers"))
"""What may stand before a list of symbols; "the blocks 2" alone, of several, is the beginning of one."""


@choice
def _colors(p: Parser, i: int) -> Results[tuple[Meaning, ...]]:
    items: list[Meaning] = []
    at, readings = i, []
    while True:
        found = next(iter(color(p, at)), None)
        if found is None:
            break
        items.append(Noun(head="any", traits=Traits(colors=(found[0],)), span=p.span(at, found[1])))
        at = _again(p, found[1], items)
        if len(items) > 1:
            readings.append((tuple(items), at))
        at = p.opt(at, ",", "-")
        at = p.any_of(at, _NEXT) or p.opt(at, "to")
    yield from reversed(readings)


@rule
def ranks(p: Parser, i: int) -> Results[tuple[Meaning, ...]]:
    """ "a green and two blue blocks in no fixed order, then the white block": places of an order, some shared."""
    for items, shared, j in _ranks(p, i):
        if shared:
            yield items, j


def _ranks(p: Parser, i: int) -> Iterator[tuple[tuple[Meaning, ...], bool, int]]:
    for item, j in noun_phrase(p, i):
        shared = p.seq(j, "in no fixed order")
        if not shared and not isinstance(item, Noun):
            continue
        end = shared or j
        yield (item,), bool(shared), end
        k = p.any_of(end, (", then", "then"))
        for rest, also, last in _ranks(p, k) if k else ():
            yield (item, *rest), bool(shared) or also, last


def _more(p: Parser, items: tuple[Meaning, ...], at: int) -> Results[tuple[Meaning, ...]]:
    j = p.opt(at, ",")
    j = p.any_of(j, _NEXT) or j
    if j == at or len(items) > 30:
        return
    for item, k in simple(p, j):
        if isinstance(item, Noun) and not _next_part(items[0], item):
            k = _again(p, k, (*items, item))
            yield (*items, item), k
            yield from _more(p, (*items, item), k)


def _again(p: Parser, at: int, items: Sequence[Meaning]) -> int:
    """ "blue, then red, then blue again": the position behind it, where the look was in the list before."""
    looks = [item.traits for item in items if isinstance(item, Noun)]
    return p.opt(at, "again") if looks[-1] in looks[:-1] else at


def _next_part(first: Meaning, item: Noun) -> bool:
    """ "(the first row is) red, the second green": the next part with its look, and no second green block; "four gray
    blocks and one orange block, the orange one ...": one of these."""
    bare = isinstance(first, Noun) and first.det == "bare" and first.traits.rank is None
    counted = bare and isinstance(first, Noun) and first.amount is not None and item.amount is None
    return bare and item.det == "the" and (item.traits.rank is not None or (counted and not item.plural))


_RUN = 3
"""So many colours one after the other are a list, for nothing has two of them."""


def with_commas(tokens: list[Token]) -> list[Token] | None:
    """ "The red orange yellow and green cubes", "one red cube one blue cube": with commas; None where there is none."""
    out: list[Token] = []
    at, found = 0, False
    while at < len(tokens):
        end = at
        while _colored(tokens, end):
            end += 1
        closed = end > at and end < len(tokens) and tokens[end].word == "and" and _colored(tokens, end + 1)
        run = tokens[at : max(end, at + 1)]
        listed = len(run) + closed >= _RUN and len({token.word for token in run}) == len(run)
        for n, token in enumerate(run):
            if n and listed:
                out.append(Token("punct", ",", ",", token.span))
                found = True
            out.append(token)
        at += len(run)
        if _next_counted(tokens, at - 1) or _next_placed(tokens, at):
            out.append(Token("punct", ",", ",", tokens[at - 1].span))
            found = True
    return out if found else None


def _next_counted(tokens: list[Token], at: int) -> bool:
    """ "one red cube | one blue cube", "2 red | 2 blue": a block that is counted, and right behind it another one."""
    bare = 0 < at < len(tokens) - 2 and all(_colored(tokens, n) or _hued(tokens[n]) for n in (at, at + 2))
    if bare and _number(tokens[at - 1]) and _number(tokens[at + 1]):
        return True
    return _counted(tokens, at - 2) and _counted(tokens, at + 1)


def _next_placed(tokens: list[Token], at: int) -> bool:
    """ "red on the left column | blue on the right column": where one look is, and right behind it where another is."""
    ended = 2 < at < len(tokens) - 1 and tokens[at - 1].word in ("column", "row", "layer", "side", "end")
    placed = ended and {token.word for token in tokens[at - 4 : at - 2]} & _AT
    return bool(placed) and _colored(tokens, at) and tokens[at + 1].word in _AT


_AT = frozenset({"on", "in", "at"})


def _number(token: Token) -> bool:
    return token.kind == "number" or token.word in lexicon.NUMBER


def _hued(token: Token) -> bool:
    """ "reds"."""
    return token.kind == "word" and token.word in lexicon.COLOR_PLURAL


def _counted(tokens: list[Token], at: int) -> bool:
    if at < 0 or at + 2 >= len(tokens) or not _colored(tokens, at + 1) or tokens[at + 2].word not in lexicon.BLOCK:
        return False
    return tokens[at].word in ("a", "an") or _number(tokens[at])


def _colored(tokens: list[Token], at: int) -> bool:
    return at < len(tokens) and tokens[at].kind == "word" and tokens[at].word in lexicon.COLOR
