"""What lies on a landmark: "left of a black block with a white one on it" has the white one on the black."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.grammar.core import Parser
from rpg.language.grammar.places.borne import BEARING
from rpg.language.meaning import Absolute, Amount, At, Clause, Coord, Loc, Meaning, Noun, Pronoun, replace

SIDES = frozenset({"left", "right", "front", "behind", "beside", "adjacent", "near", "touching"})
_THAT = frozenset({"that", "which"})
BORNE = frozenset(lead.split()[0] for lead in BEARING)
LEADS = _THAT | BORNE | {"with", "having"}


def of_its(found: Meaning, first: Meaning) -> Meaning:
    """ "Next to the mat, on its right side, put a red block": on the right of the mat."""
    mark = first.landmark if isinstance(first, Loc) else None
    side = found.adjuncts[-1] if isinstance(found, Clause) and found.adjuncts else None
    theme = found.theme.span[0] if isinstance(found, Clause) and found.theme is not None else -1
    it = isinstance(side, Loc) and isinstance(side.landmark, Pronoun) and side.landmark.word == "it"
    if not it or not isinstance(found, Clause) or not isinstance(side, Loc) or not isinstance(mark, Noun):
        return found
    if side.span[0] > theme:
        return found
    known = replace(mark, det="the", amount=None, cost=0)
    return replace(found, adjuncts=(*found.adjuncts[:-1], replace(side, landmark=known)))


def held(p: Parser, j: int, first: Meaning, second: Meaning) -> Absolute | None:
    """What is said at `j` to lie on the landmark of the place before it, with that in the place of "it".

    Behind "on the blue block", "with a white one on it" may be said of what lies there; "that has ..." is not.
    """
    mark = first.landmark if isinstance(first, Loc) and not first.negated else None
    if not isinstance(first, Loc) or not isinstance(mark, Noun) or mark.plural:
        return None
    that = p.stands(j, _THAT)
    if (mark.head == "patch" and first.rel not in SIDES and not that) or not p.stands(j, LEADS):
        return None
    if not (first.rel in SIDES or that):
        return None
    if not isinstance(second, Absolute) or len(second.adjuncts) != 1 or mark.amount not in (None, Amount(1, 1)):
        return None
    place = second.adjuncts[0]
    it = replace(mark, det="the", amount=None, cost=0)
    if isinstance(place, At) and (place.side, place.index, place.whole) == ("top", None, None) and mark.det != "bare":
        on = Loc(rel="on", landmark=it, span=place.span)  # "next to a blue block with a white one on top"
        return replace(second, adjuncts=(on,), cost=0)
    there = isinstance(place, Loc) and (place.rel == "on" or (place.rel in SIDES and mark.head == "patch" and that))
    if not there or not isinstance(place, Loc) or not isinstance(place.landmark, Pronoun):
        return None
    return replace(second, adjuncts=(replace(place, landmark=it),)) if place.landmark.word == "it" else None


def of_the_second(p: Parser, j: int, first: Meaning, second: Meaning) -> bool:
    """ "A left of B and C right of D": two blocks, and right behind them where it stands to a third one: that is said
    of the second of them, which begins a clause."""
    if not (isinstance(first, Loc) and isinstance(second, Loc)) or p.words[j] in (",", "and"):
        return False
    mark, other = first.landmark, second.landmark
    begin = next(n for n in range(j) if p.tokens[n].span[0] == first.span[0])
    of_two = first.rel == "between" or "both" in p.words[begin:j]
    if of_two or not isinstance(other, Noun) or other.head == "patch":
        return False
    if isinstance(mark, Coord):
        last = mark.items[-1]
        return mark.op == "and" and len(mark.items) == 2 and isinstance(last, Noun) and not last.plural
    return isinstance(mark, Noun) and len(mark.traits.labels) == 2 and p.words[j - 2] == "and"


def of_the_mark(p: Parser, j: int, first: Meaning, second: Meaning) -> bool:
    """ "(on each patch) that has a blue block beside it": what is said of a patch, and not of what lies on it."""
    patch = isinstance(first, Loc) and isinstance(first.landmark, Noun) and first.landmark.head == "patch"
    return patch and isinstance(second, Absolute) and p.stands(j, _THAT)


THE_ONE = ("the block", "the cube", "the one")


def by_block(p: Parser, place: Meaning) -> Loc | None:
    """A place that a block tells: "(the block) under the red one", unless it may be a part of what was told before."""
    mark = place.landmark if isinstance(place, Loc) and not place.negated else None
    known = not isinstance(mark, Noun) or mark.head == "patch" or mark.plural
    if known or not isinstance(place, Loc) or p.char(0, 0) or not p.all.isdisjoint(lexicon.STRUCTURE):
        return None
    return replace(place, mods=(*place.mods, "directly")) if place.rel in ("under", "above") else place
