"""Orders in time that are told around clauses: "in this order: ...", "first ..., second ...", "at the end put ..."."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rpg.language.meaning import Chain, Clause, Coord, Meaning, Noun, OrderBy, Traits, parts_of, replace
from rpg.passes.schema.resolve.clauses.first_or_begun import check_begun_or_first

_AHEAD = re.compile(
    r"\b(?:in (?:this|that|the following|exactly this|this exact|the given)? ?(?:order|sequence)|step by step)"
    r"\s*[:,-]\s*$",
    re.IGNORECASE,
)
"""What stands before steps that are done one after the other."""
_LAST = re.compile(r"\b(?:at|in) the (?:very )?end\W*$", re.IGNORECASE)
"""What stands before a step that comes after the others: where something is at the end is no step."""
_COUNTED = "(?:row|line|column|tower|stack|pile|group|word)"
"""These are counted, and are no steps: "first tower: ..., second tower: ..."."""
_RANKS = ("first", "second", "third", "fourth", "fifth", "sixth")


def in_told_order(links: Sequence[str], chains: tuple[Chain, ...], text: str) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences, with "then" between the clauses that such words put in order."""
    check_begun_or_first(links, chains, text)
    steps = [clause for chain in chains for clause in chain.clauses]
    listed = all(map(_step, steps)) and _AHEAD.search(text[: steps[0].span[0]]) is not None
    if listed and len(steps) == 1:
        return list(links), (_in_order(chains[0]),)
    ranks = [_rank(clause, text[before:]) for clause, before in zip(steps, _gaps(chains), strict=True)]
    counted = len(steps) > 1 and ranks == list(range(len(steps)))
    found, joined, n = [], list(links), 0
    for m, chain in enumerate(chains):
        clauses: list[Meaning] = []
        inner = list(chain.links)
        for k, clause in enumerate(chain.clauses):
            gap = text[_gaps(chains)[n] : clause.span[0]]
            ended = _ordered(clause) and any(map(_ordered, steps[:n])) and _LAST.search(gap) is not None
            if n > 0 and (listed or counted or ended):
                if k:
                    inner[k] = "then" if inner[k] == "and" else inner[k]
                else:
                    joined[m] = "then" if joined[m] == "and" else joined[m]
            clauses.append(_unranked(clause) if counted else clause)
            n += 1
        found.append(replace(chain, clauses=tuple(clauses), links=tuple(inner)))
    return joined, tuple(found)


def _in_order(chain: Chain) -> Chain:
    """ "In this order: red, green and blue on the mat": a single clause, in whose list that order is."""
    clause = chain.clauses[0]
    if not isinstance(clause, Clause) or any(isinstance(part, OrderBy) for part in parts_of(clause)):
        return chain
    lists = [part for part in parts_of(clause) if isinstance(part, Coord) and part.op == "and"]
    if len(lists) != 1 or not all(isinstance(item, Noun) for item in lists[0].items):
        return chain
    given = OrderBy(by="given", span=clause.span)
    return replace(chain, clauses=(replace(clause, adjuncts=(*clause.adjuncts, given)),))


def _gaps(chains: tuple[Chain, ...]) -> list[int]:
    """Where the words begin that stand before each clause."""
    ends = [clause.span[1] for chain in chains for clause in chain.clauses]
    return [0, *ends[:-1]]


def _step(clause: Meaning) -> bool:
    return isinstance(clause, Clause) and clause.mode in ("command", "goal") and clause.verb != "exist"


def _ordered(clause: Meaning) -> bool:
    """Whether a verb of its own commands something."""
    told = isinstance(clause, Clause) and clause.mode == "command" and not clause.negated
    return told and isinstance(clause, Clause) and clause.word is not None and clause.word[0] == clause.span[0]


def _rank(clause: Meaning, said: str) -> int | None:
    """Which step a clause is, "second the green block goes ...", "second green goes ..."."""
    theme = clause.theme if isinstance(clause, Clause) else None
    bare = isinstance(theme, Noun) and theme.det == "bare" and not theme.plural
    if isinstance(theme, Noun) and bare and theme.traits.rank is not None and theme.traits.rank.isdigit():
        return int(theme.traits.rank) - 1
    begun = re.match(rf"\W*(?:and )?(\w+?)(?:ly)?\b(?!\s+{_COUNTED}\b)", said)
    word = begun.group(1).lower() if begun and _step(clause) else ""
    return _RANKS.index(word) if word in _RANKS else None


def _unranked(clause: Meaning) -> Meaning:
    theme = clause.theme if isinstance(clause, Clause) else None
    if not isinstance(clause, Clause) or not isinstance(theme, Noun) or theme.det != "bare":
        return clause
    traits: Traits = replace(theme.traits, rank=None)
    return replace(clause, theme=replace(theme, traits=traits))
