"""A structure that several places are told of: "behind or in front of a row of three"."""

from __future__ import annotations

from rpg.language.meaning import Loc, Meaning, Structure, replace
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.world import Scene, Scope


def of_one_structure(places: tuple[Meaning, ...], scene: Scene, scope: Scope) -> tuple[Meaning, ...]:
    """ "Behind or in front of a row": the row is there in either case."""
    first, *others = places
    if not isinstance(first, Loc) or not isinstance(first.landmark, Structure):
        return places
    known = replace(first.landmark, det="the")
    if any(getattr(other, "landmark", None) != known for other in others):
        return places
    refer(first.landmark, scene, replace(scope, role="landmark", pool=(), need=None, rel=first.rel))
    return replace(first, landmark=known), *others
