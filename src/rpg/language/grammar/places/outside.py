"""Places where something is not: "outside of the mat", "out of the right half", "neither left of it nor behind it"."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rpg.language.grammar.core import Parser, Results, choice, rule
from rpg.language.grammar.places.prepositions import side_relation
from rpg.language.grammar.places.regions import named_regions
from rpg.language.grammar.things.nouns import simple
from rpg.language.later import later
from rpg.language.meaning import Coord, In, Loc, Meaning, Noun, Pronoun, parts_of, replace

if TYPE_CHECKING:
    from rpg.language.grammar.places.relations import loc
else:
    (loc,) = later(__name__, "rpg.language.grammar.places.relations", "loc")

_OUT = (
    "outside of", "outside", "out of", "beyond the edge of", "clear of", "anywhere outside", "anywhere outside of",
    "anywhere but on", "anywhere except on", "somewhere outside", "somewhere outside of", "not inside", "away off",
    *(f"{where} {but}{on}" for where in ("anywhere", "somewhere") for on in ("", " in", " at", " on")
      for but in ("but", "except", "except for", "other than")),
)  # fmt: skip
_NOT_ON = tuple(
    f"{where} {no}{on}"
    for where in ("anywhere", "somewhere", "any place", "a place", "a spot", "anyplace", "any spot", "someplace")
    for no in ("that is not", "which is not", "not", "but not", "other than", "except", "but", "where there is not")
    for on in ("", " on")
)
"""Behind these is no place for it: "anywhere that is not a patch"."""


_BOUNDS = tuple(
    f"{within}{the}{bounds} of"
    for within in ("within ", "inside ", "inside of ", "in ", "into ")
    for the in ("the ", "")
    for bounds in ("boundary", "boundaries", "bounds", "border", "borders", "confines", "limits", "outline",
                   "perimeter", "area", "square", "frame")
)  # fmt: skip
"""Of a patch these say no more than that it is on it."""
_OFF = ("off", "outside", "inside")
"""Behind these the patch that was spoken of may be left out: "red on the mat, blue and green off"."""
_ENDS = frozenset({",", ";", "and", "but", "please", "at"})
_TOUCHING_NONE = (
    "touching neither", "touching neither of them", "touching neither of the two", "touching none of them",
    "but touching neither",
)  # fmt: skip


@rule
def outside(p: Parser, i: int) -> Results[Meaning]:
    """ "outside of the mat", "out of the right half"; "(between A and B,) touching neither"."""
    if j := p.any_of(i, _TOUCHING_NONE):
        them = Pronoun(word="them", span=p.span(i, j))
        yield Loc(rel="touching", landmark=them, negated=True, span=p.span(i, j)), j
    if (j := p.any_of(i, _OFF)) and i > 0 and (j >= p.end or p.stands(j, _ENDS)):
        there = Pronoun(word="there", span=p.span(i, j))
        rel, mods = ("in", ()) if p.words[i] == "inside" else ("off", ("outside",))
        yield Loc(rel=rel, landmark=there, mods=mods, span=p.span(i, j), cost=2), j
    yield from _not_on(p, i)
    within = p.any_of(i, _BOUNDS)
    for mark, k in simple(p, within) if within else ():
        if isinstance(mark, Noun) and mark.head == "patch":
            yield Loc(rel="in", landmark=mark, span=p.span(i, k)), k
    j = p.any_of(i, _OUT)
    if not j:
        return
    for mark, k in simple(p, j):
        patch = isinstance(mark, Noun) and mark.head == "patch"
        if patch or (isinstance(mark, Pronoun) and mark.word in ("it", "them", "there")):
            mods = () if patch else ("outside",)
            taken = int(not patch and p.stands(k, ("and",)))  # "take it out of it and put it ..."
            yield Loc(rel="off", landmark=mark, mods=mods, span=p.span(i, k), cost=taken), k
    for region, k in named_regions(p, p.opt(j, "the")):
        yield In(region=region, negated=True, span=p.span(i, k)), k


def _not_on(p: Parser, i: int) -> Results[Meaning]:
    """ "anywhere that is not a patch", "in a place that is not on the red patch"."""
    j = p.any_of(p.opt(i, "to", "in", "on", "at"), _NOT_ON)
    for mark, k in simple(p, j) if j else ():
        if isinstance(mark, Noun) and mark.head == "patch":
            yield Loc(rel="on", landmark=mark, negated=True, span=p.span(i, k)), k


_ACROSS = ("left", "right", "front", "behind")


@choice
def neither(p: Parser, i: int) -> Results[Meaning]:
    """ "neither on the red block nor behind it", "neither to the left nor to the right of the blue block"."""
    start = p.one(i, "neither")
    if not start:
        return
    sided = [(Loc(rel=s.rstrip("?"), span=p.span(i, j)), p.opt(j, "of")) for (s, _), j in side_relation(p, start)]
    for one, j in [*loc(p, start), *sided]:
        nor = p.one(p.opt(j, ","), "nor")
        for two, k in loc(p, nor) if nor else ():
            first = one
            if isinstance(one, Loc) and one.landmark is None and isinstance(two, Loc) and two.rel in _ACROSS:
                first = replace(one, landmark=two.landmark)
            if (
                isinstance(first, Loc | In)
                and isinstance(two, Loc | In)
                and getattr(first, "landmark", two) is not None
            ):
                both = (replace(first, negated=True), replace(two, negated=True))
                if not any(isinstance(x, Pronoun) and x.word == "each other" for x in parts_of(both)):
                    yield Coord(op="and", items=both, span=p.span(i, k)), k
