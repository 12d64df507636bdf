""" "Red on one patch, blue on the other one": of the one nothing is told that would tell it apart."""

from __future__ import annotations

from rpg.language.meaning import Noun, Traits
from rpg.passes.schema.resolve.things.things import matching
from rpg.passes.schema.resolve.things.world import Scene


def one_alone(noun: Noun, scene: Scene) -> bool:
    """Whether one patch has been spoken of, so that "the other one" is a second."""
    there = matching(noun.traits, scene, True)
    return noun.traits == Traits() and len(there) == 1 and there[0].color is None and not there[0].declared
