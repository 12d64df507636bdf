"""The patches that noun phrases stand for."""

from __future__ import annotations

from rpg.language.compose.scene import Patch, Ref, Scene, Unclear
from rpg.language.compose.syntax import ALL, Noun


def patches(scene: Scene, noun: Noun) -> Ref:
    """A patch that is there, a further one, or all of them."""
    if noun.det in ALL or (noun.det == "the" and noun.many):
        return _all_patches(scene, noun)
    if noun.ranks or noun.nth or noun.many or noun.count > 1 or noun.det not in {"a", "the", ""}:
        raise Unclear
    found = [n for n, patch in enumerate(scene.patches) if not noun.color or patch.color == noun.color]
    if noun.word:
        if any(not scene.patches[n].shape for n in found):
            raise Unclear  # one of which no shape was said, or another one
        found = [n for n in found if scene.patches[n].shape == noun.word]
    if len(found) > 1 or (found and noun.det == "a" and not noun.color):
        raise Unclear
    if noun.color and any(not patch.color for patch in scene.patches):
        raise Unclear  # the one of which no colour was said, or another one
    if not found:
        if not (noun.color or noun.word) and scene.patches:
            raise Unclear
        scene.patches.append(Patch(noun.color, noun.word))
        found = [len(scene.patches) - 1]
    return Ref("patch", found)


def _all_patches(scene: Scene, noun: Noun) -> Ref:
    """ "Each mat", "the two mats": all that were told of."""
    many = len(scene.patches)
    count = noun.count or (2 if noun.det == "both" else many)
    if noun.color or noun.word or noun.ranks or noun.nth or noun.bound or many < 2 or count != many:
        raise Unclear
    return Ref("patch", list(range(many)), each=noun.det == "each", every=True)
