"""Where blocks of a line are not: "green neither at the top nor at the bottom", "red at neither end"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.places.sides import at, inside
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import At, Chain, Clause, Coord, Meaning, Noun, That

_WITH = ("with", ", with", "but with", ", but with", ", and", ", but", ",", "but", "and")
_NOT = frozenset({"not", "never"})
_DENYING = _NOT | {"neither", "anywhere"}
_BUT = ("anywhere but", "anywhere except", "anywhere other than", "anywhere else than")
_NEITHER = tuple(
    f"{at} neither {end}{of}"
    for at in ("at", "on")
    for end in ("end", "of the ends", "of the two ends", "of its ends", "of its two ends")
    for of in ("", *(f" of {it}" for it in ("it", "the row", "the line", "the column", "the tower", "the stack")))
)
_NOR = (", nor", "nor", "or", ", and not", "and not", "and also not", "and never")


@choice
def not_there(p: Parser, i: int) -> Results[That]:
    """ "a row of ..., with green not in the middle", "with neither red nor green at the bottom"."""
    j = p.any_of(i, _WITH)
    if not j or not p.anywhere(_DENYING):
        return
    for theme, k in noun_phrase(p, j):
        nor = isinstance(theme, Coord) and theme.op == "nor"
        if not isinstance(theme, Noun) and not nor:
            continue
        found = [(_denied(theme, (x,), "goal"), e) for x, e in at(p, k)] if nor else nowhere(p, k, theme)
        for told, end in found:
            yield That(kind="so", clauses=told, span=p.span(j, end)), end


def nowhere(p: Parser, i: int, theme: Meaning, mode: str = "goal", denied: bool = False) -> Results[Chain]:
    """Places in a line at which something is not; `denied`: "not" stands before them."""
    if not denied and (end := p.any_of(i, _NEITHER)):
        yield _denied(theme, (At(side="end", span=p.span(i, end)),), mode), end
    lone = p.any_of(i, _BUT) if not denied else 0
    start = lone or (i if denied else p.one(i, _NOT) or p.one(i, "neither"))
    neither = p.follows(start, ("neither",))
    for place, end in _there(p, start) if start else ():
        if not neither and not denied:
            yield _denied(theme, (place,), mode), end
        nor = 0 if lone else p.any_of(end, _NOR)
        for other, last in _there(p, nor) if nor else ():
            yield _denied(theme, (place, other), mode), last


def _there(p: Parser, i: int) -> Results[Meaning]:
    """ "at the top", "the top one"."""
    yield from at(p, i)
    if p.stands(i, ("the",)):
        yield from ((place, p.opt(k, "one", "block", "cube")) for place, k in inside(p, i, i + 1))


def _denied(theme: Meaning, places: tuple[Meaning, ...], mode: str) -> Chain:
    """That none of these things is at any of these places."""
    things = theme.items if isinstance(theme, Coord) else (theme,)
    clauses = tuple(
        Clause(verb="be", theme=thing, adjuncts=(place,), negated=True, mode=mode, span=theme.span)
        for thing in things
        for place in places
    )
    return Chain(clauses=clauses, links=("and",) * len(clauses), span=theme.span)
