"""Heaps and what is in them: "six blocks start in a heap, three orange and three purple", "from a heap of five"."""

from __future__ import annotations

from operator import is_
from typing import TypeGuard

from rpg.ir import goal as g
from rpg.ir.node import members
from rpg.ir.walk import atoms, names
from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    Coord,
    Into,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Pronoun,
    Structure,
    TableTop,
    Traits,
    Using,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.begun_facts import wanted
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.structures.on_each_patch import stacked_on_each
from rpg.passes.schema.resolve.structures.out_of_heaps import out_of_heaps

_LISTS = ("tally", "stock")
"""What a clause is called that lists what there is."""


def told_later(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]]:
    """The sentences, with blocks of the start as the list behind them tells them; lists that did no more are gone.

    "Six blocks start in a heap, three orange and three purple."
    """
    lists = any(isinstance(c, Clause) and c.lemma in _LISTS for chain in chains for c in chain.clauses)
    if not lists and all(chain.clauses and chain.links[0] == "and" for chain in chains):
        return links, chains
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
    if shape.kind != "pile" or shape.plural or not isinstance(items, Noun | Coord):
        return None
    if within is None:  # "a whole heap! Two red, two blue.", while "there are two red ones" may lie elsewhere
        bare = items.span[0] == tally.span[0]
        return replace(heap, theme=replace(shape, members=items)) if bare else None
    if (
        not isinstance(within, Noun)
        or within.traits != Traits(kind=within.traits.kind)
        or within.conditions
        or within.part_of is not None
    ):
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
    clause = stacked_on_each(clause, spec)
    told = spec.places or spec.intos or spec.orders or spec.toward or spec.ats or spec.absolutes
    if clause.verb != "stack" or clause.lemma not in ("heap", "pile") or clause.mode != "start" or told:
        return clause
    shape = Structure(kind="pile", span=clause.word or clause.span)
    spec.intos.append(Into(structure=shape, span=shape.span))
    return replace(clause, verb="arrange")


def heaps_last(links: list[str], chains: tuple[Chain, ...]) -> tuple[list[str], tuple[Chain, ...]] | None:
    """ "There is a pile of letters. Spell DOG": a heap of those that the other clauses name, so it is read behind them.

    None where there is no such heap, nothing is named besides, or something is said of "them".
    """
    parts = [part for chain in chains for part in parts_of(chain)]
    if not any(isinstance(part, Structure) and part.kind == "pile" for part in parts):
        return None
    if any(isinstance(part, Pronoun) and part.word in _THEM for part in parts):
        return None
    found: list[Clause] = []
    kept: list[tuple[str, Chain]] = []
    for link, chain in zip(links, chains, strict=True):
        pairs = list(zip(chain.links, chain.clauses, strict=True))
        open_ = [(c, heap) for _, c in pairs if (heap := _open_heap(c)) is not None]
        found += [heap for _, heap in open_]
        rest = [(joint, c) for joint, c in pairs if all(c is not clause for clause, _ in open_)]
        if rest:
            joints = ("and", *(joint for joint, _ in rest[1:]))
            kept.append((link, replace(chain, clauses=tuple(c for _, c in rest), links=joints)))
    if len(found) != 1 or not kept:
        return None
    kind = found[0].theme.traits.kind if isinstance(found[0].theme, Noun) else None
    if not any(_names_such(part, kind) for _, chain in kept for part in parts_of(chain)):
        return None
    last = Chain(clauses=(found[0],), links=("and",), span=found[0].span)
    return [*(link for link, _ in kept), "and"], (*(chain for _, chain in kept), last)


def heaps_begun(chains: tuple[Chain, ...]) -> tuple[Chain, ...] | None:
    """ "Four cubes in a heap: two red, two white. Sort by colour.": what is told of a heap, and not ordered, is of the
    start. None where nothing else is told, or no heap is."""
    told = [[None if _ordered(chain, n) else _begun_heap(c) for n, c in enumerate(chain.clauses)] for chain in chains]
    if not any(heap for heaps in told for heap in heaps) or all(heap for heaps in told for heap in heaps):
        return None
    whole = [c for chain in chains for c in chain.clauses if isinstance(c, Clause) and c.mode == "goal"]
    piles = [c for c in whole if _single_heap(c.theme)]
    if not all(map(_begun_heap, piles)):  # "a pile of blue blocks, and to its right a pile of red ones"
        return None
    return tuple(
        replace(chain, clauses=tuple(heap or c for heap, c in zip(heaps, chain.clauses, strict=True)))
        for heaps, chain in zip(told, chains, strict=True)
    )


def placed(goal: g.Goal) -> set[str]:
    """The blocks that a goal places, and not just others by them: of "the green blocks in a heap, and the blue one far
    from them" the blue one."""
    related = [x for x in atoms(goal) if hasattr(x, "a") and hasattr(x, "b")]
    marks = {n for x in related for n in members(x.b)} - {n for x in related for n in members(x.a)}
    return {*names(goal)} - (marks - {n for x in atoms(goal) if not hasattr(x, "b") for n in names(x)})


def _ordered(chain: Chain, n: int) -> bool:
    """ "Sort them into a red heap and a blue heap": what is named behind an order is ordered, too."""
    return any(isinstance(c, Clause) and c.mode == "command" for c in chain.clauses[:n])


