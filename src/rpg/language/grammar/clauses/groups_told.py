"""Groups that are listed behind a colon: "two groups: the letters A, B and C, and two red cubes"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.clauses.into_groups import GROUPS, in_a_pile
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Chain, Clause, Meaning, Noun, That, replace

_LEADS = Patterns(
    "make|build|form|create",
    "sort|separate|divide|split|group|arrange|cluster|put|organize|part the|all|all_the|these? cubes|blocks|them|"
    "everything|all by_kind|by_type? into|in",
)
_GROUPS = frozenset(f"{group}s" for group in GROUPS)
_JOINTS = (",", "and", ", and")


@rule
def groups_told(p: Parser, i: int) -> Results[Clause]:
    """As many lots as there are groups, each of them said to be in one of its own."""
    if not p.rarely(_GROUPS):
        return
    for start in (i, *_LEADS.matches(p, i)):
        many = p.number(start)
        colon = p.one(p.one(start + 1, _GROUPS), (":", ",")) if many and many > 1 and p.one(start + 1, _GROUPS) else 0
        for lots, end in _lots(p, colon, (), many or 0) if colon else ():
            if not all(len(lot.traits.colors) == 1 for lot in lots):  # else they are sorted by colour
                yield _clause(p, i, end, lots), end


def _lots(p: Parser, i: int, had: tuple[Noun, ...], many: int) -> Iterator[tuple[tuple[Noun, ...], int]]:
    for lot, j in simple(p, i):
        listed = isinstance(lot, Noun) and not lot.traits.kind and len(lot.traits.labels) > 1
        if not isinstance(lot, Noun) or not _named(lot) or (listed and "and" not in p.words[i:j]):
            continue  # "two groups: A, B, C, D" does not tell which are in which
        lots = (*had, replace(lot, det="bare") if lot.amount is not None else lot)
        if len(lots) == many:
            yield lots, j
        elif joint := p.any_of(j, _JOINTS):
            yield from _lots(p, joint, lots, many)


def _named(lot: Noun) -> bool:
    """Blocks that are named, or counted."""
    if lot.head == "patch" or lot.part_of is not None or lot.det not in ("bare", "the", "a"):
        return False
    exact = lot.amount is not None and lot.amount.low == lot.amount.high
    return len(lot.traits.labels) > 1 or (exact and bool(lot.traits.colors or lot.traits.kind))


def _clause(p: Parser, i: int, end: int, lots: tuple[Noun, ...]) -> Clause:
    first, *rest = (
        Clause(verb="be", theme=lot, adjuncts=(in_a_pile(lot.span, "another" if n else "bare"),), mode="goal",
               span=lot.span)
        for n, lot in enumerate(lots)
    )  # fmt: skip
    chain = Chain(clauses=tuple(rest), links=("and",) * len(rest), span=p.span(i, end))
    so: Meaning = That(kind="so", clauses=chain, span=chain.span)
    return replace(first, adjuncts=(*first.adjuncts, so), span=p.span(i, end))
