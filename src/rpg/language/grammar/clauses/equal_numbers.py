"""As many blocks on one patch as on another: "both patches have the same number of cubes on them"."""

from __future__ import annotations

from rpg.language.grammar.clauses.shared import all_patches, are_patches
from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import Clause, Coord, Loc, Meaning, Noun

EQUAL = "equal"
"""The lemma of such a clause."""
_TELLING = frozenset({"same", "equal", "equally", "as"})
_SAME = (
    *(f"the {exactly}same {number} of" for exactly in ("", "exact ") for number in ("number", "amount", "count")),
    "an equal number of", "an equal amount of", "equal numbers of", "equally many",
)  # fmt: skip
_AS = ("as many", "just as many", "exactly as many")
_HAVE = (
    *(f"{must}{both}{have}"
      for must in ("", "should ", "must ", "shall ", "to ", "has to ", "have to ", "will ")
      for both in ("", "both ", "each ", "all ", "end up with ")
      for have in ("have", "has", "hold", "holds", "carry", "carries", "contain", "contains", "get", "gets", "bear")),
    "with", "having", "ends up with", "end up with", "should end up with", "must end up with",
)  # fmt: skip
_ON_THEM = ("on them", "on it", "on each", "on top", "each", "on each of them", "in them")
_LEAD = ("put", "place", "set", "lay", "have", "get", "there is", "there are", "there must be", "there should be",
         "there has to be", "there shall be", "leave")  # fmt: skip
_IS = ("is", "are", "must be", "should be", "has to be", "lie", "lies", "have to be", "lying", "sit")
_ON = ("on", "onto", "in")
_AS_ON = ("as on", "as in", "as there are on", "as are on")


@rule
def equal_numbers(p: Parser, i: int) -> Results[Clause]:
    """The blocks that are counted, and the patches of which each has as many."""
    if not p.rarely(_TELLING):
        return
    for mark, j in noun_phrase(p, i):
        have = p.any_of(j, _HAVE) if _several(mark) else 0
        for blocks, k in _so_many(p, have, _SAME) if have else ():
            end = p.any_of(k, _ON_THEM) or k
            yield _clause(p, i, end, blocks, mark), end
    start = p.any_of(i, _LEAD) or i
    for blocks, j in _so_many(p, start, _SAME):
        on = p.any_of(p.any_of(j, _IS) or j, _ON)
        for mark, k in noun_phrase(p, on) if on else ():
            if _several(mark):
                yield _clause(p, i, k, blocks, mark), k
    for blocks, j in _so_many(p, start, _AS):
        on = p.any_of(p.any_of(j, _IS) or j, _ON)
        for mark, k in simple(p, on) if on else ():
            like = p.any_of(k, _AS_ON)
            for other, end in simple(p, like) if like else ():
                two = Coord(op="and", items=(mark, other), span=p.span(on, end))
                if are_patches(two):
                    yield _clause(p, i, end, blocks, two), end


def _so_many(p: Parser, i: int, told: tuple[str, ...]) -> Results[Noun]:
    """ "the same number of cubes", "equally many red blocks"; of red and blue ones it may be the colors that are
    equally many."""
    start = p.any_of(i, told)
    for blocks, j in simple(p, start) if start else ():
        plain = isinstance(blocks, Noun) and blocks.head == "block" and blocks.plural and blocks.part_of is None
        if plain and isinstance(blocks, Noun) and len(blocks.traits.colors) < len(("the one", "the other")):
            yield blocks, j


def _several(mark: Meaning) -> bool:
    """Several patches of which each has so many."""
    if isinstance(mark, Noun) and mark.head == "patch" and mark.det == "each":
        return True
    return are_patches(mark)


def _clause(p: Parser, i: int, end: int, blocks: Noun, mark: Meaning) -> Clause:
    on = Loc(rel="on", landmark=all_patches(mark), span=mark.span)
    return Clause(verb="place", lemma=EQUAL, theme=blocks, adjuncts=(on,), mode="goal", span=p.span(i, end))
