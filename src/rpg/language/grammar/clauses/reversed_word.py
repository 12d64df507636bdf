"""What a word that is spelt backwards comes to, said once more: "CAT backwards, so that it reads TAC"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.labels import literal
from rpg.language.meaning import Meaning

_MARKS = (",", ":", "(")
_READS = Patterns(
    "so|so_that|such_that|and it|the_word reads|says|spells|is",
    "that_is|that_means|i.e|i.e.|ie|namely|meaning|reading|to_read|as|which_reads|which_is|it_reads|like_this ,|:?",
)
_SYMBOL = "letter|one|digit|symbol|character"
_LAST_FIRST = Patterns(
    f"so|so_that|such_that|with|and|i.e? the last {_SYMBOL} comes|is|stands|goes|being|coming first",
    f"starting|beginning|beginning_it|starting_it with|from the last {_SYMBOL}",
    f"so|so_that|such_that it|the_word starts|begins with the last {_SYMBOL}",
)
_ITS_LAST = Patterns("starting|beginning with the? letter?", "so|so_that it|the_word starts|begins with the? letter?")


def told_reversed(p: Parser, end: int, text: str, found: tuple[Meaning, ...]) -> Iterator[int]:
    """The positions behind it, where it is so."""
    if not any(getattr(x, "kind", "") == "backwards" or getattr(x, "by", "") == "reverse" for x in found):
        return
    start = p.opt(end, *_MARKS)
    yield from _LAST_FIRST.matches(p, start)
    for j in _ITS_LAST.matches(p, start):
        if literal(p, j) == text[-1]:
            yield j + 1
    for j in (*_READS.matches(p, start), *((start,) if start > end else ())):
        if literal(p, j) == text[::-1]:
            yield p.opt(j + 1, ")")
