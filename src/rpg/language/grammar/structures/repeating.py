"""Patterns that go on: "orange, purple, orange, purple... three of each", "red white red white and so on, 6 blocks".

How many there are is said elsewhere; with that, the list is told in full, so that it is read like any other.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.phrases import Beginnings, by_first
from rpg.language.tokens import Token

_ON = by_first(("…", "and so on", "and so forth", "etc .", "etc", "and so on and so forth", "et cetera"))
_ACROSS = frozenset({"grid", "square", "rectangle", "rows", "columns", "wall", "pyramid", "by"})
"""In these a list tells no order by itself."""
_JOINTS = frozenset({",", "and", "then", "-", "/"})
_APART = frozenset({",", ".", ";", ":", "-", "("})
_BLOCKS = frozenset({"blocks", "cubes", "bricks"})
_IN_ALL = by_first(("in total", "in all", "altogether", "total", "overall", "all together"))


def repeated(tokens: list[Token]) -> list[Token]:
    """The tokens with such a list told to its end."""
    at = next((n for n in range(3, len(tokens)) if tokens[n].word in _ON and _after(tokens, n, _ON)), 0)
    if not at or any(token.kind == "dims" or token.word in _ACROSS for token in tokens):
        return tokens
    first, colors = _list(tokens, at)
    period = _period(colors)
    if not period:
        return tokens
    behind = _after(tokens, at, _ON)
    starts = [behind, *(n for n in range(behind, len(tokens)) if tokens[n].word in _APART)]
    found = ((n, *count) for n in starts if (count := _told_behind(tokens, n, period)) is not None)
    start, many, end = next(found, (behind, _told_before(tokens[:first], period), behind))
    whole = [period[n % len(period)] for n in range(many)]
    if many < len(colors) or [c for c, _ in whole[: len(colors)]] != [c for c, _ in colors]:
        return tokens
    comma = replace(tokens[at], kind="punct", word=",", raw=",", value=None)
    told = [piece for n, (_, said) in enumerate(whole) for piece in ([comma, said] if n else [said])]
    return [*tokens[:first], *told, *tokens[behind:start], *tokens[end:]]


Colors = list[tuple[str, Token]]
"""Colours, each with a word for it."""


def _after(tokens: list[Token], at: int, phrases: Beginnings) -> int:
    """The position after the longest of `phrases` at a place, or 0."""
    words = tuple(token.word for token in tokens[at : at + 6])
    begun = phrases.get(words[0], ()) if words else ()
    return at + max((len(x) for x in begun if words[: len(x)] == x), default=-at)


def _list(tokens: list[Token], at: int) -> tuple[int, Colors]:
    """The colours in front of a place, and where they begin."""
    found: Colors = []
    n = first = at
    while n > 0:
        n -= 1
        color = lexicon.COLOR.get(tokens[n].word)
        if color is not None:
            found.insert(0, (color, tokens[n]))
            first = n
        elif tokens[n].word not in _JOINTS:
            break
    return first, found


def _period(colors: Colors) -> Colors:
    """What is said again and again in a list; nothing where it was not begun again."""
    named = [color for color, _ in colors]
    for size in range(2, len(named)):
        if all(named[n] == named[n - size] for n in range(size, len(named))) and len(set(named[:size])) > 1:
            return colors[:size]
    return []


def _told_behind(tokens: list[Token], at: int, period: Colors) -> tuple[int, int] | None:
    """How many there are in all, as it is said behind the list, and where that ends."""
    while at < len(tokens) and tokens[at].word in _APART | {"with", "using", "until", "for"}:
        at += 1
    opened = tokens[at - 1].word == "("
    counts: dict[str, int] = {}
    many = 0
    while at < len(tokens) and (number := tokens[at].many):
        at += 1
        if [t.word for t in tokens[at : at + 2]] == ["of", "each"]:
            many = number * _most(period)
            at += 2 + (at + 2 < len(tokens) and tokens[at + 2].word == "color")
            break
        color = _color(tokens[at].word) if at < len(tokens) else None
        if color is not None:
            counts[color] = number
            at += 1
        at += at < len(tokens) and tokens[at].word in _BLOCKS
        if color is None:
            many = number
            at = _after(tokens, at, _IN_ALL) or at
            break
        if at + 1 < len(tokens) and tokens[at].word in (",", "and") and tokens[at + 1].many:
            at += 1
    if counts:
        many = 0 if many else _fits(counts, period)
    if opened and at < len(tokens) and tokens[at].word == ")":
        at += 1
    elif opened:
        return None
    return (many, at) if many else None


def _most(period: Colors) -> int:
    """The length of the period where each colour is in it once; one more of each takes one more period."""
    named = [color for color, _ in period]
    return len(named) if len(set(named)) == len(named) else 0


def _told_before(tokens: list[Token], period: Colors) -> int:
    """How many there are in all, as it is said in front of the list in one way; 0 where it is not."""
    counts: dict[str, int] = {}
    totals: set[int] = set()
    for n, token in enumerate(tokens[:-1]):
        number = token.many
        if not number:
            continue
        after = tokens[n + 1].word
        color = _color(after)
        if color is not None:
            counts[color] = number
        elif after in _BLOCKS | {",", ":", "-"}:
            totals.add(number)
        elif after == "of" and tokens[n + 2 : n + 3] and tokens[n + 2].word == "each":
            totals.add(number * _most(period))
    if counts:
        totals.add(_fits(counts, period))
    return totals.pop() if len(totals) == 1 else 0


def _fits(counts: dict[str, int], period: Colors) -> int:
    """How many blocks of these colours there are, if they make up the beginning of what goes on; else 0."""
    total = sum(counts.values())
    return total if Counter(period[n % len(period)][0] for n in range(total)) == counts else 0


def _color(word: str) -> str | None:
    return lexicon.COLOR.get(word, lexicon.COLOR_PLURAL.get(word))
