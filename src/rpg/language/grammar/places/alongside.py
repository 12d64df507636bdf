"""Blocks one beside the other: "red, to the right of it blue, then to the right of that green"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.places.onto import single
from rpg.language.grammar.places.prepositions import relation
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Chain, Clause, Loc, Meaning, Noun, Pronoun, That, replace

_AND = (", and then", "and then", ", then", "then", ", and", "and", ",", ";")
_THAT = frozenset({"it", "that", "this"})
_RELATIONS = ("left", "right", "front", "behind", "beside", "adjacent", "touching")
_COMMANDS = ("first put", "first place", "put", "place", "first", "i want", "start with", "first there is")
_STANDS = ("is", "goes", "comes", "stands", "there is", "put", "place", ":")
_MARKED = frozenset({"it", "that", "this", "its"})
_BEGUN = frozenset({":", ";", ".", "and", "then", "please"})
MOST = 8


@choice
def alongside(p: Parser, i: int) -> Results[Clause]:
    """Each is placed by the one named before it. "It" is that one, too, where "then" tells that the line goes on."""
    # behind a place ("on its right a blue block, and behind it ...") each is placed by what that is a place of
    if not p.anywhere(_MARKED) or (i and not p.follows(i, _BEGUN)):
        return
    for first, j in simple(p, p.any_of(i, _COMMANDS) or i):
        if not isinstance(first, Noun) or not single(first):
            continue
        for told, k in _next(p, j, first, ()):
            rest = Chain(clauses=told[1:], links=("and",) * (len(told) - 1), span=p.span(j, k))
            so = (That(kind="so", clauses=rest, span=rest.span),) if len(told) > 1 else ()
            yield replace(told[0], adjuncts=(*told[0].adjuncts, *so), span=p.span(i, k), cost=1), k


def _next(p: Parser, i: int, last: Noun, had: tuple[Clause, ...]) -> Results[tuple[Clause, ...]]:
    joint = p.any_of(i, _AND)
    for one, side, k in _one_beside(p, joint) if joint and len(had) < MOST else ():
        if not isinstance(one, Noun) or not single(one):
            continue
        if had and side.landmark is not None and p.words[joint - 1] != "then":
            continue
        mark = replace(last, det="the", amount=None, cost=0) if had else last
        place = replace(side, landmark=mark)
        told = (*had, Clause(verb="be", theme=one, adjuncts=(place,), mode="goal", span=p.span(joint, k)))
        yield told, k
        yield from _next(p, k, one, told)


def _one_beside(p: Parser, i: int) -> Iterator[tuple[Meaning, Loc, int]]:
    """ "to the right of it blue", "blue to the right of it"."""
    for side, j in _beside(p, i):
        yield from ((one, side, k) for one, k in simple(p, p.any_of(j, _STANDS) or j))
    for one, j in simple(p, i):
        yield from ((one, side, k) for side, k in _beside(p, j))


def _beside(p: Parser, i: int) -> Results[Loc]:
    """ "to the right of it", "next to that"; the landmark is left in where it is "it"."""
    its = p.any_of(i, ("to its", "on its", "at its"))
    if its and p.stands(its, ("left", "right")):
        owner = Pronoun(word="it", span=p.span(its - 1, its))
        end = p.any_of(its + 1, ("side", "hand side")) or its + 1
        yield Loc(rel=p.words[its], landmark=owner, span=p.span(i, end)), p.reach(end)
    for (name, mods), j in relation(p, i):
        if name in _RELATIONS and p.stands(j, _THAT):
            it = Pronoun(word="it", span=p.span(j, j + 1)) if p.words[j] == "it" else None
            yield Loc(rel=name, landmark=it, mods=mods, span=p.span(i, j + 1)), p.reach(p.opt(j + 1, "one"))
