"""Lines of so many blocks which are named one by one behind them: "a row of four cubes. Red is left of blue, ..."."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.meaning import (
    Amount,
    At,
    Chain,
    Clause,
    Coord,
    Loc,
    Meaning,
    Noun,
    Structure,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse

_WITHIN = {
    "row": frozenset({"left", "right", "next", "beside", "adjacent", "between"}),
    "line": frozenset({"left", "right", "behind", "front", "next", "beside", "adjacent", "between"}),
    "column": frozenset({"behind", "front", "next", "beside", "adjacent", "between"}),
    "stack": frozenset({"on", "above", "under", "between"}),
}
"""What may be told of blocks of the same line."""
_FEWEST = 3


def members_later(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with the line made of the blocks that are named; others may be some of it, or further ones."""
    clauses = [c for chain in chains for c in chain.clauses]
    first = clauses[0] if clauses else None
    shape = first.theme if isinstance(first, Clause) and first.verb == "build" and not first.adjuncts else None
    if not isinstance(shape, Structure) or shape.kind not in _WITHIN or shape.plural or len(clauses) < 2:
        return chains
    many = _many(shape)
    named: dict[Traits, Noun] = {}
    for said in clauses[1:]:
        found = list(_named(said, shape.kind))
        if not found:
            return chains
        named |= {noun.traits: noun for noun in found}
    if many < _FEWEST:
        return chains
    if len(named) != many:
        raise refuse("ambiguous", f"these could be blocks of the {shape.kind} or further ones", clauses[1].span,
                     "name all of its blocks, and no others")  # fmt: skip
    items = tuple(replace(noun, det="bare") for noun in named.values())
    whole = replace(shape, sizes=(), members=Coord(op="and", items=items, span=shape.span))
    return tuple(
        replace(chain, clauses=tuple(replace(c, theme=whole) if c is first else c for c in chain.clauses))
        for chain in chains
    )


def _many(shape: Structure) -> int:
    """Of how many blocks a line is, of which no more is said."""
    members = shape.members
    amount: Amount | None = shape.size
    if isinstance(members, Noun) and members.traits == Traits() and members.part_of is None and members.det == "bare":
        amount = members.amount
    elif members is not None:
        return 0
    exact = amount is not None and amount.low == amount.high and shape.traits == Traits() and not shape.details
    return amount.low if exact and amount is not None else 0


def _named(said: Meaning, kind: str) -> Iterator[Noun]:
    """The single blocks of which a clause says where they are in the line; none where it says anything else."""
    places = said.adjuncts if isinstance(said, Clause) and said.verb == "be" and not said.negated else ()
    within = all(isinstance(a, At) or (isinstance(a, Loc) and a.rel in _WITHIN[kind]) for a in places)
    nouns = [x for x in parts_of(said) if isinstance(x, Noun)]
    if places and within and all(map(_single, nouns)):
        yield from nouns


def _single(noun: Noun) -> bool:
    look = noun.traits
    told = look == Traits(colors=look.colors, labels=look.labels) and len(look.colors + look.labels) == 1
    return told and noun.det in ("the", "bare") and not noun.plural and noun.head != "patch" and noun.amount is None
