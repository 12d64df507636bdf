""" "The six blocks become a tower of four and a row of two": several structures of counted blocks use these alone."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile

from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    Coord,
    Into,
    Manner,
    Meaning,
    Noun,
    Pronoun,
    Size,
    Structure,
    Traits,
    Using,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse

_THEM = frozenset({"them", "they", "these", "those"})
"""Blocks that were spoken of; and "it", if it was a structure."""


def shared_between(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences, with such structures told behind what there is.

    Raises:
        Refusal: they take more blocks than there are, or do not say what becomes of the others.
    """
    kinds: set[str] = set()
    found: list[Chain] = []
    for chain in chains:
        links: list[str] = []
        clauses: list[Meaning] = []
        rest = [*zip(chain.links, chain.clauses, strict=True)]
        while rest:
            (link, clause), *rest = rest
            source, shapes, more = _made_of_one_lot(clause, rest)
            told: list[Meaning] = [clause]
            if source is not None and isinstance(clause, Clause):
                told, rest = _told(clause, source, shapes, kinds), rest[more:]
            links += [link, *["and"] * (len(told) - 1)]
            clauses += told
            kinds |= {x.kind for x in parts_of(clause) if isinstance(x, Structure)}
        same = tuple(clauses) == chain.clauses
        found.append(chain if same else replace(chain, links=tuple(links), clauses=tuple(clauses)))
    return tuple(found)


def _made_of_one_lot(
    clause: Meaning, rest: Sequence[tuple[str, Meaning]]
) -> tuple[Meaning | None, tuple[Structure, ...], int]:
    """The blocks of which several structures are made, these, and how many of the clauses behind tell of them."""
    nothing = (None, (), 0)
    if not isinstance(clause, Clause) or clause.negated or len(clause.adjuncts) > 1:
        return nothing
    part = clause.adjuncts[0] if clause.adjuncts else None
    if clause.verb in ("arrange", "sort") and isinstance(part, Into):
        joined = [] if isinstance(part.structure, Coord) else [*takewhile(_joined, rest)]
        source, shapes = clause.theme, [part.structure, *(getattr(c, "theme", None) for _, c in joined)]
        shapes = [*part.structure.items] if isinstance(part.structure, Coord) else shapes
    elif clause.verb == "build" and isinstance(clause.theme, Coord) and clause.theme.op == "and":
        joined, shapes = [], [*clause.theme.items]
        source = part.members if isinstance(part, Using) else None
        last = shapes[-1]
        lot = last.members if isinstance(last, Structure) and part is None else None
        if isinstance(last, Structure) and isinstance(lot, Noun) and lot.det == "some" and lot.part_of is not None:
            source, size = lot.part_of, Size(what="size", amount=lot.amount, span=lot.span)
            shapes[-1] = replace(last, members=None, sizes=(size,))
    else:
        return nothing
    new = tuple(x for x in shapes if isinstance(x, Structure) and _many(x))
    known = isinstance(source, Noun | Structure | Pronoun)
    return (source, new, len(joined)) if known and len(new) == len(shapes) > 1 else nothing


def _joined(told: tuple[str, Meaning]) -> bool:
    """Whether a clause only adds a structure: "(a tower of four) and a row of two"."""
    link, clause = told
    bare = isinstance(clause, Clause) and (clause.verb, clause.mode, clause.lemma) == ("build", "goal", "")
    if link != "and" or not bare or not isinstance(clause, Clause) or clause.negated:
        return False
    ended = all(isinstance(x, Manner) and x.kind == "finally" for x in clause.adjuncts)
    return ended and isinstance(clause.theme, Structure)


def _many(shape: Structure) -> int:
    """How many blocks of no look structures take that were not spoken of; 0 where that is not said."""
    members = shape.members
    plain = members is None or (isinstance(members, Noun) and members.traits == Traits() and not members.part_of)
    size = members.amount if isinstance(members, Noun) else shape.size
    told = bool(shape.dims or shape.details or shape.letter or shape.traits != Traits())
    if shape.det not in ("a", "bare") or told or not plain or size is None or size.low != size.high:
        return 0
    return size.low * (shape.amount.low if shape.amount else 1)


def _told(clause: Clause, source: Meaning, shapes: tuple[Structure, ...], kinds: set[str]) -> list[Meaning]:
    """What there is, and what is built of it. `kinds`: of structures that were spoken of before."""
    there: list[Meaning] = []
    amount = source.amount if isinstance(source, Noun) else None
    if isinstance(source, Structure):
        amount = source.members.amount if isinstance(source.members, Noun) else source.size
        if amount is not None and source.kind not in kinds:
            begun = replace(source, det="a", amount=Amount(1, 1))
            there = [replace(clause, verb="exist", lemma="begun", theme=begun, adjuncts=(), mode="given")]
    elif isinstance(source, Noun):
        there = [replace(clause, verb="exist", lemma="", theme=source, adjuncts=(), mode="given")]
    elif isinstance(source, Pronoun) and source.word not in _THEM and not (source.word == "it" and len(kinds) == 1):
        return [clause]
    taken = sum(map(_many, shapes))
    if amount is not None and (amount.low, amount.high) != (taken, taken):
        raise refuse("count-mismatch", f"this takes {taken} blocks, but {amount.low} are named", source.span,
                     "say what becomes of the others, or change the sizes")  # fmt: skip
    built = Coord(op="and", items=shapes, span=clause.span)
    changed = isinstance(source, Structure) or getattr(source, "word", "") == "it"
    mode = "command" if changed else clause.mode
    return [*there, replace(clause, verb="build", lemma="", theme=built, adjuncts=(), mode=mode, cost=0)]
