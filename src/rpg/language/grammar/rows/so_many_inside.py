"""A line of blocks of two kinds with a limit on one of them: "a tower of four with at most one white block in it", told
as the lines that it may be."""

from __future__ import annotations

import re

from rpg.language.grammar.rows.parting import text_of
from rpg.language.grammar.rows.turned import Turns, turned
from rpg.language.grammar.rows.vocabulary import BUILD, COLOR, LINE, MANY, PATCH, number
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_LOT = f"(?:{MANY}) {COLOR}(?: (?:blocks|cubes|bricks|boxes|ones))?"
_LOTS = on_demand(f"\\b({MANY}) ({COLOR})\\b(?! {PATCH}\\b)")
_LIMIT = ("(exactly|just|only|at most|at least|no more than|not more than|no fewer than|not fewer than)? ?"
          f"({MANY}) ({COLOR})(?: (?:blocks?|cubes?|bricks?|ones?))?")  # fmt: skip
_WITH = "(?:with|containing|that has|that have|that contains|which has|which contains|having|in which there (?:is|are))"
_ASKED = on_demand(
    f"(?:^|(?<=\\. ))(?:(?:from|out of|of|with|using) (?P<lots>{_LOT} and {_LOT})(?: ,)? )?{BUILD} (an? {LINE}) of "
    f"({MANY})(?: of them| blocks| cubes| bricks)?(?: ,)? {_WITH} {_LIMIT}(?: in it| inside)?(?= \\.|$)"
)
_MOST_WAYS = 4
"""Of more lines nobody is meant to be told one by one."""


def so_many_inside(tokens: list[Token]) -> list[Token]:
    """The tokens with each of the lines, where two colors are told with their numbers, and no others."""
    words = {token.word for token in tokens}
    if words.isdisjoint(_LEADS) or words.isdisjoint(_LINED):
        return tokens
    text = text_of(tokens)
    asked = _ASKED.search(text)
    if asked is None:
        return tokens
    line, total, how, many, color = asked.groups()[1:]
    told = _LOTS.findall(f"{text[: asked.start()]} {asked['lots'] or ''} {text[asked.end() :]}")
    stock = {look: number(lot) for lot, look in told}
    if not len(told) == len(stock) == 2 or color not in stock:
        return tokens
    (other,) = stock.keys() - {color}
    size, limit = number(total), number(many)
    inside = [n for n in range(size + 1) if n <= stock[color] and size - n <= stock[other] and _within(n, how, limit)]
    if not 0 < len(inside) <= _MOST_WAYS:
        return tokens
    ways = " or ".join(f"build {line} of {size} from {_blocks(size - n, other, n, color)}" for n in inside)
    there = f"there are {asked['lots']} . " if asked["lots"] else ""
    return turned(tokens, Turns([(f"^{re.escape(asked.group())}$", there + ways)]))


_LEADS = frozenset({"with", "containing", "contains", "has", "having", "which"})
_LINED = frozenset({"tower", "stack", "row", "line", "column"})


def _within(many: int, how: str | None, limit: int) -> bool:
    if how in ("at most", "no more than", "not more than"):
        return many <= limit
    if how in ("at least", "no fewer than", "not fewer than"):
        return many >= limit
    return many == limit


def _blocks(many: int, look: str, more: int, other: str) -> str:
    lots = [f"{n} {color} block{'s' if n > 1 else ''}" for n, color in ((many, look), (more, other)) if n]
    return " and ".join(lots)
