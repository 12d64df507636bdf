""" "Pull the yellow block out of the heap of four blue ones": it is in there with them; so it is in "there is a yellow
block in the heap of four blue ones"."""

from __future__ import annotations

import re

from rpg.language.meaning import (
    Amount,
    Chain,
    Clause,
    Coord,
    Into,
    Loc,
    Meaning,
    Noun,
    Structure,
    Using,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse

_TAKEN = ("pick", "place", "use")


def out_of_heaps(chains: tuple[Chain, ...], text: str) -> tuple[Chain, ...]:
    """The sentences, with what is taken out of a heap among the blocks of that heap; refused where it is not said of
    which heap this is."""
    chains = tuple(_in_one_heap(_consists(chain, text)) for chain in chains)
    return tuple(replace(chain, clauses=tuple(_out(c, chains) for c in chain.clauses)) for chain in chains)


def _consists(chain: Chain, text: str) -> Chain:
    """ "The heap consists of two red and three green cubes": it does so now, unless it "should"."""
    clauses = tuple(
        replace(c, verb="exist", lemma="begun", mode="given", theme=_with(c.theme, ()))
        if isinstance(c, Clause)
        and (c.verb, c.lemma, c.mode, c.adjuncts, c.negated) == ("build", "", "goal", (), False)
        and isinstance(c.theme, Structure)
        and c.theme.det == "the"
        and _of_blocks(c.theme)
        and _SO.search(text[slice(*c.span)]) is not None
        else c
        for c in chain.clauses
    )
    return replace(chain, clauses=clauses)


_SO = re.compile(r"\b(?:consists|is made|is composed|comprises|contains|has)\b", re.IGNORECASE)


def _in_one_heap(chain: Chain) -> Chain:
    told = [(link, part) for link, clause in zip(chain.links, chain.clauses, strict=True)
            for n, part in enumerate(_in_one(clause)) for link in (link if n == 0 else "and",)]  # fmt: skip
    return replace(chain, clauses=tuple(part for _, part in told), links=tuple(link for link, _ in told))


def _in_one(clause: Meaning) -> tuple[Meaning, ...]:
    """ "There is a heap of four blue blocks and a yellow one", "in the heap of four blue blocks there is a yellow one":
    all of them are in the heap."""
    if not isinstance(clause, Clause) or clause.negated:
        return (clause,)
    theme, place = clause.theme, clause.adjuncts[0] if len(clause.adjuncts) == 1 else None
    given = (clause.verb, clause.lemma, clause.mode) == ("exist", "", "given")
    if isinstance(theme, Coord) and theme.op == "and" and given and not clause.adjuncts:
        first, *more = theme.items
        if _of_blocks(first) and isinstance(first, Structure) and all(map(_blocks, more)):
            return (replace(clause, theme=_with(first, tuple(more))),)
    heap = place.landmark if isinstance(place, Loc) and place.rel in ("in", "between") and not place.negated else None
    heap = place.structure if isinstance(place, Into) else heap
    told = given or (clause.verb, clause.lemma, clause.mode) == ("be", "fact", "goal")
    if not told or not isinstance(heap, Structure) or not isinstance(theme, Noun):
        return (clause,)
    if not _of_blocks(heap) or not _blocks(theme):
        return (clause,)
    there = replace(clause, verb="exist", lemma="begun", mode="given", theme=_with(heap, (theme,)), adjuncts=())
    spoken = replace(there, theme=replace(theme, det="the", amount=None))  # of which it goes on
    return (there, spoken)


def _with(heap: Structure, more: tuple[Meaning, ...]) -> Structure:
    assert heap.members is not None
    lots = heap.members.items if isinstance(heap.members, Coord) else (heap.members,)
    items = tuple(replace(x, head="block") if isinstance(x, Noun) and x.head == "any" else x for x in (*lots, *more))
    whole = Coord(op="and", items=items, span=heap.members.span)
    return replace(heap, det="a", amount=Amount(1, 1), members=whole)


def _of_blocks(heap: Meaning) -> bool:
    """Whether this is one heap of so many blocks of some looks."""
    one = isinstance(heap, Structure) and heap.kind == "pile" and not heap.plural
    return one and isinstance(heap, Structure) and heap.members is not None and bool(_all_looks(heap.members))


def _blocks(noun: Meaning) -> bool:
    """ "A yellow block", "two red ones", with nothing said of where they are."""
    plain = isinstance(noun, Noun) and noun.head != "patch" and not noun.conditions and noun.part_of is None
    return plain and isinstance(noun, Noun) and bool(_looks(noun)) and noun.amount is not None


def _out(clause: Meaning, chains: tuple[Chain, ...]) -> Meaning:
    source = _source(clause)
    if not isinstance(clause, Clause) or source is None or not isinstance(clause.theme, Noun):
        return clause
    heap, looks = source.members, _looks(clause.theme)
    if not isinstance(heap, Structure) or not looks:
        return clause
    if heap.members is None:
        told = [_in_heap(x) for chain in chains for x in parts_of(chain)]
        there = {look for members in told if members is not None for look in _all_looks(members) or looks}
        if there and not looks <= there:
            raise refuse("no-referent", "it is not said that this is in the heap", clause.theme.span,
                         "say of which blocks the heap is")  # fmt: skip
        return clause
    known = _all_looks(heap.members)
    if not known or looks & known:
        return clause
    one = replace(clause.theme, det="a" if not clause.theme.plural else "bare",
                  amount=clause.theme.amount or Amount(1, 1))  # fmt: skip
    items = heap.members.items if isinstance(heap.members, Coord) else (heap.members,)
    whole = Coord(op="and", items=(*items, one), span=heap.members.span)
    found = replace(source, members=replace(heap, members=whole))
    return replace(clause, adjuncts=tuple(found if x is source else x for x in clause.adjuncts))


def _source(clause: Meaning) -> Using | None:
    """The heap that blocks are taken out of."""
    taken = isinstance(clause, Clause) and clause.verb in _TAKEN and not clause.negated
    found = [x for x in clause.adjuncts if isinstance(x, Using)] if taken and isinstance(clause, Clause) else []
    heaps = [x for x in found if x.lead == "out of" and isinstance(x.members, Structure) and x.members.kind == "pile"]
    return heaps[0] if heaps else None


def _in_heap(part: Meaning) -> Meaning | None:
    """The blocks of which it is said that they are in a heap."""
    if isinstance(part, Structure):
        return part.members if part.kind == "pile" else None
    into = part.adjuncts[0] if isinstance(part, Clause) and len(part.adjuncts) == 1 else None
    piled = isinstance(into, Into) and isinstance(into.structure, Structure) and into.structure.kind == "pile"
    return part.theme if piled and isinstance(part, Clause) else None


def _looks(noun: Noun) -> set[str]:
    return {*map(str, noun.traits.colors), *noun.traits.labels}


def _all_looks(members: Meaning) -> set[str]:
    return {look for x in parts_of(members) if isinstance(x, Noun) for look in _looks(x)}
