"""Heaps and what is in them: "six blocks start in a heap, three orange and three purple", "from a heap of five"."""

from __future__ import annotations

from dataclasses import replace
from typing import TypeGuard

from rpg.language.meaning import Amount, Chain, Clause, Coord, Into, Meaning, Noun, Structure, Traits, Using
from rpg.passes.schema.resolve.spec import Spec


def told_later(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences, with blocks of the start as the list behind them tells them; lists that did no more are gone.

    "Six blocks start in a heap, three orange and three purple."
    """
    found: list[list[tuple[str, Meaning]]] = []
    before: tuple[int, int] | None = None
    for chain in chains:
        kept: list[tuple[str, Meaning]] = []
        found.append(kept)
        for link, clause in zip(chain.links, chain.clauses, strict=True):
            told = found[before[0]][before[1]][1] if before is not None else None
            if before is not None and told is not None and (whole := _listed(told, clause) or _in_heap(told, clause)):
                found[before[0]][before[1]] = (found[before[0]][before[1]][0], whole)
                before = None
                continue
            before = (len(found) - 1, len(kept))
            kept.append((link, clause))
    left = [n for n, kept in enumerate(found) if kept]
    return [links[n] for n in left], tuple(
        replace(chains[n], clauses=tuple(c for _, c in found[n]), links=("and", *(link for link, _ in found[n][1:])))
        for n in left
    )


def _in_heap(heap: Meaning, tally: Meaning) -> Clause | None:
    """ "There is a pile of letters: D, O and G": the heap with what the list names."""
    if not (isinstance(heap, Clause) and isinstance(tally, Clause)) or (heap.verb, heap.mode) != ("exist", "given"):
        return None
    shape, items = heap.theme, tally.theme
    if tally.lemma not in ("tally", "stock") or tally.adjuncts or not isinstance(shape, Structure):
        return None
    within = shape.members
    if shape.kind != "pile" or shape.plural or not isinstance(within, Noun) or not isinstance(items, Noun | Coord):
        return None
    if within.traits != Traits(kind=within.traits.kind) or within.conditions or within.part_of is not None:
        return None
    lots = [x for x in (items.items if isinstance(items, Coord) else (items,)) if isinstance(x, Noun)]
    letters = all(x.traits.labels and all(map(str.isalpha, x.traits.labels)) for x in lots)
    many = sum(x.amount.low if x.amount else max(1, len(x.traits.labels)) for x in lots)
    if (within.traits.kind == "letter") != letters or within.amount not in (None, Amount(many, many)):
        return None
    return replace(heap, theme=replace(shape, members=items))


def _listed(begun: Meaning, tally: Meaning) -> Clause | None:
    """The clause about the start with the blocks that the list names, where these are just as many."""
    if not (isinstance(begun, Clause) and isinstance(tally, Clause)) or begun.mode != "start" or begun.negated:
        return None
    blocks, items = begun.theme, tally.theme
    if tally.lemma != "tally" or tally.adjuncts or not isinstance(items, Coord) or not isinstance(blocks, Noun):
        return None
    plain = blocks.head == "block" and blocks.traits == Traits() and not blocks.conditions and blocks.part_of is None
    if not plain or not blocks.plural or (blocks.amount is None and blocks.det not in ("all", "the")):
        return None
    many = sum(x.amount.low if x.amount else len(x.traits.labels) for x in items.items if isinstance(x, Noun))
    return replace(begun, theme=items) if blocks.amount in (None, Amount(many, many)) else None


def heaped_up(clause: Clause, spec: Spec) -> Clause:
    """ "The blocks start heaped up": in a heap, for nothing is said of what lies on what."""
    told = spec.places or spec.intos or spec.orders or spec.toward or spec.ats or spec.absolutes
    if clause.verb != "stack" or clause.lemma not in ("heap", "pile") or clause.mode != "start" or told:
        return clause
    shape = Structure(kind="pile", span=clause.word or clause.span)
    spec.intos.append(Into(structure=shape, span=shape.span))
    return replace(clause, verb="arrange")


def from_heaps(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """ "From a heap of five red blocks make a row": there is such a heap, and the row is made of its blocks."""
    found = []
    for chain in chains:
        pairs: list[tuple[str, Meaning]] = []
        for link, clause in zip(chain.links, chain.clauses, strict=True):
            heaps = [a for a in clause.adjuncts if _is_heap(a)] if isinstance(clause, Clause) else []
            for heap in heaps:
                there = Clause(verb="exist", theme=heap.members, mode="given", lemma="begun", span=heap.span)
                pairs.append(("and", there))
            pairs.append((link, _of_heaps(clause, heaps) if heaps and isinstance(clause, Clause) else clause))
        found.append(replace(chain, clauses=tuple(c for _, c in pairs), links=tuple(link for link, _ in pairs)))
    return tuple(found)


def _is_heap(part: Meaning) -> TypeGuard[Using]:
    heap = isinstance(part, Using) and isinstance(part.members, Structure) and part.members.kind == "pile"
    return heap and isinstance(part, Using) and part.lead in ("from", "out of")


def _of_heaps(clause: Clause, heaps: list[Using]) -> Clause:
    """The clause with the blocks of its heaps in their place; as its theme if it names no blocks."""
    blocks = [heap.members.members for heap in heaps if isinstance(heap.members, Structure)]
    own = clause.theme.members if isinstance(clause.theme, Structure) else clause.theme
    kept = tuple(a for a in clause.adjuncts if a not in heaps)
    if own is None and not any(isinstance(a, Using) for a in kept):
        kept += tuple(Using(members=x, lead="from", span=x.span) for x in blocks if x is not None)
    return replace(clause, adjuncts=kept)
