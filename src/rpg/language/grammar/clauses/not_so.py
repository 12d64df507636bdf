"""How a line is not to be: "in a row, but not in alphabetical order", "in a row that does not spell HIDE", "..., but
not with B in the middle"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.places.absolutes import absolute
from rpg.language.grammar.places.sides import TOWERS, toward
from rpg.language.grammar.structures.orders import order
from rpg.language.grammar.things.labels import literal
from rpg.language.meaning import (
    Absolute,
    At,
    Chain,
    Clause,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Structure,
    That,
    Toward,
    Using,
)

_NOT = ("but not", "not", "that is not", "which is not", "that are not", "which are not", "but never", "never")
_NOT_SPELLING = (
    "that does not spell", "which does not spell", "that does not read", "so that they do not spell",
    "but not spelling", "not spelling", "without spelling", "in any order but", "in any order except",
    "in any order other than",
)  # fmt: skip
_EITHER = ("from either end", "from either side", "in either direction", "either way")
_ENDS = (".", ";", ",", "!", "?")
_SORTED = frozenset({"label", "number", "ascending", "in_order", "count_up", "countdown", "size", "rainbow"})


def not_so(p: Parser, i: int) -> Results[That]:
    """What is denied of the blocks spoken of, at the end of a clause."""
    start = p.opt(i, ",")
    if j := p.any_of(start, _NOT_SPELLING):
        text = literal(p, j)
        if text is not None and len(text) > 1:
            word = Structure(kind="word", det="the", letter=text, span=p.span(j, j + 1))
            yield from _denied(p, i, j + 1, "spell", word, (Using(members=_they(p, i), span=word.span),))
        return
    j = p.any_of(start, _NOT)
    for told, k in order(p, j) if j else ():
        if not p.all.isdisjoint(TOWERS) or "from" in p.words[:i]:
            continue  # which way is open, or it is another way round that is meant
        if isinstance(told, OrderBy) and told.by in _SORTED and not told.items:
            yield from _denied(p, i, k, "be", _they(p, i), (told,))
            for way, end in toward(p, k):
                if isinstance(way, Toward) and way.first is not None:
                    yield from _denied(p, i, end, "be", _they(p, i), (told, way))
            if end := p.any_of(k, _EITHER):
                ways = OrderBy(by="either", span=p.span(k, end))
                yield from _denied(p, i, end, "be", _they(p, i), (told, ways))
    for there, k in absolute(p, j) if j and p.stands(j, ("with",)) else ():
        at = there.adjuncts[0] if isinstance(there, Absolute) and len(there.adjuncts) == 1 else None
        if isinstance(there, Absolute) and isinstance(at, At) and isinstance(there.theme, Noun):
            yield from _denied(p, i, k, "be", there.theme, (at,))


def _they(p: Parser, i: int) -> Pronoun:
    return Pronoun(word="they", span=p.span(i, i + 1))


def _denied(p: Parser, i: int, k: int, verb: str, theme: Meaning, adjuncts: tuple[Meaning, ...]) -> Results[That]:
    if k >= p.end or p.words[k] in _ENDS:
        span = p.span(i, k)
        said = Clause(verb=verb, theme=theme, adjuncts=adjuncts, negated=True, mode="goal", span=span)
        yield That(kind="so", clauses=Chain(clauses=(said,), links=("and",), span=span), span=span), k
