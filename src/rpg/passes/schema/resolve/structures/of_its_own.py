"""Blocks of a further structure: "a tower of red and blue. Build another tower of red and blue": not the same two."""

from __future__ import annotations

from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    Coord,
    Meaning,
    Noun,
    OrderBy,
    Structure,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.counted import put

_LINES = ("stack", "row", "line", "column")
_UNDONE = frozenset({"unstack", "remove", "dismantle"})
"""Verbs after which the same blocks are free for another structure."""


def of_its_own(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences, in which what a further line is made of are blocks besides those of the lines before it."""
    shapes = [part for chain in chains for part in parts_of(chain) if isinstance(part, Structure)]
    if len(shapes) < 2 or any(isinstance(part, Clause) and _undone(part) for c in chains for part in c.clauses):
        return chains
    had: set[str] = set()
    for shape in shapes:
        if shape.kind not in _LINES or shape.plural:
            continue
        marks = {mark for noun in _told(shape) if _is_bare(noun) for mark in _marks(noun)}
        if shape.det == "another" and had & marks:
            chains = tuple(put(chain, shape, _with_further(shape)) for chain in chains)
        had |= marks
    return chains


def _undone(clause: Clause) -> bool:
    return clause.verb in _UNDONE or clause.lemma in _UNDONE


def _told(shape: Structure) -> list[Noun]:
    """The blocks that a line is told by, as in "of red, blue" and "of red on blue"."""
    whole = shape.members
    items = whole.items if isinstance(whole, Coord) and whole.op == "and" else (whole,)
    orders = [x for x in shape.details if isinstance(x, OrderBy) and x.by == "named"]
    return [x for x in (*items, *(item for order in orders for item in order.items)) if isinstance(x, Noun)]


def _is_bare(noun: Noun) -> bool:
    """Whether these are blocks told by their colours or by their labels alone, one of each."""
    plain = noun.det == "bare" and noun.amount is None and noun.part_of is None and not noun.conditions
    alone = noun.traits in (Traits(colors=noun.traits.colors), Traits(labels=noun.traits.labels))
    return plain and alone and noun.plural == (len(_marks(noun)) > 1)


def _marks(noun: Noun) -> tuple[str, ...]:
    return noun.traits.colors or noun.traits.labels


def _with_further(shape: Structure) -> Structure:
    """The line of blocks that were not spoken of."""
    members = shape.members
    if isinstance(members, Coord) or (isinstance(members, Noun) and _is_bare(members)):
        items = members.items if isinstance(members, Coord) else (members,)
        members = Coord(op="and", items=_further(items), span=members.span)
    details = tuple(
        replace(x, items=_further(x.items)) if isinstance(x, OrderBy) and x.by == "named" else x for x in shape.details
    )
    return replace(shape, members=members, details=details)


def _further(items: tuple[Meaning, ...]) -> tuple[Meaning, ...]:
    """Each block in a list as one more of its kind."""
    found: list[Meaning] = []
    for item in items:
        if isinstance(item, Noun) and _is_bare(item):
            one = replace(item, head="block", det="a", amount=Amount(1, 1), plural=False)
            found += [replace(one, traits=Traits(colors=(color,))) for color in item.traits.colors]
            found += [replace(one, det="another", traits=Traits(labels=(x,))) for x in item.traits.labels]
        else:
            found.append(item)
    return tuple(found)
