""" "There are three red blocks. At the start there is a tower of two red blocks": two of these, and no others."""

from __future__ import annotations

from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    Coord,
    Loc,
    Manner,
    Meaning,
    Noun,
    Structure,
    Traits,
    Using,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse

_FURTHER = frozenset({"also", "another", "other", "others", "more", "further", "additional", "besides", "too"})
"""Words of blocks that come on top of those that are there."""


def begun_of_stock(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """The sentences with the blocks of the start told of those that were counted before."""
    stock: dict[Traits, int] = {}
    found = []
    for chain in chains:
        clauses = []
        for clause in chain.clauses:
            if isinstance(clause, Clause) and _FURTHER.isdisjoint(text[slice(*clause.span)].lower().split()):
                clause = _of_these(clause, stock)
                stock |= {noun.traits: _many(noun) for noun in _counted(clause)}
            clauses.append(clause)
        found.append(replace(chain, clauses=tuple(clauses)))
    return chains if found == [*chains] else tuple(found)


def _counted(clause: Clause) -> list[Noun]:
    """The lots of blocks that a clause tells to be there, and no more."""
    if clause.verb != "exist" or clause.mode != "given" or clause.adjuncts or clause.negated:
        return []
    items = clause.theme.items if isinstance(clause.theme, Coord) and clause.theme.op == "and" else (clause.theme,)
    return [x for x in items if isinstance(x, Noun) and _plain(x)]


def _plain(noun: Noun) -> bool:
    """Whether so many blocks of one look are named, and nothing else is told of them."""
    exact = noun.amount is not None and noun.amount.low == noun.amount.high
    look = noun.traits == Traits(colors=noun.traits.colors) and len(noun.traits.colors) == 1
    named = noun.head in ("block", "any") and noun.det in ("bare", "a")
    return exact and look and named and not (noun.part_of or noun.conditions)


def _many(noun: Noun) -> int:
    return noun.amount.low if noun.amount is not None else 0


def _of_these(clause: Clause, stock: dict[Traits, int]) -> Clause:
    """A clause that tells of the start, with its blocks told of the stock."""
    shape = clause.theme if isinstance(clause.theme, Structure) else None
    if shape is not None and shape.members and clause.mode in ("start", "given") and clause.verb in ("exist", "be"):
        return replace(clause, theme=replace(shape, members=_drawn(shape.members, stock)))
    if not _begun(clause):
        return clause
    adjuncts = []
    for part in clause.adjuncts:
        if isinstance(part, Using):
            part = replace(part, members=_drawn(part.members, stock))
        if isinstance(part, Loc) and part.landmark is not None:
            part = replace(part, landmark=_drawn(part.landmark, stock))
        adjuncts.append(part)
    theme = _drawn(clause.theme, stock) if clause.theme is not None else None
    return replace(clause, theme=theme, adjuncts=tuple(adjuncts))


def _begun(clause: Clause) -> bool:
    """Whether a clause tells how blocks are at the start, and not only that they are there."""
    timed = any(isinstance(part, Manner) and part.kind == "start" for part in clause.adjuncts)
    return clause.mode == "start" or (clause.mode == "given" and (timed or clause.lemma == "begun"))


def _drawn(told: Meaning, stock: dict[Traits, int]) -> Meaning:
    """Blocks of which so many were counted before: these, or some of these.

    Raises:
        Refusal: there are fewer.
    """
    if isinstance(told, Coord):
        return replace(told, items=tuple(_drawn(item, stock) for item in told.items))
    if not isinstance(told, Noun) or not _plain(told) or (there := stock.get(told.traits)) is None:
        return told
    if _many(told) > there:
        raise refuse("count-mismatch", f"there are only {there} of these, but {_many(told)} are told of", told.span,
                     f"say {there}, or count them all", there=there)  # fmt: skip
    these = replace(told, det="the", amount=Amount(there, there) if there > 1 else None, plural=there > 1)
    return these if _many(told) == there else replace(told, det="some", traits=Traits(), part_of=these)
