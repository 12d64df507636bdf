""" "The red block occupies the blue mat", "the far left corner is occupied by a green cube": it is there."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.places.regions import named_regions
from rpg.language.grammar.things.nouns import noun_phrase, simple
from rpg.language.meaning import Chain, Clause, Coord, In, Loc, Meaning, Noun, Structure, That, replace

_TOLD = frozenset({"occupied", "occupies", "occupy", "occupying", "taken", "reserved", "filled", "covered"})
_OCCUPIES = tuple(
    f"{must}{verb}"
    for must in ("", "should ", "must ", "shall ", "has to ", "have to ", "is to ", "are to ", "will ", "both ", "all ")
    for verb in ("occupy", "occupies")
)
_BY = tuple(
    f"{be}{verb}"
    for be in ("", "is ", "are ", "should be ", "must be ", "shall be ", "has to be ", "is to be ", "will be ", "gets ")
    for verb in ("occupied by", "taken by", "taken up by", "reserved for", "filled by", "filled with")
)
_COVERED = tuple(
    f"{be}{verb}"
    for be in ("is ", "are ", "should be ", "must be ", "shall be ", "has to be ", "is to be ", "will be ", "gets ")
    for verb in ("covered by", "covered with")
)
"""Of patches alone: what covers a block lies on it and on nothing else."""


@choice
def occupied(p: Parser, i: int, mode: str) -> Results[Meaning]:
    """Blocks and the patch or the region that they take up, in either order."""
    if not p.rarely(_TOLD):
        return
    for theme, j in noun_phrase(p, i):
        start = p.any_of(j, _OCCUPIES) if isinstance(theme, Noun | Coord | Structure) else 0
        for place, end in _place(p, start) if start else ():
            yield _there(p, i, end, theme, place, mode), end
    for place, j in _place(p, i):
        start = p.any_of(j, _BY) or (p.any_of(j, _COVERED) if isinstance(place, Loc) else 0)
        for theme, end in noun_phrase(p, start) if start else ():
            if isinstance(theme, Noun | Coord | Structure):
                told = _there(p, i, end, theme, place, mode)
                yield told, end
                yield from _and_next(p, i, end, told, p.words[start - 1])


def _and_next(p: Parser, i: int, at: int, first: Clause, by: str) -> Results[Clause]:
    """ "(the far half is reserved for red,) the near half for blue": a second place with what is there."""
    joint = p.opt(p.opt(at, ",", ";"), "and", "while")
    for place, j in _place(p, joint) if joint > at else ():
        for theme, end in noun_phrase(p, p.one(j, by)) if p.stands(j, (by,)) else ():
            if isinstance(theme, Noun | Coord | Structure):
                second = replace(_there(p, joint, end, theme, place, first.mode), cost=0)
                told = That(kind="so", clauses=Chain(clauses=(second,), links=("and",), span=second.span),
                            span=second.span)  # fmt: skip
                yield replace(first, adjuncts=(*first.adjuncts, told), span=p.span(i, end)), end


def _place(p: Parser, i: int) -> Results[Meaning]:
    """What may be occupied, as the place that is there."""
    for patch, j in simple(p, i):
        if isinstance(patch, Noun) and patch.head == "patch":
            yield Loc(rel="on", landmark=patch, span=p.span(i, j)), j
    start = p.one(i, ("the", "a", "one")) or i
    for name, j in named_regions(p, start):
        yield In(region=name, vague=name in ("corner", "edge"), span=p.span(i, j)), j


def _there(p: Parser, i: int, end: int, theme: Meaning, place: Meaning, mode: str) -> Clause:
    verb = "build" if isinstance(theme, Structure) else "be"
    return Clause(verb=verb, theme=theme, adjuncts=(place,), mode=mode, span=p.span(i, end), cost=1)
