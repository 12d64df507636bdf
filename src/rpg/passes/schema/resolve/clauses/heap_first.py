"""A heap of which something is made is there at the start: "a pile of five white cubes. Make a row of them"."""

from __future__ import annotations

from rpg.language.meaning import Chain, Clause, Into, Noun, Pronoun, Structure, parts_of, replace
from rpg.passes.schema.resolve.clauses.begun_facts import wanted


def _made_of_them(order: Clause) -> bool:
    """ "make a row of them", "... of the red ones"."""
    them = any(
        part.word in ("them", "these", "those", "it")
        if isinstance(part, Pronoun)
        else isinstance(part, Noun) and part.head != "patch" and part.det in ("the", "all", "each")
        for part in parts_of(order)
    )
    return them and order.verb in ("build", "stack", "arrange", "sort", "spell")


def heap_for(chain: Chain, after: Chain) -> bool:
    """ "five cyan blocks in a heap. make a row out of them": the heap is there at the start."""
    heap, order = chain.clauses[0], after.clauses[0]
    if not isinstance(heap, Clause) or not isinstance(order, Clause) or order.mode != "command" or order.negated:
        return False
    told = heap.adjuncts[0] if len(heap.adjuncts) == 1 else None
    shape = told.structure if isinstance(told, Into) else None
    alone = len(chain.clauses) == 1 and (heap.verb, heap.mode) == ("be", "goal") and not wanted(heap)
    return alone and isinstance(shape, Structure) and shape.kind == "pile" and _made_of_them(order)


def heap_first(chain: Chain, after: tuple[Chain, ...]) -> Chain:
    """ "A pile of five white cubes. Make a row of them": a heap of which something is made is there at the start."""
    heap, order = chain.clauses[0], after[0].clauses[0] if after else None
    if not isinstance(heap, Clause) or not isinstance(order, Clause) or order.mode != "command" or order.negated:
        return chain
    shape = heap.theme if (heap.verb, heap.mode) == ("build", "goal") and not heap.adjuncts else None
    if not isinstance(shape, Structure) or shape.kind != "pile" or shape.plural or not _made_of_them(order):
        return chain
    listed = chain.clauses[1] if len(chain.clauses) == 2 and shape.members is None else None
    told = isinstance(listed, Clause) and listed.verb == "exist" and listed.lemma in ("tally", "stock")
    if told and isinstance(listed, Clause) and not listed.adjuncts:  # "a heap: 2 red, 2 blue"
        heap = replace(heap, theme=replace(shape, members=listed.theme))
    elif len(chain.clauses) > 1:
        return chain
    return replace(chain, clauses=(replace(heap, verb="exist", lemma="begun", mode="given"),), links=chain.links[:1])
