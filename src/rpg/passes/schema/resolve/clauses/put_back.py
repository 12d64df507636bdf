""" "Red starts on blue. Put it on the table, then put it back": where it was told to be before it is first moved."""

from __future__ import annotations

import re
from itertools import pairwise

from rpg.language.grammar.clauses.put_back import WHERE_IT_WAS
from rpg.language.meaning import Chain, Clause, In, Loc, Meaning, Noun, Pronoun, TableTop, replace
from rpg.passes.schema.resolve.clauses.joined_facts import moves
from rpg.passes.schema.resolve.things.world import refuse

_MOVED = ("place", "stack", "pick", "use")
_BACK = re.compile(r"\b(?:back|returns?|returned)\b", re.IGNORECASE)


def put_back(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """The sentences, with the place that something is put back to; facts of where it was are of the start."""
    chains = tuple(off_again(chain, text) for chain in chains)
    chains, was = _no_longer(chains, text)
    if _BACK.search(text) is None:
        return chains
    found = [list(chain.clauses) for chain in chains]
    moved: dict[tuple[object, ...], int] = {}
    left = {*was}
    last: tuple[object, ...] = ()
    for n, clauses in enumerate(found):
        for k, clause in enumerate(clauses):
            if not isinstance(clause, Clause) or clause.negated:
                continue
            one = _one(clause.theme) or (last if getattr(clause.theme, "word", "") in ("it", "same") else ())
            last = one or last
            place, fact = was.get(one, (None, None))
            if _back(clause):
                if place is None or moved.get(one, 0) > 1:
                    raise refuse("no-goal", "it is not said where it was", clause.span, "say where to put it")
                clauses[k] = replace(clause, lemma="put", adjuncts=(replace(place, span=clause.adjuncts[0].span),))
            there = place is not None and not moved.get(one) and one not in left
            if place is not None and there and (_told_there(clause, place, text) or (_back(clause) and fact is None)):
                raise refuse("ambiguous", "it is said to be there at the start", clause.span,
                             "say where it is before it is put there")  # fmt: skip
            if _back(clause) or (_returns(clause, place) and _BACK.search(text[slice(*clause.span)]) is not None):
                if fact is not None and isinstance(told := found[fact[0]][fact[1]], Clause):
                    found[fact[0]][fact[1]] = replace(told, mode="start")
                continue
            if one and clause.verb in _MOVED and clause.mode in ("command", "goal"):
                off = _off(clause)
                if off is not None and one not in was:
                    was[one] = (off, None)
                moved[one] = moved.get(one, 0) + (not any(getattr(x, "rel", "") == "off" for x in clause.adjuncts))
            elif one and one not in was and (spot := _place(clause)) is not None:
                was[one] = (spot, (n, k) if clause.mode == "goal" else None)
    return tuple(replace(chain, clauses=tuple(clauses)) for chain, clauses in zip(chains, found, strict=True))


_Was = dict[tuple[object, ...], tuple[Meaning, tuple[int, int] | None]]
"""Where blocks were, and which clause says so where that is to be told of the start."""


def _no_longer(chains: tuple[Chain, ...], text: str) -> tuple[tuple[Chain, ...], _Was]:
    """ "Red was on the mat and is now on blue. Put it back": where it was is before the start; the sentences without
    that, and where it was."""
    at = [(n, k) for n, chain in enumerate(chains) for k in range(len(chain.clauses))]
    was: _Was = {}
    gone: list[tuple[int, int]] = []
    now: list[tuple[int, int]] = []
    for (n, k), (m, j) in pairwise(at[:-1]):  # something is to be done behind it
        told, since = chains[n].clauses[k], chains[m].clauses[j]
        if not isinstance(told, Clause) or not isinstance(since, Clause) or told.mode != "start":
            continue
        past = _PAST.search(text[slice(*told.span)]) is not None
        here = _NOW.search(text[told.span[1] : since.span[1]]) is not None and since.mode in ("goal", "start")
        if past and here and moves(told, since) and (one := _one(told.theme)) and (place := _place(told)) is not None:
            was[one] = (place, None)
            gone.append((n, k))
            now.append((m, j))
    if not gone:
        return chains, was
    left: list[Chain] = []
    for n, chain in enumerate(chains):
        kept = [k for k in range(len(chain.clauses)) if (n, k) not in gone]
        clauses = tuple(_there_now(chain.clauses[k], chains, (n, k), gone, now) for k in kept)
        left += [replace(chain, clauses=clauses, links=("and", *(chain.links[k] for k in kept[1:])))] if kept else []
    return tuple(left), was


def _there_now(
    clause: Meaning, chains: tuple[Chain, ...], at: tuple[int, int], gone: list[tuple[int, int]],
    now: list[tuple[int, int]],
) -> Meaning:  # fmt: skip
    """What is said of where it is now, by its name instead of "it"."""
    if at not in now or not isinstance(clause, Clause):
        return clause
    n, k = gone[now.index(at)]
    return replace(clause, theme=getattr(chains[n].clauses[k], "theme", None), mode="start")


_PAST = re.compile(r"\b(?:was|were|had been)\b", re.IGNORECASE)
_NOW = re.compile(r"\bnow\b", re.IGNORECASE)


def _back(clause: Meaning) -> bool:
    mark = clause.adjuncts[0] if isinstance(clause, Clause) and clause.adjuncts else None
    there = mark.landmark if isinstance(mark, Loc) else None
    return isinstance(there, Pronoun) and there.word == WHERE_IT_WAS


def _returns(clause: Clause, place: Meaning | None) -> bool:
    """Whether a clause names the very place where it was."""
    known = [(x.rel, getattr(x.landmark, "head", ""), getattr(x.landmark, "traits", None))
             for x in (place, *clause.adjuncts) if isinstance(x, Loc)]  # fmt: skip
    return isinstance(place, Loc) and len(known) == len(clause.adjuncts) + 1 == 2 and known[0] == known[1]


def _one(theme: Meaning | None) -> tuple[object, ...]:
    """What a single block is known by."""
    if not isinstance(theme, Noun) or theme.plural or theme.head == "patch" or theme.part_of is not None:
        return ()
    return (theme.traits,)


def _place(clause: Clause) -> Meaning | None:
    """Where a clause says that something is, or is at the start."""
    told = clause.mode == "start" or (clause.verb, clause.mode) == ("exist", "given")
    told = told or (clause.lemma, clause.mode) == ("fact", "goal")
    places = [x for x in clause.adjuncts if isinstance(x, Loc | In) and not x.negated]
    if not told or len(places) != 1 or clause.verb not in ("be", "exist", "place", "stack"):
        return None
    return _known(places[0])


def _off(clause: Clause) -> Meaning | None:
    """What something is taken off."""
    places = [x for x in clause.adjuncts if isinstance(x, Loc) and x.rel == "off" and not x.negated]
    named = len(places) == 1 and isinstance(places[0].landmark, Noun | TableTop)
    return _known(replace(places[0], rel="on", mods=())) if named else None


def _known(place: Meaning) -> Meaning:
    mark = place.landmark if isinstance(place, Loc) else None
    if isinstance(place, Loc) and isinstance(mark, Noun) and mark.det == "a":
        return replace(place, landmark=replace(mark, det="the", amount=None))
    return place


def off_again(chain: Chain, text: str) -> Chain:
    """ "Put red on the mat, take it off again, ...", "... and put it back on blue": one after the other, for not
    both can be so at once."""
    links = list(chain.links)
    for n, (put, taken) in enumerate(pairwise(chain.clauses), 1):
        if not isinstance(put, Clause) or not isinstance(taken, Clause) or links[n] != "and":
            continue
        done = put.verb in ("place", "stack") and put.mode == taken.mode == "command"
        there = [x for x in put.adjuncts if isinstance(x, Loc) and x.rel == "on" and not x.negated]
        off = [x for x in taken.adjuncts if isinstance(x, Loc) and x.rel == "off"]
        it = isinstance(taken.theme, Pronoun) and taken.theme.word == "it" and bool(_one(put.theme))
        it = it or (bool(_one(put.theme)) and _one(put.theme) == _one(taken.theme))
        again = len(there) == len(off) == 1 or (_placed(taken) and _BACK.search(text[slice(*taken.span)]) is not None)
        if done and it and again and not (put.negated or taken.negated):
            links[n] = "then"
    return replace(chain, links=tuple(links)) if tuple(links) != chain.links else chain


def _placed(clause: Clause) -> bool:
    return len(clause.adjuncts) == 1 and isinstance(clause.adjuncts[0], Loc | In)


def _told_there(clause: Clause, place: Meaning, text: str) -> bool:
    """ "Red was on blue. Put it back on blue.": where it is by then is not said."""
    asked = clause.mode in ("command", "goal") and clause.verb in _MOVED and _returns(clause, place)
    return asked and _BACK.search(text[slice(*clause.span)]) is not None
