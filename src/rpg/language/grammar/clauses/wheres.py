"""Places told by "where": "left of the black block is where the red one goes", "A should be where B is, and B where A
is"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.talk.slots import Patterns
from rpg.language.grammar.things.nouns import simple
from rpg.language.meaning import Clause, Coord, Meaning, Noun, Structure

_IS_WHERE = tuple(
    f"{that}{where}"
    for that in ("is ", "should be ", "that is ", "this is ")
    for where in ("where", "the place where", "the place for", "the spot where", "the spot for", "for",
                  "reserved for", "meant for")
)  # fmt: skip
_WANTED = ("i want", "we want", "i would like", "you should put", "you put", "to put", "you place", "i need",
           "i want to see", "there is", "there should be", "i want to have")  # fmt: skip
_GOES = ("goes", "should go", "should be", "must be", "must go", "belongs", "is", "has to be", "has to go", "to be",
         "stands", "lies", "comes", "should stand", "ends up", "should end up", "go", "belong", "are", "is to be",
         "is supposed to be", "is supposed to go", "to go", "sits", "lands", "should lie", "must end up",
         "is to end up", "sitting", "standing", "lying", "to sit", "to stand", "to lie", "to end up")  # fmt: skip
_TOLD = frozenset({"where"})


_FINDS = Patterns(
    "should|must|shall|will|is_to|has_to? find|have|take|get|finds|has|takes|gets its|their "
    "place|home|spot|position|seat|places|homes|spots|positions"
)
_OWN_PLACE = frozenset({"place", "home", "spot", "position", "seat", "places", "homes", "spots", "positions"})


def finds_its_place(p: Parser, i: int, j: int, place: Meaning, mode: str) -> Results[Clause]:
    """ "(On the green mat,) the red block finds its place": the place, and behind it what has it."""
    for theme, k in simple(p, j) if p.rarely(_OWN_PLACE) else ():
        end = max(_FINDS.matches(p, k), default=0)
        if end and isinstance(theme, Noun) and theme.head != "patch":
            yield Clause(verb="be", theme=theme, adjuncts=(place,), mode=mode, span=p.span(i, end), cost=1), end


@choice
def is_where(p: Parser, i: int, j: int, place: Meaning, mode: str) -> Results[Clause]:
    """A place, and behind it what goes there."""
    yield from finds_its_place(p, i, j, place, mode)
    start = p.any_of(j, _IS_WHERE)
    wanted = p.any_of(start, _WANTED) if start else 0
    for theme, k in simple(p, wanted or start) if start else ():
        if not isinstance(theme, Noun | Structure) or getattr(theme, "head", "") == "patch":
            continue
        goes = p.any_of(k, _GOES)
        if p.words[start - 1] == "where" and not (wanted or goes):
            continue
        verb = "build" if isinstance(theme, Structure) else "be"
        end = goes or k
        yield Clause(verb=verb, theme=theme, adjuncts=(place,), mode=mode, span=p.span(i, end), cost=1), end


_THERE = ("where", "exactly where", "right where", "at the place where", "to the place where", "to where")
_LIES = ("is now", "was before", "was at first", "was at the start", "is at the start", "is at first", "stands now",
         "is standing", "is", "was", "stands", "lies", "starts", "started", "is currently", "currently is",
         "was in the beginning", "is in the beginning")  # fmt: skip
_MUST = ("should end up", "must end up", "ends up", "should be", "must be", "is to be", "has to be", "goes",
         "should go", "must go", "moves", "is", "belongs", "shall be", "comes")  # fmt: skip


@choice
def trading_places(p: Parser, i: int) -> Results[Clause]:
    """Each of two goes where the other one is."""
    if not p.anywhere(_TOLD):
        return
    start = p.any_of(i, ("put", "place", "move", "set", "bring")) or i
    for one, j in simple(p, start):
        if not isinstance(one, Noun):
            continue
        for other, k in _where(p, p.any_of(j, _MUST) or j):
            joint = p.any_of(k, (", and", "and", ",", ", and put", "and put", "and the other way round"))
            if joint and p.words[joint - 1] == "round":
                yield _swap(p, i, joint, one, other), joint
            for again, m in simple(p, joint) if joint else ():
                for back, end in _where(p, p.any_of(m, _MUST) or m) if _same(again, other) else ():
                    if _same(back, one):
                        yield _swap(p, i, end, one, other), end


def _where(p: Parser, i: int) -> Results[Noun]:
    at = p.any_of(i, _THERE)
    for noun, j in simple(p, at) if at else ():
        if isinstance(noun, Noun) and (k := p.any_of(j, _LIES)):
            yield noun, k


def _same(one: Meaning, other: Meaning) -> bool:
    alike = isinstance(one, Noun) and isinstance(other, Noun)
    return alike and one.traits == other.traits and bool(one.traits.colors or one.traits.labels)  # type: ignore[attr-defined]


def _swap(p: Parser, i: int, end: int, one: Noun, other: Noun) -> Clause:
    both = Coord(op="and", items=(one, other), span=p.span(i, end))
    return Clause(verb="swap", lemma="swap", theme=both, span=p.span(i, end))
