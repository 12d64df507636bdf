"""How far something is moved which way, seen from where it starts: "10 cm to the right", "a bit to the left", "closer
to the robot", "5 cm closer to the blue block", "farther apart"."""

from __future__ import annotations

from collections.abc import Iterator

from rpg.language.grammar.core import Parser
from rpg.language.grammar.places.measures import bounds
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.amounts import block_widths
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import At, Loc, Manner, Meaning, Pronoun

_VERBS = frozenset(
    {"move", "push", "shift", "slide", "nudge", "drag", "pull", "bring", "shove", "moved", "pushed", "shifted", "slid"}
)
_ME = "robot|arm|robot_arm|robot_base|robot_'s_base|base_of_the_robot|camera|viewer"
_TO_ME = (f"the|my|your? {_ME}", "me|you|us")
_WAYS = {
    "left": Patterns("further|farther? to|toward|towards the|my|your? left side?", "further|farther? left",
                     "leftward|leftwards"),
    "right": Patterns("further|farther? to|toward|towards the|my|your? right side?", "further|farther? right",
                      "rightward|rightwards"),
    "back": Patterns("forward|forwards", "toward|towards|to the back|rear side?",
                     *(f"further|farther? away from {me}" for me in _TO_ME)),
    "front": Patterns("backward|backwards", "toward|towards|to the front side?",
                      *(f"closer|nearer? to|towards|toward {me}" for me in _TO_ME)),
}  # fmt: skip
_OFF = ("further|farther? away", "further|farther")
_BY_ITSELF = {
    "left": Patterns("leftward|leftwards", "further|farther|more to the left", "further|farther|more left"),
    "right": Patterns("rightward|rightwards", "further|farther|more to the right", "further|farther|more right"),
    "back": Patterns("forward|forwards", *(f"{how} from {me}" for how in _OFF for me in _TO_ME)),
    "front": Patterns("backward|backwards", *(f"closer|nearer to {me}" for me in _TO_ME),
                      *(f"towards|toward {me}" for me in _TO_ME)),
}  # fmt: skip
"""Ways that say by themselves that they are seen from where something is."""
_UNCLEAR = Patterns(
    "back|up|down|sideways|away",
    "to|toward|towards the|one|a? side|edge|middle|center",
    "closer|nearer|farther|further",
)
"""Which way this is depends on who says it."""
_CLOSER = {
    "approached": Patterns("closer|nearer to|toward|towards", "toward|towards"),
    "receded": Patterns("farther|further away? from"),
}
_MUTUAL = {
    "approached": Patterns("closer|nearer together", "closer|nearer to each_other|one_another"),
    "receded": Patterns("farther|further apart", "farther|further away? from each_other|one_another"),
}
_BIT = Patterns("by? just? a tiny|little|small|wee? bit|little|tad|few_centimeters|few_cm|smidge|touch|notch|smidgen",
                "by? slightly|somewhat", "just? a_couple_of centimeters|cm")  # fmt: skip
_STEPS = Patterns("by? one|two|three|a step|steps|block|blocks|cube|cubes|notch|notches",
                  "much|a_lot|far|way")  # fmt: skip
_HERE = Patterns(
    "of|from where it|they is|are|was|were|stands|lies|sits|starts|started|begins|began now|currently|initially?",
    "of|from its|their|the current|present|original|initial|start|starting|old|first? place|position|location|spot",
)
_NOT_BEHIND = frozenset({"of", "from", "than", "half", "end", "corner", "most", "edge"})
"""Before these a direction is a place beside something."""
LITTLE = 0.02
"""What "a bit" is at least, in metres."""
Told = tuple[float | None, float | None, str]
HERE = "here"
"""What marks a way that is said to be seen from where something is."""
OPEN: Told = (None, None, "")
_THAN = frozenset({"than"})


def shifted(p: Parser, i: int) -> Iterator[tuple[Meaning, int]]:
    """Such words at a place; "10 cm to the right of the blue block" is said of that block, and none of them."""
    if p.rarely(_COMPARED):
        yield from _mutual(p, i)
    if not p.rarely(_TELLING):
        return
    for told, far in how_far(p, i):
        for way, end in _way(p, far):
            if here := max(_HERE.matches(p, end), default=0):
                yield _loc(p, i, here, way, told, HERE), here
            elif not p.stands(end, _NOT_BEHIND):
                yield _loc(p, i, end, way, told), end
    yield from _without(p, i)
    yield from _closer(p, i)
    yield from _unclear(p, i)


