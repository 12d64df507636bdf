""" "The blocks 1 to 6 in two rows, the odd ones behind the even ones": which of them are in which row is told by how
the two lots lie to each other."""

from __future__ import annotations

from itertools import pairwise

from rpg.blocks.traits import QUALITIES, kind_of
from rpg.language.meaning import (
    Absolute,
    Amount,
    Chain,
    Clause,
    Coord,
    Into,
    Loc,
    Meaning,
    Noun,
    Structure,
    Traits,
    replace,
)

_BESIDE = ("behind", "front", "left", "right")
_KINDS = ("row", "line", "column", "stack")


def lots_related(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences, with one for each lot where the blocks are those of the two lots, and two lines are asked for."""
    told = [
        (link, part)
        for n, chain in enumerate(chains)
        for link, clause in zip((links[n], *chain.links[1:]), chain.clauses, strict=True)
        for link, part in ((link if k == 0 else "and", x) for k, x in enumerate(_apart(clause)))
    ]
    for at, ((link, whole), (then, beside)) in enumerate(pairwise(told)):
        if then == "and" and (clauses := _each_by_itself(whole, beside)):
            parted = [*told[:at], *((link if k == 0 else "and", c) for k, c in enumerate(clauses)), *told[at + 1 :]]
            return [x for x, _ in parted], tuple(Chain(clauses=(c,), links=("and",), span=c.span) for _, c in parted)
    return links, chains


def _apart(clause: Meaning) -> tuple[Meaning, ...]:
    """ "In two rows with the odd ones behind the even ones": the rows, and how the lots lie."""
    parts = clause.adjuncts if isinstance(clause, Clause) else ()
    said = parts[1] if len(parts) == 2 and isinstance(parts[0], Into) else None
    if not isinstance(clause, Clause) or not isinstance(said, Absolute) or not isinstance(said.adjuncts[0], Loc):
        return (clause,)
    beside = Clause(verb="be", theme=said.theme, adjuncts=said.adjuncts, mode="goal", span=said.span)
    return replace(clause, adjuncts=parts[:1]), beside


def _each_by_itself(whole: Meaning, beside: Meaning) -> tuple[Clause, ...]:
    """What there is, and where each lot goes; nothing where these are not two lots that are all of it."""
    if not isinstance(whole, Clause) or not isinstance(beside, Clause):
        return ()
    into = whole.adjuncts[0] if len(whole.adjuncts) == 1 else None
    lines = into.structure if isinstance(into, Into) else None
    place = beside.adjuncts[0] if len(beside.adjuncts) == 1 else None
    if not isinstance(lines, Structure) or lines.kind not in _KINDS or lines.amount != Amount(2, 2):
        return ()
    if lines.members or lines.dims or lines.details or lines.traits != Traits() or whole.negated or beside.negated:
        return ()
    if not isinstance(place, Loc) or place.rel not in _BESIDE or place.negated or place.mods or place.low:
        return ()
    lots = (beside.theme, place.landmark)
    if whole.theme is None or not all(isinstance(lot, Noun) and _all_such(lot) for lot in lots):
        return ()
    units = _units(whole.theme)
    shares = [[unit for unit in units if isinstance(lot, Noun) and _is_such(unit, lot.traits)] for lot in lots]
    if not units or any(not share for share in shares) or sorted(shares[0] + shares[1]) != sorted(units):
        return ()
    line = replace(lines, det="a", plural=False, amount=Amount(1, 1), each_size=False)
    there = Clause(verb="exist", theme=whole.theme, mode="given", span=whole.theme.span)
    go = Into(structure=line, span=lines.span)
    return (there, *(Clause(verb="be", theme=lot, adjuncts=(go,), mode="goal", span=whole.span) for lot in lots))


def _all_such(lot: Noun) -> bool:
    """ "The odd ones", "the red blocks": all of one look, and nothing else."""
    plain = lot.part_of is None and not lot.conditions and lot.amount is None and lot.plural
    return plain and replace(lot.traits, colors=(), kind=None, quality=None) == Traits() != lot.traits


def _units(theme: Meaning) -> list[str]:
    """The labels and colours of what is spoken of, each once; nothing where it is told otherwise."""
    found: list[str] = []
    for item in theme.items if isinstance(theme, Coord) and theme.op == "and" else (theme,):
        marks = item.traits if isinstance(item, Noun) and not item.conditions else Traits()
        if len(marks.colors) + bool(marks.labels) != 1 or replace(marks, colors=(), labels=(), kind=None) != Traits():
            return []
        found += [*marks.labels, *marks.colors]
    return found


def _is_such(unit: str, marks: Traits) -> bool:
    if marks.colors:
        return marks.colors == (unit,)
    symbol = unit if len(unit) == 1 else ""
    return marks.kind in (None, kind_of(symbol)) and symbol in (QUALITIES[marks.quality] if marks.quality else symbol)
