""" "The blue block is on the mat, and the red one should be there too": what is so, and in one sentence with it what
should be so."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

from rpg.language.meaning import (
    Chain,
    Clause,
    Coord,
    In,
    Into,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Toward,
    Traits,
    replace,
)
from rpg.passes.schema.resolve.clauses.joined_facts import BESIDES, asks, how_far_off, moves, same_one, same_spot
from rpg.passes.schema.resolve.clauses.same_at_the_end import (
    SHOULD,
    definite,
    known_by_then,
    made_so,
    of_a_part,
    of_these,
)
from rpg.passes.schema.resolve.things.world import refuse


def wished_beside(chains: Sequence[Chain], n: int, text: str) -> Chain | None:
    """The sentence, with its facts told of the start, and of the end as well where nothing is to be elsewhere; None
    where it is told otherwise."""
    chain, after = chains[n], chains[n + 1 : n + 2]
    asked = [False, *(asks(text[a.span[1] : b.span[0]]) for a, b in pairwise(chain.clauses))]
    told = [_fact(c, text) and not wanted for c, wanted in zip(chain.clauses, asked, strict=True)]
    count = told.index(False) if False in told else len(told)
    wish = (*chain.clauses, *(c for x in after for c in x.clauses), None)[count]
    if not count or not isinstance(wish, Clause) or wish.mode != "goal":
        return None
    facts = tuple(c for c in chain.clauses[:count] if isinstance(c, Clause))
    said = text[facts[-1].span[1] : wish.span[1]]
    joined = _JOINED if count == len(chain.clauses) else _BEHIND  # "It should be." goes on with the sentence before
    wished = SHOULD.search(said) is not None or asks(text[facts[-1].span[1] : wish.span[0]])
    if not joined.match(said) or {*chain.links[: count + 1]} != {"and"} or not wished:
        return None
    begun: tuple[Meaning, ...] = tuple(replace(c, mode="start") for c in facts)
    if _RELATIVE.search(said):
        return None
    if not any(_changes(fact, wish) for fact in facts):
        if wish.negated or any(x.negated or of_these(wish, x) or not definite(x) for x in facts) or of_a_part(wish):
            return None
        pair = [Chain(clauses=x, links=("and",) * len(x), span=chain.span) for x in (facts, (wish,))]
        if how_far_off(pair):
            return None
        _check_instead(facts, wish, text)
        begun = (*begun, *map(known_by_then, facts))
    rest = chain.links[count:]
    return replace(chain, clauses=(*begun, *chain.clauses[count:]), links=(*("and" for _ in begun), *rest))


def _changes(fact: Clause, wish: Clause) -> bool:
    """Whether a block is on one thing and should be on another, or is not where it should be, or should not be where it
    is; or whether only some of those that are somewhere should be there."""
    there, here = ([x for x in c.adjuncts if isinstance(x, Loc | In)] for c in (fact, wish))
    if len(there) == len(here) == 1 and same_spot(there[0], here[0]):
        some = not (fact.negated or wish.negated) and _only_some(wish)
        return some or (same_one(fact, wish) and fact.negated != wish.negated)
    return not fact.negated and not wish.negated and moves(fact, wish)


def _only_some(wish: Clause) -> bool:
    """ "(A, B and C are on the mat.) Only A should be", "at most two should be", "none of them should be"."""
    theme = wish.theme
    if isinstance(theme, Coord):
        return theme.op == "only"
    of_them = isinstance(theme, Noun) and (theme.head, theme.traits) == ("any", Traits())
    return isinstance(theme, Noun) and of_them and (theme.amount is not None or theme.part_of is not None)


def _check_instead(facts: Sequence[Clause], wish: Clause, text: str) -> None:
    """ "Red is on the mat, but blue should be there": instead of it, or with it?"""
    said = _STOP.split(text[facts[-1].span[1] :])[0].strip(" ,;")
    if not said.lower().startswith("but") or BESIDES.search(said):
        return
    there, here = ([x for c in told for x in c.adjuncts if isinstance(x, Loc | In)] for told in (facts, (wish,)))
    if any(same_spot(x, y) for x in there for y in here):
        raise refuse("ambiguous", "is what lies there now to stay, or to make room?", wish.span,
                     "say 'as well' or 'instead'")  # fmt: skip


def _fact(clause: Meaning, text: str) -> bool:
    """Whether a clause says where something is, and not how that should be, or how it looks."""
    if not isinstance(clause, Clause) or clause.mode != "goal":
        return False
    said = text[slice(*clause.span)]
    placed = all(isinstance(x, Loc | In | Into | OrderBy | Toward) for x in clause.adjuncts)
    made = made_so(Chain(clauses=(clause,), links=("and",), span=clause.span), said)
    return SHOULD.search(said) is None and (made or (clause.lemma == "fact" and placed))


_STOP = re.compile(r"[.!?]")
_JOINED = re.compile(r"\s*(?:[,;]|[-–—] |and\b|but\b)", re.IGNORECASE)
_BEHIND = re.compile(r"\s*(?:[,;.]|[-–—] |and\b|but\b)", re.IGNORECASE)
_RELATIVE = re.compile(r"\b(?:which|who|whose|that|where)\b", re.IGNORECASE)
