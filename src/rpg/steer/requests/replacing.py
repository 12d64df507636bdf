"""Requests that put one thing in the place of another, exchange two, or keep some where they are."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TypeGuard

from rpg.core.diagnostics import Span
from rpg.steer.places import place
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import (
    Parser,
    adjectives,
    label_list,
    lexicon,
    longest,
    m,
    noun_phrase,
    phrases,
    simple,
)
from rpg.steer.requests.phrases import fresh, plural_kind, subjects, things

REPLACE = ("replace", "substitute", "exchange", "swap out", "switch out", "swap", "switch", "trade")


TRADE = phrases(
    "swap the positions of | swap the places of | exchange the positions of | swap positions of | "
    "interchange | exchange the place of | exchange place of | swap place of | swap the place of | change places of | "
    "switch the positions of | swap the order of | swap places of | exchange the places of "
    "| switch places of | swap | switch | exchange | trade"
)


def replace_with(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "replace the green cube with a yellow one", "swap the red block for a blue one"."""
    for phrase in REPLACE:
        j = p.seq(i, phrase)
        for old, k in (*subjects(p, j), *_colors_alone(p, j)) if j else ():
            links: tuple[str, ...] = ("with", "by") if phrase == "substitute" else ("with", "by", "for", "out for")
            if n := longest(p, k, links):
                yield from _by_symbol(p, i, n, old)
                for new, end in things(p, n):
                    if fresh(new) or plural_kind(new):
                        yield r.Replace(old=old, new=new, span=p.span(i, end)), end
                    elif _only_a_color(new):
                        if _only_a_color(old):
                            old = replace(old, det="all", plural=True)
                        yield (r.Replace(old=old, new=replace(new, det="a"), span=p.span(i, end), cost=2), end)
        if j and phrase == "substitute":
            for new, k in noun_phrase(p, j):
                if n := p.one(k, "for"):
                    for old, end in noun_phrase(p, n):
                        yield r.Replace(old=old, new=new, span=p.span(i, end)), end


def _by_symbol(p: Parser, i: int, n: int, old: m.Meaning) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "by the digit 4", "with the letter A", "with C": another symbol, or a cube that shows it."""
    said = longest(p, n, "the letter | the digit | the number | the symbol | letter | digit | number")
    for (labels, _), end in label_list(p, said or n, True):
        if len(labels) != 1 or p.lex(end, lexicon.BLOCK) is not None:
            continue
        if said:
            kind = "digit" if labels[0].isdigit() else "letter" if labels[0].isalpha() else "symbol"
            amount = m.Amount(1, 1)
            new = m.Noun(
                head="block", det="a", amount=amount, traits=m.Traits(labels=labels, kind=kind), span=p.span(n, end)
            )
            yield r.Replace(old=old, new=new, span=p.span(i, end)), end
        else:
            yield r.Restyle(theme=old, traits=m.Traits(labels=labels), plainly=False, span=p.span(i, end), cost=2), end


def _in_place_of(old: m.Meaning | None, new: m.Meaning, span: Span) -> r.Request:
    """One thing instead of another; a colour instead of a colour changes every block that has it."""
    if old is not None and _only_a_color(old):
        old = replace(old, det="all", plural=True)
        if _only_a_color(new):
            return r.Restyle(theme=old, traits=new.traits, span=span)
    return r.Replace(old=old, new=new, span=span)


def _bare_colors(phrase: m.Noun) -> bool:
    """Phrases such as "blue cubes", "red": a colour and nothing else."""
    said = phrase.traits == m.Traits(colors=phrase.traits.colors) and len(phrase.traits.colors) == 1
    return said and phrase.amount is None and phrase.det == "bare" and phrase.part_of is None


def _only_a_color(phrase: m.Meaning) -> TypeGuard[m.Noun]:
    """Phrases such as "swap red for pink": a block of that colour."""
    if not isinstance(phrase, m.Noun) or phrase.det != "bare" or phrase.head != "any":
        return False
    return len(phrase.traits.colors) == 1 and not phrase.plural and phrase.amount is None


def instead(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "use letters instead of colours", "a blue block in place of the red one"."""
    j = (
        longest(
            p,
            i,
            "use | add | put | have | make it with | make them with | with | do it with | try | "
            "build it with | take | make it from | make it out of | make them out of | build it out of | "
            "build it from | make it of | use only | only use | with only | only",
        )
        or i
    )
    for new, k in noun_phrase(p, j):
        for phrase in ("instead of", "in place of", "rather than", "in lieu of", "and not", "not"):
            if n := p.seq(k, phrase):
                for old, end in _old(p, n):
                    yield _in_place_of(old, new, p.span(i, end)), end
        if (end := p.one(k, "instead")) and j > i:
            yield r.Replace(old=None, new=new, span=p.span(i, end), cost=1), end
        if (
            j > i
            and longest(
                p,
                i,
                "use | with | do it with | make it with | try it with | do the same with | make it out of | "
                "make it from | build it out of | build it from | make it of | only use | only",
            )
            and plural_kind(new)
        ):
            end = p.opt(k, "only")
            yield r.Replace(old=None, new=new, span=p.span(i, end), cost=2), end
    if start := longest(p, i, "use | take | have | i want"):
        for new, k in noun_phrase(p, start):
            if isinstance(new, m.Noun) and new.head == "patch" and new.det == "a":
                yield r.Replace(old=None, new=new, span=p.span(i, k), cost=2), k
            n = p.one(k, "for")
            if not n or not isinstance(new, m.Noun) or not _bare_colors(new):
                continue
            for old, end in noun_phrase(p, n):
                if not fresh(old):
                    yield r.Restyle(theme=old, traits=new.traits, span=p.span(i, end)), end
    if (j := p.seq(i, "instead of")) or (j := p.seq(i, "rather than")):
        for old, k in _old(p, j):
            n = longest(p, k, ", use | use | , put | put | , | , i want | , have | , take | , make it")
            for new, end in noun_phrase(p, n) if n else ():
                if _only_a_color(new):
                    new = replace(new, det="a")
                yield r.Replace(old=old, new=new, span=p.span(i, end)), end


