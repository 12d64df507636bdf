""" "Take the red block off the green one and put the blue one on it": on which of the two?"""

from __future__ import annotations

from rpg.language.meaning import Pronoun
from rpg.passes.schema.resolve.things.world import Scene, Scope, refuse


def check_off_it(word: Pronoun, scene: Scene, scope: Scope) -> None:
    """Refuse "it" as a landmark behind a block that is taken off another: it could be either of them.

    Where it is the block itself that is put somewhere ("lay it down beside it") the landmark is the other one.
    """
    _of_the_unnamed(word, scene, scope)
    if any(m.clause == scene.clause and m.role == "theme" and m.word for m in scene.mentions):
        return
    bare = [m for m in scene.mentions if m.clause == scene.clause - 1 and m.rel == "off" and not m.word]
    left = [m.ref for m in bare if len(m.ref.names) == 1 and not m.ref.patch and not m.ref.table]
    if scope.role == "landmark" and word.word == "it" and not scope.start and left:
        raise refuse("ambiguous", "'it' could be the block that is taken off or the one below it", word.span,
                     "name the block")  # fmt: skip


def _of_the_unnamed(word: Pronoun, scene: Scene, scope: Scope) -> None:
    """Refuse "uncover red and put it on the mat": the block on it is not even named."""
    verb = scene.verbs.get(scene.clause - 1, (None, False, ""))[0]
    last = [m for m in scene.mentions if m.clause == scene.clause - 1 and m.role == "theme"]
    if scope.role == "theme" and verb is not None and any(m.ref.span == verb and not m.word for m in last):
        raise refuse("ambiguous", "'it' could be the block that is named or the one on it", word.span,
                     "name the block")  # fmt: skip
