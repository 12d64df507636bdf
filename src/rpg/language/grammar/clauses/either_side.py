"""What belongs to which side of "either ..., or ...": what is joined by "and" there is one side of it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language.grammar.core import Parser, Results
from rpg.language.later import later
from rpg.language.meaning import Chain, replace

if TYPE_CHECKING:
    from rpg.language.grammar.clauses.chains import chain
else:
    (chain,) = later(__name__, "rpg.language.grammar.clauses.chains", "chain")


def alternatives(p: Parser, i: int, had: tuple[Chain, ...] = ()) -> Results[Chain]:
    """ "either A and B, or C and D": the clauses of each side belong together."""
    for part, j in chain(p, i):
        if set(part.links) != {"and"} or any(p.words[at : at + 2] == [",", "and"] for at in range(i, j)):
            continue
        if "," in p.words[i:j] and "and" not in p.words[i:j]:
            continue  # "either A, B, or C": one of three
        found = (*had, part)
        if k := p.seq(j, ", or"):
            yield from alternatives(p, k, found)
        if len(found) > 1:
            links = ("and", *("or" for _ in had))
            yield Chain(clauses=found, links=links, span=p.span(i, j)), j


def two_sides(p: Parser, i: int, flat: Chain, j: int) -> Chain:
    """ "either A is on the patch, or B is and C is on A": what "and" joins behind the comma is one side; other chains
    stay as they are."""
    words, at = p.words[i:j], flat.links.index("or") if flat.links.count("or") == 1 else 0
    pairs = [words[n : n + 2] for n in range(len(words))]
    listed = "and" not in words or [",", "and"] in pairs  # "either A, B, or C": one of three
    if not at or {*flat.links} != {"and", "or"} or [",", "or"] not in pairs or listed:
        return flat
    sides = (flat.clauses[:at], flat.clauses[at:])
    if max(map(len, sides)) == 1:
        return flat
    told = tuple(Chain(clauses=side, links=("and",) * len(side), span=flat.span) for side in sides)
    return replace(flat, clauses=told, links=("and", "or"))
