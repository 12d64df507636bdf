""" "First take red and put it on blue, then ...": what is taken up and where it is put are one step; "each is on the
red mat or on the green mat": what each may do is one thing, too."""

from __future__ import annotations

from itertools import pairwise

from rpg.language.meaning import Chain, Clause, Coord, Loc, Manner, Meaning, Noun, Pronoun, replace
from rpg.passes.schema.resolve.things.world import refuse

_PUTS = frozenset({"place", "stack"})
_IT = frozenset({"it", "them", "both", "both of them"})


def put_at_once(chain: Chain) -> Chain:
    """Where steps follow each other, what is taken up and put somewhere as the one step that it is."""
    if not _in_time(chain):
        return chain
    clauses: list[Meaning] = []
    links: list[str] = []
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        before = clauses[-1] if clauses else None
        if isinstance(clause, Clause) and isinstance(before, Clause) and _puts_it(before, link, clause):
            clauses[-1] = replace(clause, theme=before.theme)
        else:
            clauses.append(clause)
            links.append(link)
    return replace(chain, clauses=tuple(clauses), links=tuple(links))


def each_by_itself(chain: Chain) -> Chain:
    """ "Each of the three is on the red mat or on the green mat": one may be here and another there."""
    clauses: list[Meaning] = []
    links: list[str] = []
    for link, clause in zip(chain.links, chain.clauses, strict=True):
        joined = _either(clauses[-1], clause) if clauses and link == "or" else None
        if joined is not None:
            clauses[-1] = joined
        else:
            clauses.append(clause)
            links.append(link)
    return replace(chain, clauses=tuple(clauses), links=tuple(links))


def _either(one: Meaning, other: Meaning) -> Clause | None:
    """The clause that says of each that it is at one of two places; None where these are not of one kind."""
    if not isinstance(one, Clause) or not isinstance(other, Clause) or not isinstance(one.theme, Noun):
        return None
    again = isinstance(other.theme, Pronoun) and other.theme.word == "same"
    if one.theme.det != "each" or not again or one.negated or other.negated:
        return None
    here = one.adjuncts[0] if len(one.adjuncts) == 1 else None
    there = other.adjuncts[0] if len(other.adjuncts) == 1 else None
    mark = here.landmark if isinstance(here, Loc) else None
    if isinstance(here, Loc) and isinstance(there, Loc) and mark is not None and there.landmark is not None:
        alike = replace(here, landmark=there.landmark, span=there.span) == there
        marks = mark.items if isinstance(mark, Coord) and mark.op == "or" else (mark,)
        either = Coord(op="or", items=(*marks, there.landmark), span=here.span)
        if alike:
            return replace(one, adjuncts=(replace(here, landmark=either),))
    raise refuse("ambiguous", "each of them as it likes, or all in the same way?", other.span, "say it of each by name")


def _in_time(chain: Chain) -> bool:
    """Whether anything is told of what comes before what."""
    timed = (a for c in chain.clauses if isinstance(c, Clause) for a in c.adjuncts if isinstance(a, Manner))
    return not {"then", "before", "after"}.isdisjoint(chain.links) or any(a.kind == "time" for a in timed)


def _puts_it(taken: Clause, link: str, clause: Clause) -> bool:
    bare = taken.verb == "pick" and not taken.adjuncts and not taken.negated and taken.theme is not None
    it = isinstance(clause.theme, Pronoun) and clause.theme.word in _IT
    return bare and link == "and" and clause.verb in _PUTS and it and not clause.negated


def named_ahead(chain: Chain) -> Chain:
    """ "There shall be a blue cube, and on it a yellow one": it only has to be there for what is told of it."""
    clauses = list(chain.clauses)
    for n, (one, behind) in enumerate(pairwise(clauses)):
        named = isinstance(one, Clause) and one.verb == "exist" and one.mode == "goal" and not one.lemma
        if not named or not isinstance(one, Clause) or one.negated or one.adjuncts or not isinstance(behind, Clause):
            continue
        marks = [place.landmark for place in behind.adjuncts if isinstance(place, Loc)]
        if chain.links[n + 1] == "and" and any(isinstance(mark, Pronoun) and mark.word == "it" for mark in marks):
            clauses[n] = replace(one, mode="given")
    return replace(chain, clauses=tuple(clauses))
