""" "Red on one patch, blue on the other one", "one block on the other": of the one nothing is told that would tell it
apart."""

from __future__ import annotations

from rpg.language.meaning import Noun, Traits
from rpg.passes.schema.resolve.things.things import matching
from rpg.passes.schema.resolve.things.world import Ref, Scene


def one_alone(noun: Noun, scene: Scene, patch: bool) -> bool:
    """Whether one patch, or one block, has been spoken of, so that "the other one" is a second."""
    there = matching(noun.traits, scene, patch)
    if noun.traits != Traits() or len(there) != 1 or there[0].color is not None or there[0].declared:
        return False
    definite = any(m.ref.det == "the" for m in scene.mentions if there[0].name in m.ref.names)
    return patch or not (definite or there[0].label or there[0].kind or there[0].edge or there[0].size)


def the_only_patch(name: str, scene: Scene) -> bool:
    """ "(Red is on the mat.) Put blue on the green one": a mat that has no colour and is "the" mat is the only one, so
    that the green one is a block."""
    return only_one_patch(scene) and "the" in [m.ref.det for m in scene.mentions if name in m.ref.names]


def only_one_patch(scene: Scene) -> bool:
    """ "(Two red blocks are on the mat.) Put one on the other": a mat without a colour has no other that is left."""
    patches = [thing for thing in scene.things.values() if thing.patch]
    told = {m.ref.det for m in scene.mentions if m.ref.patch}
    return len(patches) == 1 and patches[0].color is None and told == {"the"}


def one_of_the_patches(scene: Scene) -> Ref | None:
    """ "There are two mats. Put A on one and B on the other": the first that nothing is on, where none has a look."""
    mats = [t for t in scene.things.values() if t.patch and t.declared]
    free = [t for t in mats if t.name not in scene.used]
    if len(mats) < 2 or not free or any(t.color is not None for t in mats):
        return None
    scene.used.add(free[0].name)
    return Ref(names=(free[0].name,), patch=True)