def _begun_heap(clause: Meaning) -> Clause | None:
    if not isinstance(clause, Clause) or clause.negated or clause.mode != "goal" or clause.verb == "sort":
        return None
    shape = clause.theme
    if isinstance(shape, Structure) and _single_heap(shape) and clause.verb in ("build", "be"):
        if clause.lemma == "build":  # "a pile of three blocks is built"
            return None
        told = all(isinstance(a, Loc) and isinstance(a.landmark, TableTop) for a in clause.adjuncts)
        return replace(clause, verb="exist", lemma="begun", mode="given", adjuncts=()) if told else None
    into = clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    if not isinstance(into, Into) or not _single_heap(into.structure) or wanted(clause):
        return None
    return replace(clause, mode="start")


def _single_heap(shape: Meaning | None) -> bool:
    return isinstance(shape, Structure) and shape.kind == "pile" and not shape.plural and not shape.sizes


_THEM = frozenset(
    {"them", "they", "these", "those", "all", "all of them", "it", "everything", "the rest", "the others"}
)


def _names_such(part: Meaning, kind: str | None) -> bool:
    """Whether a phrase names blocks of a kind by what they look like."""
    if isinstance(part, Structure):
        return bool(part.letter) and part.kind in ("word", "equation")
    marks = part.traits if isinstance(part, Noun) and part.head != "patch" else Traits()
    return bool(marks.labels or (marks.colors and kind is None))


def _open_heap(clause: Meaning) -> Clause | None:
    """ "there is a pile of letters", "the letters start in a heap": as told of all the letters that there are."""
    if not isinstance(clause, Clause) or clause.negated:
        return None
    shape, within = clause.theme, None
    if (clause.verb, clause.mode) == ("exist", "given") and isinstance(shape, Structure):
        told = all(isinstance(a, Loc) and isinstance(a.landmark, TableTop) for a in clause.adjuncts)
        within = shape.members if told and not shape.details else None
    elif clause.mode == "start" and isinstance(shape, Noun) and len(clause.adjuncts) == 1:
        into = clause.adjuncts[0]
        within = shape if shape.det == "the" and isinstance(into, Into) else None
        shape = into.structure if isinstance(into, Into) else None
    if not isinstance(shape, Structure) or shape.kind != "pile" or shape.plural or shape.sizes:
        return None
    if not isinstance(within, Noun) or within.head != "block" or not within.plural or within.amount is not None:
        return None
    if within.traits != Traits(kind=within.traits.kind) or within.conditions or within.part_of is not None:
        return None
    into = Into(structure=Structure(kind="pile", span=shape.span), span=shape.span)
    return Clause(verb="be", lemma="fact", theme=replace(within, det="all"), adjuncts=(into,), mode="start",
                  span=clause.span)  # fmt: skip


def from_heaps(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """ "From a heap of five red blocks make a row", "sort a heap of them": there is a heap, of whose blocks it is."""
    found = []
    for chain in out_of_heaps(chains, text):
        pairs: list[tuple[str, Meaning]] = []
        for link, clause in zip(chain.links, chain.clauses, strict=True):
            heaps = [a for a in clause.adjuncts if _is_heap(a)] if isinstance(clause, Clause) else []
            for heap in heaps:
                there = Clause(verb="exist", theme=heap.members, mode="given", lemma="begun", span=heap.span)
                pairs.append(("and", there))
            clause = _of_heaps(clause, heaps) if heaps and isinstance(clause, Clause) else clause
            if isinstance(clause, Clause) and (blocks := _taken_up(clause)) is not None:
                there = Clause(verb="exist", theme=clause.theme, mode="given", lemma="begun", span=clause.span)
                pairs.append(("and", there))
                clause = replace(clause, theme=blocks)
            pairs.append((link, clause))
        clauses = tuple([c for _, c in pairs])
        same = len(clauses) == len(chain.clauses) and all(map(is_, clauses, chain.clauses))
        found.append(chain if same else replace(chain, clauses=clauses, links=tuple(link for link, _ in pairs)))
    return tuple(found)


def _taken_up(clause: Clause) -> Meaning | None:
    """The blocks of a heap that something else is to be made of; None where a clause says of no heap that."""
    heap = clause.theme
    ordered = bool(clause.adjuncts) and all(isinstance(a, OrderBy) for a in clause.adjuncts)
    made = clause.verb == "sort" or (clause.verb == "be" and ordered)
    made = made or (clause.verb in ("pick", "use") and not clause.adjuncts)  # "take the heap and make a row of it"
    made = made or (clause.verb in ("arrange", "stack") and clause.lemma not in ("", "turn into"))
    if not made or clause.mode not in ("goal", "command") or clause.negated:
        return None
    if not isinstance(heap, Structure) or not _single_heap(heap) or heap.details:
        return None
    lots = heap.members.items if isinstance(heap.members, Coord) else (heap.members,)
    known = tuple(replace(x, det="the") for x in lots if isinstance(x, Noun) and x.det == "bare")
    if len(known) < len(lots):
        return None
    return replace(heap.members, items=known) if isinstance(heap.members, Coord) else known[0]


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
