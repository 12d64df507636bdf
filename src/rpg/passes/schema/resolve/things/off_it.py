""" "Take the red block off the green one and put the blue one on it": on which of the two?"""

from __future__ import annotations

from rpg.language.meaning import Pronoun
from rpg.passes.schema.resolve.things.world import Scene, Scope, refuse


def check_off_it(word: Pronoun, scene: Scene, scope: Scope) -> None:
    """Refuse "it" as a landmark behind a block that is taken off another: it could be either of them.

    Where it is the block itself that is put somewhere ("lay it down beside it") the landmark is the other one.
    """
    if any(m.clause == scene.clause and m.role == "theme" and m.word for m in scene.mentions):
        return
    bare = [m for m in scene.mentions if m.clause == scene.clause - 1 and m.rel == "off" and not m.word]
    left = [m.ref for m in bare if len(m.ref.names) == 1 and not m.ref.patch and not m.ref.table]
    if scope.role == "landmark" and word.word == "it" and not scope.start and left:
        raise refuse("ambiguous", "'it' could be the block that is taken off or the one below it", word.span,
                     "name the block")  # fmt: skip
