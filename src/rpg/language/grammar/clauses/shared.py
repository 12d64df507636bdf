"""Blocks that are shared among patches: "divide the six blocks equally between the two patches"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Clause, Coord, Loc, Meaning, Noun, replace

SHARE = "share"
"""The lemma of such a clause."""
_VERBS = ("divide up", "divide", "split up", "split", "share out", "share", "deal out", "deal", "distribute")
_FIRST = frozenset({"divide", "split", "share", "deal", "distribute"})
_EQUALLY = ("equally", "evenly", "fairly", "in equal parts", "into equal parts", "into equal shares", "in equal shares",
            "half and half", "up equally", "up evenly", "out equally", "out evenly", "up")  # fmt: skip
_AMONG = ("between", "among", "amongst", "over", "across", "onto", "on to", "on", "to")
_SHARING = frozenset({"between", "among", "amongst"})
"""With others it must be said that the shares are equal: "distribute them on the patches" says nothing of how many."""


@rule
def shared(p: Parser, i: int) -> Results[Clause]:
    """A verb, the blocks, and the patches; what says that the shares are equal may stand in front or behind."""
    start = p.any_of(i, _VERBS) if p.stands(i, _FIRST) else 0
    for theme, j in noun_phrase(p, start) if start else ():
        if isinstance(theme, Noun) and (theme.head == "patch" or theme.part_of is not None):
            continue
        equally = p.any_of(j, _EQUALLY)
        lead = equally or j
        among = p.any_of(lead, _AMONG)
        for mark, k in noun_phrase(p, among) if among and isinstance(theme, Noun | Coord) else ():
            end = p.any_of(k, _EQUALLY) or k
            if not are_patches(mark) or (p.words[lead] not in _SHARING and not equally and end == k):
                continue
            on = Loc(rel="on", landmark=all_patches(mark), span=p.span(lead, k))
            yield (
                Clause(verb="place", lemma=SHARE, theme=theme, adjuncts=(on,), mode="command", span=p.span(i, end)),
                end,
            )


def are_patches(mark: Meaning | None) -> bool:
    """Several patches, and nothing else."""
    if isinstance(mark, Coord) and mark.op == "and":
        return all(isinstance(x, Noun) and x.head in ("patch", "any") for x in mark.items) and any(
            isinstance(x, Noun) and x.head == "patch" for x in mark.items
        )
    return isinstance(mark, Noun) and mark.head == "patch" and mark.plural and mark.part_of is None


def all_patches(mark: Meaning) -> Meaning:
    """ "The red and the blue patch": two patches."""
    items = mark.items if isinstance(mark, Coord) else ()
    patches = tuple(replace(x, head="patch") if isinstance(x, Noun) else x for x in items)
    return replace(mark, items=patches) if isinstance(mark, Coord) else mark
