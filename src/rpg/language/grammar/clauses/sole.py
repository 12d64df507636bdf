""" "The red block should be the only block on the mat": it is there, and no other block is."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.clauses.adjuncts import adjuncts
from rpg.language.grammar.core import Parser, Results
from rpg.language.meaning import Clause, Coord, In, Loc, Meaning, Noun

_SOLE = tuple(
    f"the {only} {block}"
    for only in ("only", "sole", "single")
    for block in ("block", "cube", "brick", "one", "thing", "object", "blocks", "cubes", "bricks", "ones", "things")
)


def sole(p: Parser, i: int, j: int, theme: Meaning, mode: str) -> Results[Clause]:
    """What is said after "is": "the only block on the mat", "the only ones in the left half"."""
    k = p.any_of(j, _SOLE)
    for found, end in adjuncts(p, k) if k and isinstance(theme, Noun | Coord) else ():
        place = found[0] if len(found) == 1 else None
        if isinstance(place, In) or (isinstance(place, Loc) and place.landmark is not None):
            alone = Coord(op="only", items=(theme,), span=theme.span)
            yield Clause(verb="be", theme=alone, adjuncts=found, mode=mode, span=p.span(i, end)), end


_ASSERTED = frozenset({"is", "are", "should", "must", "shall", "may", "has", "have", "goes", "go", "touches", "touch",
                       "belongs", "belong", "stands", "stand", "lies", "lie", "faces", "face"})  # fmt: skip


def just_these(p: Parser, j: int) -> bool:
    """ "Just the red block is on the mat": no other is; "just put it there", "just red on blue" say no more by it."""
    if p.words[j - 1] != "just" or _ASSERTED.isdisjoint(p.words[j:]):
        return False
    return p.words[j] in ("the", "these", "those") or p.words[j] in lexicon.COLOR or p.tokens[j].raw.isupper()
