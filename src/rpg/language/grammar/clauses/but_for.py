"""Exceptions behind all that is said of the blocks: "line them up in order, all but the 4", "they go into the left half,
except for the 1"."""

from __future__ import annotations

from rpg.language.grammar.clauses.not_so import not_so
from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Coord, Meaning, Noun

_BUT = ("except for", "except", "all but", "all except", "all except for", "but not", "only not", "apart from",
        "all apart from", "excluding", "with the exception of")  # fmt: skip
_SIGNS = frozenset({"except", "but", "not", "apart", "excluding", "exception"})
_ENDS = (".", ";", "!", "?")


@choice
def but_not(p: Parser, i: int) -> Results[Meaning]:
    """Blocks of which a clause is not said, or how a line of them is not to be."""
    yield from _but_for(p, i)
    yield from not_so(p, i)


def _but_for(p: Parser, i: int) -> Results[Coord]:
    """Blocks of which the clause is not said, alone in an exception; it ends the clause."""
    j = p.any_of(p.opt(i, ","), _BUT) if p.anywhere(_SIGNS) else 0
    for out, k in noun_phrase(p, j) if j else ():
        if (k >= p.end or p.words[k] in _ENDS) and all(map(_block, out.items if isinstance(out, Coord) else (out,))):
            yield Coord(op="except", items=(out,), span=p.span(i, k)), k


def _block(out: object) -> bool:
    return isinstance(out, Noun) and out.head != "patch" and out.det in ("the", "bare", "all") and not out.conditions
