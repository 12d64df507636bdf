"""How far something is moved which way: "10 cm to the right", "a bit to the left", "closer to the robot". No goal says
this of where it started, and it is read only to be told so."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.core import Parser
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.amounts import length
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import At, Manner

_VERBS = frozenset({"move", "push", "shift", "slide", "nudge", "drag", "pull", "bring", "shove", "moved", "pushed"})
_WAY = Patterns(
    "to|toward|towards the|my|your? left|right|front|back|side|robot|camera|edge|middle|center side?",
    "left|right|forward|forwards|backward|backwards|back|up|down|away|sideways|closer|nearer|farther|further",
)
_CLOSER = Patterns("a_bit|a_little|much|slightly|somewhat? closer|nearer to|toward|towards",
                   "a_bit|a_little|much|slightly|somewhat? farther|further away? from",
                   "a_bit|a_little|slightly|somewhat|just towards|toward")  # fmt: skip
_CLOSER_TO = Patterns(
    "a_bit|a_little|slightly? closer|nearer to the|my|your? robot|arm|camera|viewer|edge|middle|me|you|us"
)
_BIT = Patterns("by? a tiny|little|small? bit|little|tad|few_centimeters|few_cm|smidge|touch|notch",
                "by? slightly|somewhat", "by? one|two|half_a|a block|cube width|widths|length|lengths?",
                "by? one|two|half_a|a block|cube|step|steps|blocks|cubes")  # fmt: skip
_FURTHER = frozenset({"of", "from", "than", "half", "end", "corner", "most"})
"""Behind these a direction is a place beside something."""


def shifted(p: Parser, i: int) -> Iterator[tuple[Manner, int]]:
    """Such words behind a verb of moving; "10 cm to the right of the blue block" is a place, and none of them."""
    if not p.rarely(_VERBS):
        return
    for far in _far(p, i):
        for end in _WAY.matches(p, far):
            if not p.stands(end, _FURTHER):
                yield Manner(kind="shift", span=p.span(i, end), cost=3), end
    for way in _WAY.matches(p, i):
        for end in _far(p, way):
            yield Manner(kind="shift", span=p.span(i, end), cost=3), end
    for end in _CLOSER_TO.matches(p, i):
        yield Manner(kind="shift", span=p.span(i, end), cost=3), end
    for start in _CLOSER.matches(p, i):
        for _, end in simple(p, start):  # what it is moved closer to
            if not p.stands(end, _FURTHER):
                yield Manner(kind="shift", span=p.span(i, end), cost=3), end


def straight(p: Parser, i: int) -> Iterator[tuple[At, int]]:
    """ "(Move the red block) left": to the left."""
    if p.rarely(_VERBS) and (j := p.one(i, ("left", "right"))) and (j >= p.end or p.stands(j, _ENDS)):
        yield At(side=p.words[i], span=p.span(i, j), cost=1), j


_ENDS = frozenset({",", ";", "and", "then", "."})


def _far(p: Parser, i: int) -> Iterator[int]:
    yield from (j for _, j in length(p, p.one(i, "by") or i))
    yield from _BIT.matches(p, i)
