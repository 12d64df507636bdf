"""Distances compared: "closer to red than to blue", "as far from red as from blue", "the nearest of all to it"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, rule
from rpg.language.grammar.places.measures import bounds
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Coord, Loc, Meaning, Noun, Pronoun, TableTop, replace

WORDS = frozenset({
    "closer", "nearer", "farther", "further", "closest", "nearest", "farthest", "furthest", "equally", "equidistant",
    "distance", "distances", "far", "close", "near",
})  # fmt: skip
"""Without one of these nothing is compared."""
NEARER = ("closer", "nearer", "less far", "less far away", "at a smaller distance", "at a shorter distance")
FARTHER = ("farther", "further", "farther away", "further away", "farther off", "further off", "less close",
            "less near", "more distant", "at a greater distance", "at a larger distance")  # fmt: skip
_NEARER_OF_TWO, _FARTHER_OF_TWO = NEARER[:2], FARTHER[:4]
NEAREST = ("closest", "nearest")
FARTHEST = ("farthest", "furthest", "farthest away", "furthest away", "most distant")
_LARGELY = ("much", "clearly", "far", "even", "strictly", "significantly", "somewhat", "a bit", "a little", "slightly",
            "still", "noticeably")  # fmt: skip
_ALL_THE_SAME = (
    *(f"{at}{same} distance{away}"
      for at in ("at ", "in ", "") for same in ("the same", "exactly the same", "an equal", "one and the same", "equal")
      for away in ("", " away")),
    *(f"{at}equal distances" for at in ("at ", "in ", "")), "at the same distances", "equidistant",
    *(f"{how}{equally}{far}" for how in ("", "exactly ") for equally in ("equally ",)
      for far in ("far", "far away", "far off", "close", "near", "distant")),
)  # fmt: skip
_JUST_AS = ("as", "just as", "exactly as", "about as", "precisely as")
_NEAR = frozenset({"nearer", "nearest"})
""" "Nearer the mat" does without "to"."""
_BOUNDS = {"at least as": "least", "at most as": "most"}
_AT_LEAST = frozenset({"at", "more", "no", "not", "over"})
_AS_FAR = ("far", "far away", "close", "near", "far off")
_TO = ("to", "from")
_IS = ("is", "are", "does", "do", "stands", "stand", "lies", "lie", "should be", "will be")
_IT_IS = ("it is", "they are", "it stands", "they stand", "it lies", "they lie", "is", "it 's")
_OF_ALL = ("of all", "of them all", "of all the blocks", "of all blocks", "of all of them", "among all blocks",
           "of all the cubes", "of all cubes")  # fmt: skip
_THE = ("the", "the one", "the block", "the cube")
_ONES = ("one", "block", "cube", "ones", "blocks", "cubes")


@rule
def compared(p: Parser, i: int) -> Results[Loc]:
    """A place told by distances from it and from something else."""
    if not p.rarely(WORDS):
        return
    j = p.any_of(i, _LARGELY) or i
    for rel, k in (("closer", p.any_of(j, NEARER)), ("farther", p.any_of(j, FARTHER))):
        yield from _than(p, i, k, rel) if k else ()
    for (low, high), k in bounds(p, i) if p.stands(i, _AT_LEAST) else ():
        if low is not None and high is None:
            for rel, m in (("closer", p.any_of(k, NEARER)), ("farther", p.any_of(k, FARTHER))):
                yield from ((replace(x, low=low), end) for x, end in (_than(p, i, m, rel) if m else ()))
    if no := p.one(i, "no"):
        for rel, k in (("closer", p.any_of(no, NEARER)), ("farther", p.any_of(no, FARTHER))):
            yield from ((replace(x, mods=(*x.mods, "no")), end) for x, end in (_than(p, i, k, rel) if k else ()))
    for phrase, as_ in p.standing(i, _BOUNDS):
        yield from ((replace(x, mods=(*x.mods, _BOUNDS[phrase])), end) for x, end in _as_far(p, i, as_))
    if (k := p.any_of(i, _ALL_THE_SAME)) and (to := p.any_of(k, _TO)):
        for mark, end in _ends(p, to):
            yield Loc(rel="as_far", landmark=mark, span=p.span(i, end)), end
            yield from _as_far_as(p, i, mark, end)
    if as_ := p.any_of(i, _JUST_AS):
        yield from _as_far(p, i, as_)
    the = p.any_of(i, _THE) or i
    for rel, k in (("closest", p.any_of(the, NEAREST)), ("farthest", p.any_of(the, FARTHEST))):
        yield from _most(p, i, k, rel) if k else ()
    if the > i:
        for rel, k in (("closest", p.any_of(the, _NEARER_OF_TWO)), ("farthest", p.any_of(the, _FARTHER_OF_TWO))):
            yield from _most(p, i, k, rel, two=True) if k else ()


def _than(p: Parser, i: int, j: int, rel: str) -> Results[Loc]:
    """ "(closer) to red than to blue", "... than the blue one is", "... than blue"."""
    for mark, k in marks(p, j):
        than = p.one(p.opt(k, ","), "than")
        it = (p.any_of(than, _IT_IS) or than) if than else 0
        if it and (to := p.any_of(it, _TO)):
            for other, end in _ends(p, to):
                yield Loc(rel=rel, landmark=mark, second=other, span=p.span(i, end)), end
        for other, end in _others(p, than) if than else ():
            if is_ := p.any_of(end, _IS):
                yield Loc(rel=rel, landmark=mark, second=other, mods=("other",), span=p.span(i, is_)), is_
            else:
                yield Loc(rel=rel, landmark=mark, second=other, mods=("either",), span=p.span(i, end)), end


def _as_far(p: Parser, i: int, j: int) -> Results[Loc]:
    """ "as far from red as (it is) from blue", "as far from red as the blue one (is)"."""
    mods = ("as",) if p.words[i] == "as" else ()
    k = p.any_of(j, _AS_FAR)
    mods = (*mods, "close") if p.stands(j, ("close", "near")) else mods
    for mark, m in marks(p, k) if k else ():
        yield from _as_far_as(p, i, mark, m, mods)


def _as_far_as(p: Parser, i: int, mark: Meaning, j: int, mods: tuple[str, ...] = ()) -> Results[Loc]:
    """ "(as far from red) as (it is) from blue", "... as the blue one (is)"."""
    as_ = p.one(j, "as")
    it = (p.any_of(as_, _IT_IS) or as_) if as_ else 0
    if it and (to := p.any_of(it, _TO)):
        for other, end in _ends(p, to):
            yield Loc(rel="as_far", landmark=mark, second=other, mods=mods, span=p.span(i, end)), end
    for other, end in _others(p, as_) if as_ else ():
        is_ = p.any_of(end, _IS)
        how, end = ("other", is_) if is_ else ("either", end)
        yield Loc(rel="as_far", landmark=mark, second=other, mods=(*mods, how), span=p.span(i, end)), end


def _most(p: Parser, i: int, j: int, rel: str, two: bool = False) -> Results[Loc]:
    """ "the closest (one) (of the three) to the patch", "... to the patch (of the three)"."""
    j = p.opt(j, *_ONES)
    for of, k in _among(p, j):
        for mark, m in marks(p, k):
            found = [(of, m)] if of is not None or two else _among(p, m)
            for among, end in found:
                yield Loc(rel=rel, landmark=mark, second=among, span=p.span(i, end)), end


def _among(p: Parser, i: int) -> list[tuple[Meaning | None, int]]:
    """ "of the three", "of all": among which ones; or nothing."""
    found: list[tuple[Meaning | None, int]] = [(None, i)]
    if k := p.any_of(i, _OF_ALL):
        return [(Pronoun(word="all", span=p.span(i, k)), k)]
    if of := p.one(i, ("of", "among")):
        found += [(mark, k) for mark, k in noun_phrase(p, of) if isinstance(mark, Noun | Coord | Pronoun)]
    return found


def marks(p: Parser, i: int) -> list[tuple[Meaning, int]]:
    """ "to the red block", "from it"."""
    to = p.any_of(i, _TO) or (i if p.follows(i, _NEAR) else 0)
    return _ends(p, to) if to else []


def _others(p: Parser, i: int) -> list[tuple[Meaning, int]]:
    """What else is so far: "(than) the blue one", and never "it is"."""
    if k := p.any_of(i, _ALL_OTHERS):
        return [(Pronoun(word="the others", span=p.span(i, k)), k)]
    return [(mark, end) for mark, end in _ends(p, i) if not isinstance(mark, Pronoun) or mark.word not in _ITSELF]


_ALL_OTHERS = tuple(
    f"{all_} {other}"
    for all_, others in (("any", ("other", "other block", "other cube", "other one", "of the others")),
                         ("every", ("other block", "other cube", "other one")),
                         ("all", ("others", "other blocks", "other cubes", "the others", "the other blocks",
                                  "the other cubes")),
                         ("each", ("of the others", "other block")),
                         ("the", ("others", "other blocks", "other cubes", "other ones")))
    for other in others
)  # fmt: skip
_ITSELF = ("it", "they", "them", "that", "each other")


def _ends(p: Parser, i: int) -> list[tuple[Meaning, int]]:
    return [(mark, end) for mark, end in noun_phrase(p, i) if not isinstance(mark, TableTop)]
