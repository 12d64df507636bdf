"""What "not" denies of a clause."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.language.meaning import Clause, Coord, In, Loc
from rpg.passes.schema.resolve.logic import Atoms, conj, negation
from rpg.passes.schema.resolve.world import Scene, refuse, wholes


def denied(goals: Atoms, clause: Clause, scene: Scene, together: bool) -> Atoms:
    """The opposite of what a clause states. `together`: "not both", "not all", where some of it may be so."""
    if together:
        return [g.Not(goal=conj(goals, clause.span), span=clause.span)] if goals else []
    places = [place for place in clause.adjuncts if isinstance(place, Loc | In) and not place.negated]
    open_ = any(isinstance(place, Loc) and isinstance(place.landmark, Coord) for place in places)
    if len(places) > 1 and not open_:
        raise refuse("ambiguous", "it is not clear whether each of these is denied, or both together", places[1].span,
                     "say 'neither ... nor', or 'not both'")  # fmt: skip
    return negation(goals, clause.span, wholes(scene))
