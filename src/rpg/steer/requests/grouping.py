"""Requests about groups: sort into piles, mix kinds, trade members."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.steer.requests import requests as r
from rpg.steer.requests.language import Parser, count, longest, m, noun_phrase, phrases

KINDS = {
    "letters": "letter", "letter": "letter", "numbers": "digit", "number": "digit", "digits": "digit", "digit": "digit",
    "colors": "plain", "colours": "plain", "color": "plain", "colour": "plain", "plain": "plain", "colored": "plain",
    "coloured": "plain",
}  # fmt: skip
_BY = {
    "color": "color", "colour": "color", "kind": "kind", "type": "kind", "letter": "label", "label": "label",
    "number": "label", "size": "size", "category": "kind", "symbol": "label",
}  # fmt: skip
_PILES = ("piles", "groups", "bunches", "clusters")
_OWN = (
    "respective",
    "their respective",
    "the respective",
    "separate",
    "separated",
    "their own",
    "matching",
    "corresponding",
    "the right",
)
_INTO = (*_PILES, *(f"{own} {pile}" for own in _OWN for pile in _PILES))


def mixture(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "change the blocks to letters, numbers and colors mixed", "use a mix of letters and digits"."""
    starts: list[tuple[m.Meaning | None, int]] = []
    for verb in ("change", "turn", "make", "convert", "switch", "transform"):
        if j := p.seq(i, verb):
            for theme, k in noun_phrase(p, j):
                starts.append((theme, longest(p, k, "to | into | be | to be") or k))
    if j := longest(p, i, "use | take | with | mix in | have"):
        starts.append((None, j))
    for about, j in starts:
        start = longest(p, j, "a mix of | a mixture of | mixed | a combination of | a mixed set of | some") or j
        kinds, k = _kinds(p, start)
        if len(kinds) > 1:
            yield r.Kinds(kinds=kinds, theme=about, span=p.span(i, k)), k


def _kinds(p: Parser, i: int) -> tuple[tuple[str, ...], int]:
    """A list of kinds of block: "letters, numbers, colors mixed"."""
    found: list[str] = []
    at = end = i
    while at < p.end and p.words[at] in KINDS:
        found.append(KINDS[p.words[at]])
        end = p.reach(at + 1)
        end = longest(p, end, "blocks | cubes | block | cube | ones") or end
        at = p.opt(end, ",")
        at = longest(p, at, "and | plus | as well as | &") or at
    end = longest(p, end, "mixed together | mixed up | mixed | all mixed up | all mixed | in a mix") or end
    return tuple(dict.fromkeys(found)), end


def group(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "sort into respective piles", "group them by kind", "separate them by colour into piles"."""
    verbs = (
        "sort out",
        "sort",
        "group",
        "separate",
        "gather",
        "cluster",
        "divide",
        "split",
        "organize",
        "organise",
        "put",
    )
    j = longest(p, i, verbs)
    if not j:
        return
    themes: list[tuple[m.Meaning | None, int]] = [(None, j)]
    themes += noun_phrase(p, j)
    for theme, k in themes:
        for by, end in _by(p, k):
            into = longest(p, end, ("into", "in"))
            stop = longest(p, into, _INTO) if into else 0
            if stop:
                for late, last in _by(p, stop):
                    if by is None or late is None:
                        yield (r.Group(by=by or late, theme=theme, span=p.span(i, last)), last)
            elif by is not None and p.words[i] not in ("put", "sort"):
                yield r.Group(by=by, theme=theme, span=p.span(i, end)), end


def _by(p: Parser, i: int) -> Iterator[tuple[str | None, int]]:
    j = longest(p, i, "by their | by the | by | according to their | according to")
    word = p.words[j] if j and j < p.end else ""
    if word in _BY:
        yield _BY[word], p.reach(j + 1)
    yield None, i


def outliers(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "swap one block from each pile into another so each has one outlier"."""
    yield from _with_strangers(p, i)
    j = longest(p, i, "swap | move | exchange | switch | trade | put | mix")
    if not j:
        return
    for n, k in _counts(p, j):
        k = longest(p, k, "block | blocks | cube | cubes | item | items | member | members | of them") or k
        of = longest(p, k, "from each | of each | from every | of every | in each | between the | between")
        group = p.one(of, _GROUPS) if of else 0
        if not group:
            continue
        group = longest(p, group, _ELSEWHERE) or group
        end = _so_each(p, group, n)
        yield r.Outliers(count=n, span=p.span(i, end)), end


_GROUPS = frozenset({"pile", "piles", "group", "groups", "bunch", "bunches", "cluster", "clusters", "stack", "stacks"})
_ELSEWHERE = phrases(
    "into another one | into another pile | into another group | into another | to another one | to "
    "another pile | to another group | to another | into the other | to the other | into the next | with "
    "another | into a different one | into a different pile | with the others | into the others | to a "
    "different pile | into the wrong one | into the wrong pile"
)


def _with_strangers(p: Parser, i: int) -> Iterator[tuple[r.Request, int]]:
    """Phrases such as "with exactly one stranger in each group", "one outlier per pile"."""
    j = longest(p, i, "with | let there be | i want | have | make it | there should be") or i
    for n, k in _counts(p, p.opt(j, "exactly", "just")):
        of = longest(p, longest(p, k, _STRANGERS), "in each | per | in every | in both | for each")
        if group := p.one(of, _GROUPS) if of else 0:
            yield r.Outliers(count=n, span=p.span(i, group)), group


_STRANGERS = phrases(
    "outlier | outliers | odd one out | stranger | strangers | misfit | wrong block | foreign block | different block"
)


def _counts(p: Parser, i: int) -> Iterator[tuple[int, int]]:
    yield from count(p, i)
    if j := p.one(i, frozenset({"a", "an"})):
        yield 1, j


def _so_each(p: Parser, i: int, n: int) -> int:
    """The position after "so that each has one outlier"."""
    j = longest(p, i, "so that | such that | so | , so that | , so")
    j = (
        longest(
            p, j, "each pile | each group | each one | each | every pile | every group | every one | all of them | they"
        )
        if j
        else 0
    )
    j = longest(p, j, "has | have | contains | will have | gets | ends up with") if j else 0
    if not j:
        return i
    j = p.opt(j, "exactly")
    for found, k in _counts(p, j):
        k = longest(p, k, _STRANGERS)
        if k and found == n:
            return k
    return i