def _old(p: Parser, i: int) -> Iterator[tuple[m.Meaning | None, int]]:
    """What is given up: blocks of the task, or only their colours."""
    yield from noun_phrase(p, i)
    yield from _colors_alone(p, i)


def _colors_alone(p: Parser, i: int) -> Iterator[tuple[m.Meaning, int]]:
    if j := longest(p, i, "the colors | colors | color | the color | colours | colored | plain | the colours"):
        yield (m.Noun(head="block", det="all", plural=True, traits=m.Traits(kind="plain"), span=p.span(i, j)), j)


def _change_places(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "have blue and green trade places", "the red and the blue block should swap"."""
    start = longest(p, i, "have | let | make") or i
    for both, k in noun_phrase(p, start):
        pair = both.items if isinstance(both, m.Coord) and len(both.items) == 2 else _pair(both)
        n = longest(p, k, "should | must | could | have to | need to") or (k if start > i else 0)
        end = longest(p, n, _TRADING) if n else 0
        if pair and end:
            yield r.Trade(a=pair[0], b=pair[1], span=p.span(i, end)), end


_TRADING = phrases(
    "trade places | swap places | switch places | exchange places | change places | swap positions | trade positions | "
    "switch positions | exchange positions | swap | be swapped | be exchanged | be switched | switch"
)


@dataclass(frozen=True, slots=True, kw_only=True)
class TradeColors(r.Request):
    """The two colours of the blocks (or of the patches) change over."""

    patches: bool = False


_COLORS = phrases(
    "swap the colors | swap the two colors | exchange the colors | switch the colors | swap colors | exchange the two "
    "colors | switch the two colors | flip the colors | invert the colors | interchange the colors | swap both colors"
)
_OF_ALL = tuple(
    f"of the {two} {noun}".replace("  ", " ")
    for two in ("", "two", "three", "four")
    for noun in ("blocks", "cubes", "layers", "rows", "columns", "towers", "stacks", "groups", "piles", "letters")
)
_OF_PATCHES = phrases("of the patches | of the two patches | of the mats | of the two mats | of the zones")


def _traded_colors(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "swap the colours of the two layers"."""
    if j := longest(p, i, _COLORS):
        end = longest(p, j, _OF_PATCHES)
        yield TradeColors(patches=bool(end), span=p.span(i, end or j)), end or longest(p, j, _OF_ALL) or j


def trade(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "swap the red and the blue block", "switch the red one with the blue one"."""
    yield from _change_places(p, i)
    yield from _traded_colors(p, i)
    for phrase in TRADE:
        j = p.seq(i, phrase)
        if not j:
            continue
        yield from _two_places(p, i, j)
        for both, k in noun_phrase(p, j):
            if isinstance(both, m.Coord) and len(both.items) == 2:
                end = longest(p, k, _AROUND) or k
                yield (r.Trade(a=both.items[0], b=both.items[1], span=p.span(i, end)), end)
            pair = _pair(both)
            if pair:
                end = longest(p, k, _AROUND) or k
                yield r.Trade(a=pair[0], b=pair[1], span=p.span(i, end)), end
            if n := longest(p, k, ("with", "and", "for")):
                for other, end in simple(p, n):
                    if not fresh(both) and not fresh(other):
                        yield r.Trade(a=both, b=other, span=p.span(i, end)), end


_AROUND = ("around", "places", "positions", *(f"in the {line}" for line in ("row", "line", "tower", "stack", "column")))


def _two_places(p: Parser, i: int, j: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "swap the top and bottom blocks", "exchange the first and the last one"."""
    for one, k in _rank(p, longest(p, j, "the")):
        for two, n in _rank(p, longest(p, k, "and the | and | with the")):
            end = longest(p, n, "blocks | block | ones | one | cubes | cube | letters | letter | numbers") or n
            end = longest(p, end, ("around", "places", "positions")) or end
            a, b = (
                m.Noun(head="block", det="the", traits=m.Traits(rank=each), span=p.span(j, end)) for each in (one, two)
            )
            yield r.Trade(a=a, b=b, span=p.span(i, end)), end


def _rank(p: Parser, i: int) -> Iterator[tuple[str, int]]:
    """A place in a line: "top", "first", "leftmost"."""
    for marks, j in adjectives(p, i) if i else ():
        if set(marks) == {"rank"}:
            yield str(marks["rank"]), j


def _pair(both: m.Meaning) -> tuple[m.Noun, m.Noun] | None:
    """Phrases such as "the red and blue blocks": two phrases in one."""
    if not isinstance(both, m.Noun) or both.det not in ("the", "bare", "both", "its"):
        return None
    colored, labelled = both.traits.colors, both.traits.labels
    if len(colored) == 2 and not labelled:
        each = [m.Traits(colors=(color,)) for color in colored]
    elif len(labelled) == 2 and not colored:
        each = [m.Traits(labels=(label,)) for label in labelled]
    else:
        return None
    one, two = (m.Noun(head=both.head, det="the", traits=traits, span=both.span) for traits in each)
    return one, two


def keep(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "keep the letter A on top", "leave the base where it is"."""
    lead = longest(p, i, "do it | do this | do that | do so | build it")
    i = lead if lead and p.one(lead, "without") else i
    j = longest(
        p,
        i,
        "keep | keeping | leave | leaving | except for | except | apart from | other than | "
        "without moving | without touching | do not move | do not touch | do not change | "
        "without changing",
    )
    for theme, k in noun_phrase(p, j) if j else ():
        end = longest(
            p,
            k,
            "where it is | where they are | as it is | as they are | as is | in place | the same "
            "| unchanged | in its place | alone | fixed | there | untouched | still | the way it "
            "is | the way they are",
        )
        if end:
            still = p.words[i] not in ("except", "apart", "other")
            yield r.Keep(theme=theme, still=still, span=p.span(i, end)), end
            continue
        for where, stop in place(p, k):
            yield r.Keep(theme=theme, place=where, span=p.span(i, stop)), stop
        if p.words[i] in ("except", "apart", "other", "without", "do"):
            moving = bool(longest(p, i, "without moving | without touching | do not move | do not touch"))
            yield r.Keep(theme=theme, still=moving, span=p.span(i, k)), k


_MAY_MOVE = tuple(
    f"{may} {move}"
    for may in ("may", "can", "is allowed to", "are allowed to")
    for move in (
        "move",
        "be moved",
        "move now",
        "be moved now",
        "move again",
        "be touched",
        "go anywhere",
        "be anywhere",
    )
) + phrases(
    "need not stay where it is | does not have to stay where it is | no longer has to stay where it is | "
    "need not stay there | does not have to stay | no longer has to stay | need not stay put | does not need to stay | "
    "do not have to stay where they are | no longer have to stay where they are"
)


def free(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "the red one may be moved", "the base need not stay where it is"."""
    for theme, k in subjects(p, i):
        end = longest(p, k, _MAY_MOVE)
        if end and not fresh(theme):
            yield r.Free(theme=theme, span=p.span(i, end)), end
