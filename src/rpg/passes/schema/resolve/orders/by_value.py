"""Number cubes by how large their numbers are: "the bigger number", "the two smallest digits"."""

from __future__ import annotations

from rpg.ir import structures as s
from rpg.language.meaning import Noun, replace
from rpg.passes.schema.resolve.things.things import matching
from rpg.passes.schema.resolve.things.world import Ref, Scene, Thing, refuse


def by_value(noun: Noun, scene: Scene) -> Ref | None:
    """Those of the number cubes there are; None where it may be said of the size of blocks."""
    rank = noun.traits.rank or ""
    if noun.part_of is not None or noun.det in ("a", "any", "no", "each"):
        return None
    those = [thing for thing in matching(replace(noun.traits, rank=None), scene, False) if not thing.extra]
    if noun.traits.kind != "digit" and not (noun.head == "any" and noun.traits.kind is None):
        return None
    if not those or not all(map(_plain_digit, those)):
        return None
    if rank.endswith("er") and len(those) > 2:
        raise refuse("ambiguous", f"of more than two numbers none is the {rank} one", noun.span,
                     f"say 'the {rank.removesuffix('r')}st number', or name it")  # fmt: skip
    if noun.plural and noun.amount is None:
        raise refuse("ambiguous", f"it is not said how many the {rank} ones are", noun.span, "say 'the two ...'")
    many = noun.amount.low if noun.amount is not None else 1
    told = sorted(those, key=lambda thing: thing.label or "", reverse=rank.startswith("large"))
    if len(told) <= many or told[many - 1].label == told[many].label:
        return None
    return Ref(names=tuple(thing.name for thing in told[:many]), plural=many > 1, listed=many > 1)


HIGHEST = {"highest": "largest", "lowest": "smallest"}
"""Words that tell of numbers, and of what is on top as well."""


def highest(noun: Noun, scene: Scene) -> Ref:
    """ "The highest number": the largest, where nothing is in a tower."""
    rank = HIGHEST[noun.traits.rank or ""]
    towers = [b for b in scene.built if b.kind in ("stack", "towers")]
    if towers or any(isinstance(goal, s.Stack | s.Towers) for goal in scene.start_goals):
        raise refuse("ambiguous", "this could be told of its number, or of its place in a tower", noun.span,
                     f"say 'the {rank} number', or name it")  # fmt: skip
    found = by_value(replace(noun, traits=replace(noun.traits, rank=rank)), scene)
    if found is None:
        raise refuse("no-referent", f"it is not clear which number is the {rank}", noun.span,
                     "say first which there are, as in 'There are the digits 3, 5 and 8.'")  # fmt: skip
    return found


def _plain_digit(thing: Thing) -> bool:
    """Of cubes of several sizes it is not clear what is larger: the cube, or its number."""
    return bool(thing.label) and (thing.label or "").isdigit() and not (thing.size or thing.edge)
