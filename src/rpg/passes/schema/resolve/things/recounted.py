""" "Put five blocks in a row, one red and four blue, with the red one in the middle": the list tells what these are."""

from __future__ import annotations

from itertools import pairwise

from rpg.language.meaning import Absolute, Chain, Clause, Coord, Into, Meaning, Noun, Traits, replace


def recounted(chain: Chain) -> Chain:
    """The sentence with such a list, and what is said of its places, where the blocks are counted."""
    for n, (one, two) in enumerate(pairwise(chain.clauses)):
        if isinstance(one, Clause) and isinstance(two, Clause) and chain.links[n + 1] == "and" and _again(one, two):
            whole = replace(one, theme=two.theme, adjuncts=(*one.adjuncts, *two.adjuncts))
            clauses, links = [*chain.clauses], [*chain.links]
            clauses[n : n + 2], links[n : n + 2] = [whole], links[n : n + 1]
            return replace(chain, clauses=tuple(clauses), links=tuple(links))
    return chain


def _again(one: Clause, two: Clause) -> bool:
    """Whether the second clause, of the same verb, lists as many blocks and tells of places among them alone."""
    many = _count(one.theme) if isinstance(one.theme, Noun) and one.theme.traits == Traits() else 0
    into = [x for x in one.adjuncts if isinstance(x, Into)]
    if not many or len(into) != 1 or one.word is None or one.word != two.word or one.negated or two.negated:
        return False
    listed = two.theme.items if isinstance(two.theme, Coord) and two.theme.op == "and" else ()
    counts = [_count(x) for x in listed if isinstance(x, Noun) and x.traits.colors + x.traits.labels]
    parts = [y for x in two.adjuncts for y in (x.items if isinstance(x, Coord) and x.op == "absolutes" else (x,))]
    told = bool(parts) and all(isinstance(x, Absolute) for x in parts)
    return told and len(counts) == len(listed) > 1 and 0 not in counts and sum(counts) == many


def _count(noun: Meaning | None) -> int:
    """So many blocks that are new; 0 for others."""
    if not isinstance(noun, Noun) or noun.head == "patch" or noun.det not in ("bare", "a") or noun.part_of:
        return 0
    if noun.amount is None:
        return int(noun.det == "a" and not noun.plural)
    return noun.amount.low if noun.amount.low == noun.amount.high else 0
