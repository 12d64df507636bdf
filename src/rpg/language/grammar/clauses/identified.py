"""Which block it is that another has its place by: "the one that red has to stand on is blue", "the blue block is the
one on which red belongs", "it is behind the blue one that red must stand"."""

from __future__ import annotations

from rpg.language.grammar.clauses.adjuncts import adjunct
from rpg.language.grammar.clauses.having import what_carries
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.held import THE_ONE, by_block
from rpg.language.grammar.places.prepositions import relation
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import simple
from rpg.language.grammar.things.told_relatives import STANDS_THERE
from rpg.language.meaning import Clause, In, Loc, Meaning, Noun, Structure, replace

_GOES = (
    "goes", "should go", "must go", "has to go", "is", "should be", "must be", "lies", "should lie", "sits", "stands",
    "comes", "should come", "belongs", "should sit", "should stand", "must lie", "must stand", "i want",
)  # fmt: skip


_AGAIN = frozenset({",", ";", "and"})
"""Behind these "is" may be left out: "the block behind red is blue, the one behind blue green"."""


@rule
def what_is_there(p: Parser, i: int, mode: str) -> Results[Clause]:
    """ "what goes on top of the yellow block is the pink one", "the block under the red one is yellow", "what stands
    behind it is a tower of two blue blocks"."""
    led = p.any_of(i, ("what", "the block that", "the one that", "the cube that"))
    for place, k in adjunct(p, j) if (j := p.any_of(led, _GOES) if led else p.any_of(i, THE_ONE)) else ():
        spot = place if led else by_block(p, place)
        end = p.any_of(k, ("is", "should be", "must be", "has to be")) if spot is not None else 0
        end = end or (k if spot is not None and not led and p.follows(i, _AGAIN) else 0)
        for theme, last in simple(p, end) if end else ():
            whole = isinstance(theme, Structure) and theme.det == "a" and bool(led)
            if (whole or (isinstance(theme, Noun) and theme.head != "patch")) and isinstance(spot, Loc | In):
                span = p.span(i, last)
                yield Clause(verb="be", lemma="fact", theme=theme, adjuncts=(spot,), mode=mode, span=span, cost=1), last
    yield from what_carries(p, i, mode)


_ONE = Patterns("the block|cube|brick|one|thing")
_LED = Patterns("what", "the block|cube|brick|one|thing that|which?")
_IS = Patterns("is|must_be|should_be|shall_be|has_to_be|is_to_be|will_be|ought_to_be")
_THAT = Patterns("that|which|where")
_CLEFT = Patterns("it is|must_be|should_be|shall_be|has_to_be|is_to_be")


@rule
def identified(p: Parser, i: int, mode: str) -> Results[Clause]:
    """What stands where, told by what it is of another block."""
    for theme, rel, mods, j in _places_by(p, i):
        for end in _IS.matches(p, j):
            for mark, k in simple(p, end):
                yield from _told(p, i, k, theme, Loc(rel=rel, landmark=mark, mods=mods, span=p.span(i, k)), mode)
    for start in _CLEFT.matches(p, i):
        yield from _cleft(p, i, start, mode)
    for theme, j in simple(p, i + 1) if p.stands(i, ("where",)) else ():
        for end in (e for stands in STANDS_THERE.matches(p, j) for e in _IS.matches(p, stands)):
            for mark, k in simple(p, end):
                if isinstance(mark, Noun) and mark.head == "patch":
                    yield from _told(p, i, k, theme, Loc(rel="on", landmark=mark, span=p.span(i, k)), mode)
    if not p.stands(i, _NO_NAME):
        for mark, j in simple(p, i) if p.rarely(_NAMING) else ():
            for start in _IS.matches(p, j):
                for theme, rel, mods, k in _places_by(p, start):
                    yield from _told(p, i, k, theme, Loc(rel=rel, landmark=mark, mods=mods, span=p.span(i, k)), mode)


_NO_NAME = frozenset({"it", "this", "that", "there", "what"})
_NAMING = frozenset({"the"})


def _places_by(p: Parser, i: int) -> list[tuple[Meaning, str, tuple[str, ...], int]]:
    """ "the one that red must stand on", "the block on which red must stand": who, how it stands to that one."""
    found: list[tuple[Meaning, str, tuple[str, ...], int]] = []
    for j in _LED.matches(p, i):
        for theme, k in simple(p, j):
            for stands in STANDS_THERE.matches(p, k):
                found += [(theme, rel, mods, end) for (rel, mods), end in relation(p, stands)]
    for j in _ONE.matches(p, i):
        for (rel, mods), k in relation(p, j):
            for theme, end in simple(p, which) if (which := p.one(k, "which")) else ():
                found += [(theme, rel, mods, stands) for stands in STANDS_THERE.matches(p, end)]
    return found


def _cleft(p: Parser, i: int, j: int, mode: str) -> Results[Clause]:
    """ "(it is) behind blue that red must stand", "blue that red must stand behind"."""
    for place, k in adjunct(p, j):
        for that in _THAT.matches(p, k) if isinstance(place, Loc | In) else ():
            for theme, end in simple(p, that):
                for stands in STANDS_THERE.matches(p, end):
                    yield from _told(p, i, stands, theme, place, mode)
    for mark, other, k in _marks(p, j):
        whose = [(place, end) for place, which in relation(p, k) if (end := p.one(which, "which"))]
        told = [(*place, theme, last) for place, end in whose for theme, subject in simple(p, end)
                for last in STANDS_THERE.matches(p, subject)]  # fmt: skip
        for theme, end in (x for that in _THAT.matches(p, k) for x in simple(p, that)):
            told += [(rel, mods, theme, last) for stands in STANDS_THERE.matches(p, end)
                     for (rel, mods), last in relation(p, stands)]  # fmt: skip
        for rel, mods, theme, last in told:
            there = Loc(rel=rel, landmark=mark, mods=mods, span=p.span(i, last))
            places = (there, replace(there, landmark=other, negated=True)) if other is not None else (there,)
            for said, end in _told(p, i, last, theme, there, mode):
                yield replace(said, adjuncts=places), end


_AND_NOT = (", not", ", and not", "and not", "rather than", ", rather than", "instead of")


def _marks(p: Parser, j: int) -> list[tuple[Meaning, Noun | None, int]]:
    """A block, and another that it is said not to be: "the red block, not the blue one,"."""
    found: list[tuple[Meaning, Noun | None, int]] = []
    for mark, k in simple(p, j):
        found.append((mark, None, k))
        for other, end in simple(p, denied) if (denied := p.any_of(k, _AND_NOT)) else ():
            if isinstance(other, Noun):
                found += [(mark, other, last) for last in {end: None, p.opt(end, ","): None}]
    return found


def _told(p: Parser, i: int, end: int, theme: Meaning, place: Meaning, mode: str) -> Results[Clause]:
    mark = place.landmark if isinstance(place, Loc) else None
    if isinstance(theme, Noun) and theme.head != "patch" and (mark is None or isinstance(mark, Noun)):
        yield Clause(verb="be", theme=theme, adjuncts=(place,), mode=mode, span=p.span(i, end)), end
