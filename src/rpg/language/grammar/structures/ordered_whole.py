"""Where a structure is, once its order was told: "the tower of red and blue, from bottom to top, is on the mat"."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.places.sides import toward
from rpg.language.grammar.structures.orders import order
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.later import later
from rpg.language.meaning import Clause, Coord, In, Loc, Meaning, Noun, OrderBy, Structure, Toward

if TYPE_CHECKING:
    from rpg.language.grammar.clauses.adjuncts import adjuncts
    from rpg.language.grammar.structures.structures import structure
else:
    (adjuncts,) = later(__name__, "rpg.language.grammar.clauses.adjuncts", "adjuncts")
    (structure,) = later(__name__, "rpg.language.grammar.structures.structures", "structure")

_BE = "situated|located|placed|positioned|put|standing|found|built|set"
_IS = Patterns(
    f"is|are|stands|lies|rests|sits {_BE}?",
    f"must|should|shall|will|has_to|needs_to|ought_to|is_to be {_BE}?",
    "must|should|shall|will|has_to|needs_to|ought_to|is_to stand|lie|rest|sit|end_up|go",
    "goes|belongs|comes",
)
_TOLD = frozenset({"order", "from", "sequence", "left", "right", "top", "bottom", "front", "back"})


@choice
def ordered_whole(p: Parser, i: int) -> Results[Clause]:
    """A structure, the order of its blocks, and then where it is."""
    if not p.rarely(_TOLD):
        return
    for whole, j in structure(p, i):
        if not isinstance(whole, Structure) or not _several(whole.members):
            continue
        verb = "be" if whole.det == "the" else "build"
        for told, k in _orders(p, p.opt(j, ",")):
            for start in _IS.matches(p, p.opt(k, ",")) if told else ():
                for places, end in adjuncts(p, start):
                    if places and all(isinstance(x, Loc | In) for x in places):
                        parts, span = (*told, *places), p.span(i, end)
                        yield Clause(verb=verb, theme=whole, adjuncts=parts, mode="goal", span=span), end


def _several(members: Meaning | None) -> bool:
    """Blocks that are told one by one."""
    told = members.traits.colors + members.traits.labels if isinstance(members, Noun) else ()
    return isinstance(members, Coord) or len(told) > 1


def _orders(p: Parser, i: int) -> Iterator[tuple[tuple[Meaning, ...], int]]:
    """ "in that order", "from bottom to top", "in that order from the top down"."""
    for first, j in (*order(p, i), *toward(p, i)):
        if isinstance(first, OrderBy | Toward):
            yield (first,), j
            yield from (((first, way), k) for way, k in toward(p, p.opt(j, ",")) if isinstance(first, OrderBy))
            yield from (((first, way), k) for way, k in order(p, p.opt(j, ",")) if isinstance(first, Toward))
