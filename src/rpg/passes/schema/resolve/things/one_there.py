""" "Three red blocks are on the mat. Put a blue one on each one that is next to the green block": on blocks, not on the
mat."""

from __future__ import annotations

from rpg.language.meaning import Noun, Traits
from rpg.passes.schema.resolve.things.them import no_block_there, patches_of_each
from rpg.passes.schema.resolve.things.world import Scene, Scope, refuse


def no_patch(noun: Noun, scene: Scene, scope: Scope) -> bool:
    """Whether "the one that is next to green" can be no patch, because there is but one to pick from.

    Raises:
        Refusal: "each one" could be the patches that something was put on, or what was put there, and so could "the
            one in the corner".
    """
    if noun.traits != Traits():
        return False
    if noun.det == "each" and scope.role == "landmark" and patches_of_each(scene, scope):
        no_block_there("each one", noun.span)
    marks = [t for t in scene.things.values() if t.patch]
    single = len(marks) == 1 and any(scene.blocks())
    if single and noun.det == "the" and not (noun.conditions or noun.amount or noun.plural):
        raise refuse("ambiguous", "this could be the patch, or a block on it", noun.span, "say 'block' or 'patch'")
    return single and bool(noun.conditions)
