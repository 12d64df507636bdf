""" "Red to the left and green to the right of the blue block": both are sides of that."""

from __future__ import annotations

from itertools import pairwise

from rpg.language.meaning import At, Chain, Clause, Loc, Meaning, Noun, Structure, replace

_ACROSS = {
    "left": ("left", "right"), "right": ("right", "left"), "front": ("front", "behind"), "back": ("behind", "front"),
}  # fmt: skip
"""By a side that is told of nothing: the relation that it is, and the one that has to follow."""


def shared_sides(chain: Chain, text: str) -> Chain:
    """The sentence with what such a side is of, where the next clause, of the same verb, tells of the opposite one.

    "On the left, and green to the right of blue" is told in other words: that may be the left of the table.
    """
    clauses = list(chain.clauses)
    for n, (one, two) in enumerate(pairwise(chain.clauses)):
        if chain.links[n + 1] == "and" and (told := _of_the_same(one, two, text)) is not None:
            clauses[n : n + 2] = told
    return chain if tuple(clauses) == chain.clauses else replace(chain, clauses=tuple(clauses))


def _of_the_same(one: Meaning, two: Meaning, text: str) -> tuple[Clause, Clause] | None:
    if not isinstance(one, Clause) or not isinstance(two, Clause) or one.word != two.word or one.negated or two.negated:
        return None
    side, place = (x.adjuncts[0] if len(x.adjuncts) == 1 else None for x in (one, two))
    bare = isinstance(side, At) and side.index is None and side.whole is None and not side.own
    if not bare or not isinstance(side, At) or not isinstance(place, Loc) or place.negated or place.mods:
        return None
    rel, opposite = _ACROSS.get(side.side, ("", ""))
    mark = place.landmark
    if place.rel != opposite or place.low or place.high or not isinstance(mark, Noun | Structure) or mark.plural:
        return None
    words = {text[x.span[0] :].lower().partition(" ")[0] for x in (side, place)}
    if len(words) > 1 and rel in ("left", "right"):
        return None
    first = replace(one, adjuncts=(replace(place, rel=rel),))
    again = replace(mark, det="the", amount=None) if mark.det == "a" else mark
    return first, replace(two, adjuncts=(replace(place, landmark=again),))
