"""A row that a command takes for granted: "put the second block from the left at the right end of the row", of which
nobody told before."""

from __future__ import annotations

import re

from rpg.language.meaning import Amount, Chain, Clause, Meaning, Noun, Structure, Traits, parts_of

Told = tuple[list[str], tuple[Chain, ...], tuple[str, ...]]

_USUAL = 4
"""So many blocks has a row of which it is not said how many it has."""
_WITH_MIDDLE = 3
_PLACING = ("place", "use", "pick", "swap", "stack", "reverse")
_SIDES = ("left", "right")
_COUNTED_FROM = ("", *_SIDES, "last")
_PLACES = ("left", "right", "middle", "first", "last")
_LINES = ("row", "line")
_IN_LINE = re.compile(r"\b(?:row|line)\b", re.I)


def row_granted(links: list[str], chains: tuple[Chain, ...], text: str) -> Told | None:
    """The sentences behind one that says that the row is there, with what is assumed of it; None where no row is taken
    for granted, or blocks are spoken of that are told otherwise than by their places in it."""
    clauses = tuple(clause for chain in chains for clause in chain.clauses)
    if not all(isinstance(c, Clause) and c.mode == "command" and c.verb in _PLACING for c in clauses):
        return None
    parts = parts_of(clauses)
    blocks = [part for part in parts if isinstance(part, Noun) and part.head != "patch"]
    ranks = [rank for noun in blocks if (rank := _place(noun))]
    reversed_ = [c.theme for c in clauses if isinstance(c, Clause) and c.verb == "reverse"]
    whole = bool(reversed_) and all(isinstance(x, Structure) for x in reversed_)
    if not (ranks or whole) or len(ranks) < len(blocks) or not all(map(_known, parts)):
        return None
    if not _IN_LINE.search(text) and not any(side in rank.split() for rank in ranks for side in _SIDES):
        return None
    counts = [int(rank.split()[0]) for rank in ranks if rank.split()[0].isdigit()]
    many = max([_WITH_MIDDLE if "middle" in ranks else _USUAL, *counts])
    many += "middle" in ranks and many % 2 == 0
    span = blocks[0].span if blocks else clauses[0].span
    members = Noun(head="block", amount=Amount(many, many), plural=True, span=span)
    row = Structure(kind="row", det="a", amount=Amount(1, 1), members=members, span=span)
    given = Clause(verb="exist", mode="given", theme=row, span=span)
    notes = ("a row is there at the start", f"how many blocks the row has is not said: {many}")
    return ["and", *links], (Chain(clauses=(given,), links=("and",), span=span), *chains), notes


def _place(noun: Noun) -> str:
    """Where in a row a block stands, if that is all that is told of it."""
    rank = noun.traits.rank or ""
    first, _, side = rank.partition(" ")
    counted = first.isdigit() and side in _COUNTED_FROM
    plain = noun.traits == Traits(rank=rank) and noun.det == "the" and not noun.plural and noun.part_of is None
    return rank if plain and (rank in _PLACES or counted) else ""


def _known(part: Meaning) -> bool:
    """Whether this is no structure, or the row that is taken for granted."""
    if not isinstance(part, Structure):
        return True
    plain = part.members is None and part.size is None and not part.dims and not part.details
    return plain and part.kind in _LINES and part.det == "the" and not part.plural and part.traits == Traits()
