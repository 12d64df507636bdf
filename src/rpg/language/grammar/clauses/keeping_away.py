"""What "keeps" away: "the green one keeps its distance from both, at least 10 cm", "it keeps clear of the red one"."""

from __future__ import annotations

from rpg.language.grammar.clauses.denials import stays
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.places.measures import bounds, measured
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Clause, Loc, Meaning, Noun, replace

_KEEP = frozenset({"keep", "keeps"})
_STAY = _KEEP | {"stay", "stays", "remain", "remains"}
_AWAY = Patterns(
    "keep|keeps its|their|some|a|a_certain|a_good|a_safe|a_respectful distance from",
    "keep|keeps well|far|safely? away from",
    "keep|keeps|stay|stays|remain|remains well? clear of",
)


def keeps_away(p: Parser, i: int, k: int, theme: Meaning, mode: str, negated: bool) -> Results[Meaning]:
    """How far from others it is to be all the time, from the verb at `k` on."""
    if not p.stands(k, _STAY) or _patch(theme):
        return
    far = list(_away(p, k))
    if any(_patch(place.landmark) for place, _ in far):
        return  # off it
    for place, end in far:
        found = Clause(verb="be", theme=theme, adjuncts=(place,), mode=mode, negated=negated, span=p.span(i, end))
        yield stays(found, False), end


def _away(p: Parser, k: int) -> Results[Loc]:
    for j in _AWAY.matches(p, k):
        for landmark, end in noun_phrase(p, j):
            apart = Loc(rel="apart", landmark=landmark, span=p.span(k, end))
            yield apart, end
            for (low, high), last in bounds(p, p.opt(end, ",")):
                if low is not None and high is None:
                    yield replace(apart, rel="distance", low=low, span=p.span(k, last)), last
    if p.stands(k, _KEEP):
        yield from ((place, end) for place, end in measured(p, k + 1) if isinstance(place, Loc))


def _patch(thing: Meaning | None) -> bool:
    return isinstance(thing, Noun) and thing.head == "patch"