_COMPARED = frozenset({"closer", "nearer", "farther", "further"})
_TELLING = _VERBS | {"where", "its", "their", "put", "place", "set", "be"}


def _without(p: Parser, i: int) -> Iterator[tuple[Meaning, int]]:
    """The way before how far, or no word of how far at all."""
    for way, end in _way(p, i):
        for told, far in how_far(p, p.opt(end, ",")):
            yield _loc(p, i, far, way, told), far
    for way, patterns in _BY_ITSELF.items():
        for end in patterns.matches(p, i):
            if not p.stands(end, _NOT_BEHIND):
                yield _loc(p, i, end, way, OPEN), end


def _way(p: Parser, i: int) -> Iterator[tuple[str, int]]:
    yield from ((way, end) for way, patterns in _WAYS.items() for end in patterns.matches(p, i))


def _closer(p: Parser, i: int) -> Iterator[tuple[Meaning, int]]:
    """ "5 cm closer to the blue block", "closer to the blue block by 5 cm"."""
    for told, start in (*how_far(p, i), (OPEN, i)):
        for rel, patterns in _CLOSER.items():
            for there in patterns.matches(p, start):
                for landmark, end in simple(p, there):  # what it is moved closer to
                    yield from _compared(p, i, end, rel, landmark, told)


def _mutual(p: Parser, i: int) -> Iterator[tuple[Meaning, int]]:
    """ "(push them) closer together", "a bit farther apart"."""
    for told, start in (*how_far(p, i), (OPEN, i)):
        for rel, patterns in _MUTUAL.items():
            for end in patterns.matches(p, start):
                yield from _compared(p, i, end, rel, Pronoun(word="each other", span=p.span(i, end)), told)


def _compared(p: Parser, i: int, end: int, rel: str, landmark: Meaning, told: Told) -> Iterator[tuple[Meaning, int]]:
    """A distance that changes; how far is said before it or behind it, or not at all."""
    if p.stands(end, _THAN):
        return
    for (low, high, how), j in ((told, end), *(how_far(p, end) if told is OPEN else ())):
        yield Loc(rel=rel, landmark=landmark, mods=(how,), low=low, high=high, span=p.span(i, j), cost=2), j


def _unclear(p: Parser, i: int) -> Iterator[tuple[Meaning, int]]:
    """What is read only to be told what it lacks: which way, or how far."""
    ends = [end for _, far in how_far(p, i) for end in _UNCLEAR.matches(p, far)]
    ends += [far for end in _UNCLEAR.matches(p, i) for _, far in how_far(p, end)]
    for far in _STEPS.matches(p, i):
        ends += [end for _, end in _way(p, far)]
    for _, end in _way(p, i):
        ends += _STEPS.matches(p, end)
    for end in ends:
        if not p.stands(end, _NOT_BEHIND):
            yield Manner(kind="shift", value=" ".join(p.words[i:end]), span=p.span(i, end), cost=3), end


def _loc(p: Parser, i: int, end: int, way: str, told: Told, *more: str) -> Loc:
    low, high, how = told
    said = [word for word in ("forward", "forwards", "backward", "backwards") if word in p.words[i:end]]
    return Loc(rel="shifted", mods=(way, how, *said, *more), low=low, high=high, span=p.span(i, end), cost=2)


def straight(p: Parser, i: int) -> Iterator[tuple[At, int]]:
    """ "(Move the red block) left": to the left."""
    if p.rarely(_VERBS) and (j := p.one(i, ("left", "right"))) and (j >= p.end or p.stands(j, _ENDS)):
        yield At(side=p.words[i], span=p.span(i, j), cost=1), j


_ENDS = frozenset({",", ";", "and", "then", "."})


def how_far(p: Parser, i: int) -> Iterator[tuple[Told, int]]:
    """How far: the least and the most of it, and the word of it where it is a vague one."""
    by = p.one(i, "by") or i
    for (low, high), j in bounds(p, by):
        yield (low, high, ""), j
    for metres, j in block_widths(p, by) if by > i else ():
        yield (round(max(0.0, metres - 0.01), 6), round(metres + 0.01, 6), ""), j
    for j in _BIT.matches(p, i):
        yield (LITTLE, None, " ".join(p.words[i:j])), j
