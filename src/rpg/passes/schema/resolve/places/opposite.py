""" "Red left of black and white on the opposite side of it": which side that is, by the one that was told before."""

from __future__ import annotations

from rpg.language.meaning import (
    Absolute,
    Chain,
    Clause,
    Coord,
    Loc,
    Meaning,
    Noun,
    Pronoun,
    Structure,
    That,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.things.world import refuse

_OPPOSITE = {"left": "right", "right": "left", "front": "behind", "behind": "front"}
_AGAIN = ("other side", "same side")


def opposite_sides(chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences with "left", "right", "in front", "behind" for sides that are told by another one."""
    if not any(isinstance(x, Loc) and x.rel in _AGAIN for chain in chains for x in parts_of(chain)):
        return chains
    sides = _Sides()
    return tuple(sides.chain(chain) for chain in chains)


class _Sides:
    """The side that was told last, and of what."""

    def __init__(self) -> None:
        self.rel = ""
        self.mark: Meaning | None = None
        self.beside: Meaning | None = None

    def chain(self, chain: Chain) -> Chain:
        clauses: list[Meaning] = []
        for clause in chain.clauses:
            if isinstance(clause, Clause):
                self.beside = None
                clause = replace(clause, adjuncts=tuple(self._told(x) for x in clause.adjuncts))
            clauses.append(clause)
        return replace(chain, clauses=tuple(clauses))

    def _told(self, part: Meaning) -> Meaning:
        if isinstance(part, Coord):
            return replace(part, items=tuple(self._told(x) for x in part.items))
        if isinstance(part, Absolute):
            return replace(part, adjuncts=tuple(self._told(x) for x in part.adjuncts))
        if isinstance(part, That) and isinstance(part.clauses, Chain):
            return replace(part, clauses=self.chain(part.clauses))
        if not isinstance(part, Loc):
            return part
        if part.rel in _AGAIN:
            return self._side(part)
        named = isinstance(part.landmark, Noun | Structure)
        it = isinstance(part.landmark, Pronoun) and part.landmark.word == "it"  # "next to the blue one, on its left"
        mark = part.landmark if named else self.beside if it else None
        if part.rel in _OPPOSITE and not part.negated and mark is not None:
            self.rel, self.mark = part.rel, mark
        self.beside = part.landmark if named else self.beside
        return part

    def _side(self, loc: Loc) -> Loc:
        mark, own = self.mark, loc.landmark
        it = own is None or (isinstance(own, Pronoun) and own.word == "it")
        if mark is None or not (it or _one(own, mark)):
            raise refuse("ambiguous", "it is not clear which side this is", loc.span,
                         "say 'to the left of' or 'to the right of'")  # fmt: skip
        known = replace(mark, det="the") if isinstance(mark, Noun | Structure) and mark.det == "a" else mark
        known = replace(known, amount=None) if isinstance(known, Noun) and not known.plural else known
        return replace(loc, rel=_OPPOSITE[self.rel] if loc.rel == "other side" else self.rel, landmark=known)


def _one(own: Meaning | None, mark: Meaning) -> bool:
    """Whether two phrases name the same block or tower."""
    if isinstance(own, Noun) and isinstance(mark, Noun):
        return own.traits == mark.traits and own.plural == mark.plural
    return isinstance(own, Structure) and isinstance(mark, Structure) and own.kind == mark.kind
