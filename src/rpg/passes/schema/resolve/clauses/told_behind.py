"""Facts behind an order: "Swap red and blue. Red is on the patch" may be of before or after; "Move the block that is on
blue. Red is on blue" says which block that is, and "Put red on the table. It is on the mat" where it was."""

from __future__ import annotations

import re

from rpg.language.meaning import (
    Chain,
    Clause,
    Loc,
    Meaning,
    Noun,
    Pronoun,
    TableTop,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.joined_facts import moves
from rpg.passes.schema.resolve.things.world import refuse

_WHEN = re.compile(
    r"\b(?:must|should|shall|has to|have to|needs? to|will|end|final|finally|then|afterwards|start|initially|"
    r"beginning|at first|currently|already|result|so that)\b",
    re.IGNORECASE,
)


_BOTH = frozenset({"they", "both", "both of them", "these", "the two"})
_SAY = "say 'at the start' or 'in the end'"


def told_behind(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """The sentences with a fact that says which block an order before it is about, or where it was, told of the
    start."""
    found: list[Chain] = []
    order: Meaning | None = None
    for n, chain in enumerate(chains):
        clauses: list[Meaning] = []
        for link, said in zip(chain.links, chain.clauses, strict=True):
            if not isinstance(said, Clause) or (said.lemma, said.mode) != ("fact", "goal") or link == "then":
                order = said
            elif order is not None and _WHEN.search(text[order.span[1] : said.span[1]]) is None:
                before = isinstance(order, Clause) and _before_it(order, said)
                said = replace(said, mode="start") if before else _begun(said, chains[:n])
            clauses.append(said)
        found.append(replace(chain, clauses=tuple(clauses)) if tuple(clauses) != chain.clauses else chain)
    return tuple(found)


def _before_it(order: Clause, fact: Clause) -> bool:
    """Whether it is so before the order: "swap them, they are next to each other", "put it on the table. It is on the
    mat".

    Raises:
        Refusal: it may be so before or after.
    """
    if order.mode != "command" or order.negated or fact.negated:
        return False
    if order.verb == "swap":
        if isinstance(fact.theme, Pronoun) and fact.theme.word in _BOTH:
            return True
        named = {look for part in parts_of(order) if isinstance(part, Noun) for look in _looks(part)}
        if isinstance(fact.theme, Noun) and named.intersection(_looks(fact.theme)):
            raise refuse("ambiguous", "is this so before they are swapped, or afterwards?", fact.span, _SAY)
    if order.verb != "place" or not moves(order, fact):
        return False
    bases = [x.landmark for x in (*order.adjuncts, *fact.adjuncts) if isinstance(x, Loc)]
    one = any(isinstance(x, TableTop) for x in bases) or len({getattr(x, "head", "") == "patch" for x in bases}) == 1
    if one and isinstance(fact.theme, Pronoun):
        return True  # it cannot be on both
    raise refuse("ambiguous", "is this so before it is moved, or afterwards?", fact.span, _SAY)


def _looks(noun: Noun) -> tuple[str, ...]:
    return (*noun.traits.colors, *noun.traits.labels)


def _begun(fact: Meaning, before: tuple[Chain, ...]) -> Meaning:
    place = fact.adjuncts[0] if isinstance(fact, Clause) and len(fact.adjuncts) == 1 and not fact.negated else None
    told = fact.theme if isinstance(fact, Clause) else None
    if not isinstance(place, Loc) or not isinstance(told, Noun) or told.traits == Traits():
        return fact
    which = (part for chain in before for part in parts_of(chain) if isinstance(part, Noun) and part.conditions)
    same = any(
        noun.traits == Traits() and noun.det == "the" and _same(condition, place)
        for noun in which
        for condition in noun.conditions
    )
    return replace(fact, mode="start") if same and isinstance(fact, Clause) else fact


def _same(condition: Meaning, place: Loc) -> bool:
    """Whether a relative clause says of a block what the fact says."""
    marks = [x.landmark if isinstance(x, Loc) else None for x in (condition, place)]
    looks = [(x.head == "patch", x.traits) if isinstance(x, Noun) else None for x in marks]
    return isinstance(condition, Loc) and condition.rel == place.rel and looks[0] is not None and looks[0] == looks[1]
