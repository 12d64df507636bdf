"""Blocks that are counted and then told one by one: "two white cubes, one on the purple patch and one on the other"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Clause, Noun, Traits

_LEADS = ("there are", "put", "place", "set", "i see", "i want", "we see", "you see", "i want to see", "i would like")
_JOINTS = (", of which", "of which", ", so that", "so that", ", with", ",", ":", "-", ";")
_FIRST = frozenset({"one", "two", "three", "1", "2", "3"})
_FURTHER = tuple(
    f"{link} {what}" for link in ("and", ",") for what in (*sorted(_FIRST), "the other", "another", "the rest")
)


def counted_ahead(p: Parser, i: int) -> Results[Clause]:
    """The blocks in front of what is told of one, and of another one, of them."""
    if i or not p.anywhere(_FIRST):
        return
    for whole, j in simple(p, p.any_of(i, _LEADS) or i):
        joint = p.any_of(j, _JOINTS)
        if not joint or joint >= p.end or p.words[joint] not in _FIRST or not _counted(whole):
            continue
        if any(p.any_of(k, _FURTHER) for k in range(joint + 2, p.end)):
            yield Clause(verb="exist", lemma="tally", theme=whole, mode="given", span=p.span(i, j)), joint


def _counted(whole: object) -> bool:
    """Several blocks of one look, named for the first time."""
    if not isinstance(whole, Noun) or whole.head != "block" or whole.det != "bare" or whole.amount is None:
        return False
    return (
        whole.amount.low == whole.amount.high
        and whole.amount.low > 1
        and whole.traits == Traits(colors=whole.traits.colors[:1])
    )
