"""Two relations to one landmark: "to the left or to the right of it", "not behind it but in front of it"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results, choice
from rpg.language.grammar.places.prepositions import CLOSE, DIRECT, relation, side_relation
from rpg.language.grammar.things.nouns import noun_phrase
from rpg.language.meaning import Coord, Loc, Meaning, Noun, PartOf, Structure, TableTop, replace

_BUT_NOT = (", but not", "but not", ", not", ", yet not", "yet not", "and not", ", and not", ", though not",
            "though not", "without", "rather than", "instead of", "as opposed to", ", rather than")  # fmt: skip


@choice
def either_relation(p: Parser, i: int) -> Results[Meaning]:
    """ "to the left or to the right of", "left of and behind": two relations with one landmark."""
    start = p.one(i, "either") or i
    firsts = [(name, mods, j) for (name, mods), j in relation(p, start)]
    for mods, at in _told_how(p, start):
        firsts += [(side.rstrip("?"), mods, j) for (side, _), j in side_relation(p, at)]
        firsts += [(_UNLINKED[side], mods, j) for side in _UNLINKED if (j := p.seq(at, side))]
    for first, own, j in firsts:
        denied = p.any_of(j, _BUT_NOT)
        k = denied or p.one(j, ("or", "and"))
        op = "and" if denied else p.words[j] if k else ""
        for (second, mods), m in relation(p, k) if k else ():
            for landmark, end in noun_phrase(p, p.opt(m, ",") if denied else m):
                if isinstance(landmark, TableTop):
                    continue
                span = p.span(i, end)
                mods = mods or own if op == "or" else mods  # "directly left or right of it"
                parts = (
                    Loc(rel=first, landmark=landmark, mods=own, span=span),
                    Loc(rel=second, landmark=brought_up(landmark), mods=mods, negated=denied > 0, span=span),
                )
                yield Coord(op=op, items=parts, span=span), end


def _told_how(p: Parser, i: int) -> list[tuple[tuple[str, ...], int]]:
    """How close a side is meant, and where that side is told."""
    close = [(("directly",), p.one(i, DIRECT)), (("immediate",), p.one(i, CLOSE))]
    return [((), i), *((mods, j) for mods, j in close if j)]


_UNLINKED = {"left": "left", "right": "right", "in front": "front"}
"""Sides that are told before the one that says of what: "left or right of it"."""
_BUT = ("but rather", "but instead", "but", ", but rather", ", but instead", ", but", ", rather", ", instead")


@choice
def not_but(p: Parser, i: int) -> Results[Coord]:
    """ "not to the right but to the left of the black one": the landmark behind the second of them is that of both."""
    start = p.one(i, "not")
    sides = [(side.rstrip("?"), j) for (side, _), j in side_relation(p, start)] if start else []
    for side, j in [*sides, ("front", p.seq(start, "in front"))] if start and p.rarely(_CONTRASTING) else ():
        k = p.any_of(j, _BUT) if j else 0
        for (second, mods), m in relation(p, k) if k else ():
            for landmark, end in noun_phrase(p, m):
                span = p.span(i, end)
                denied = Loc(rel=side, landmark=brought_up(landmark), negated=True, span=span)
                placed = Loc(rel=second, landmark=landmark, mods=mods, span=span)
                yield Coord(op="and", items=(placed, denied), span=span), end


_CONTRASTING = frozenset({"but", "rather", "instead"})


@choice
def and_from(p: Parser, i: int, far: Meaning, j: int) -> Results[Coord]:
    """ "(at least 15 cm from the red block) and from each other": as far from both."""
    k = p.any_of(j, _AND_FROM)
    if not k or not isinstance(far, Loc) or far.rel not in ("apart", "distance") or far.landmark is None:
        return
    for landmark, end in noun_phrase(p, k):
        other = replace(far, landmark=landmark, cost=0, span=p.span(j, end))
        yield Coord(op="and", items=(far, other), span=p.span(i, end)), end


_AND_FROM = ("and from", "and also from", "and away from", "as well as from", ", and from", "and apart from")


def brought_up(thing: Meaning) -> Meaning:
    """ "(Behind or in front of) a row of three": where it is spoken of once more it is that row, and no other one."""
    if isinstance(thing, PartOf) and thing.whole is not None:
        return replace(thing, whole=brought_up(thing.whole))
    if isinstance(thing, Noun) and isinstance(thing.part_of, Structure):
        return replace(thing, part_of=brought_up(thing.part_of))
    new = isinstance(thing, Noun | Structure) and thing.det in ("a", "bare")
    return replace(thing, det="the") if new else thing
