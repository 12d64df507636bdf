"""Where all of what was told is to be: "put red on blue or blue on red, but do it in the left half"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.clauses.adjuncts import adjunct
from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.labels import TOO
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import TOLD_HERE, Clause, Coord, In, Loc, Meaning, Noun, Pronoun, replace

_DO_IT = Patterns(
    ",? but|and|and_please|only|just|but_please|and_make_sure_to|but_only do it|this|that|so|all_this|all_of_it|"
    "everything all?"
)


def done_there(p: Parser, i: int, had: tuple[Meaning, ...], links: tuple[str, ...]) -> Results[Clause]:
    """ "..., but do it on the green mat": said of all that the sentence told before; of several steps it could be said
    of the last alone."""
    plain = all(isinstance(c, Clause) and c.mode in ("goal", "command") and not c.negated for c in had)
    if not plain or not {"then", "before", "after"}.isdisjoint(links):
        return
    for j in _DO_IT.matches(p, i):
        for place, k in adjunct(p, j):
            if _whereabouts(place):
                yield _of_all(place), k


def afterthought(p: Parser, i: int, had: tuple[Meaning, ...], last: Meaning) -> Iterator[tuple[Meaning, ...]]:
    """ "red on blue and green on yellow, in the left half": perhaps of all of them, and not of the last one alone."""
    if not isinstance(last, Clause) or not last.adjuncts or not _whereabouts(last.adjuncts[-1]) or last.negated:
        return
    *others, place = last.adjuncts
    if not others and len(had) > 1 and isinstance(last.theme, Pronoun) and last.theme.word == "same":
        yield (replace(_of_all(place), cost=last.cost),)
    if not others:
        return
    at = next((n for n in range(i, p.end) if p.char(n, 0) >= place.span[0]), i)
    if at > i and p.words[at - 1] in (",", "but") and all(isinstance(x, Loc) for x in others):
        yield replace(last, adjuncts=tuple(others)), _of_all(place)


def likewise(p: Parser, i: int, before: Clause) -> Results[Clause]:
    """ "Red goes on the mat, and blue as well", "A and B touch, C and D too": the same of others, if it may be so of
    several."""
    if before.verb not in ("be", "place") or before.negated or not before.adjuncts:
        return
    for theme, j in noun_phrase(p, i) if all(_whereabouts(x) or _beside(x) for x in before.adjuncts) else ():
        end = p.any_of(j, TOO)
        if end and isinstance(theme, Noun | Coord) and (end >= p.end or p.stands(end, _ENDS)):
            yield replace(before, theme=theme, span=p.span(i, end)), end


_ENDS = frozenset({",", ";", "and", "but", "please"})


def _whereabouts(place: Meaning) -> bool:
    """A part of the table, or a patch: where several things may be."""
    if isinstance(place, In):
        return True
    mark = place.landmark if isinstance(place, Loc) and place.rel == "on" else None
    return isinstance(mark, Noun) and mark.head == "patch" and not mark.traits.matching


def _beside(place: Meaning) -> bool:
    """How blocks stand to others on the table, or to each other."""
    return isinstance(place, Loc) and place.rel not in ("on", "above", "under", "below")


def _of_all(place: Meaning) -> Clause:
    told = Pronoun(word=TOLD_HERE, span=place.span)
    return Clause(verb="be", theme=told, adjuncts=(place,), mode="goal", span=place.span)
