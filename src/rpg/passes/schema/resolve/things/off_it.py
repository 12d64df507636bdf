""" "Take the red block off the green one and put the blue one on it", "green has red on it; put it on the mat": on, or
which, of the two?"""

from __future__ import annotations

from rpg.language.meaning import Clause, Loc, Noun, Pronoun
from rpg.passes.schema.resolve.things.world import Mention, Ref, Scene, Scope, refuse


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


def note_verb(clause: Clause, scene: Scene) -> None:
    """Remember the verb of a clause, and whether it tells what a block has on it or beside it."""
    scene.verbs[scene.clause] = (clause.word, clause.negated, clause.verb)
    places = [x for x in clause.adjuncts if isinstance(x, Loc)]
    scene.resting = any(x.rel in ("on", "in", "off") for x in places)
    if clause.verb in ("remove", "pick") or any(x.rel == "off" for x in places):
        scene.owners.discard(scene.clause - 1)  # "take it off": what lies there
    owner = places[0].landmark if len(clause.adjuncts) == len(places) == 1 else None
    if isinstance(owner, Noun) and owner.head != "patch" and not owner.plural and clause.theme is not None:
        first = owner.span < clause.theme.span and owner.span[0] < places[0].span[0]
        scene.owners |= {scene.clause} if first or clause.subject is not None else set()


def check_owner(word: Pronoun, found: Ref, scene: Scene) -> None:
    """Refuse "(the blue block has a red one on it.) Put it on the mat": either of them."""
    told = [m for m in scene.mentions if m.clause == scene.clause - 1 and m.role != "landmark"]
    lying = any(m.ref.names == found.names and len(found.names) == 1 for m in told)
    if lying and scene.clause - 1 in scene.owners:
        raise refuse("ambiguous", f"{word.word!r} could be what lies there, or what has it there", word.span,
                     "name the block")  # fmt: skip


def lies_there(mark: Mention, scene: Scene, scope: Scope) -> bool:
    """ "(Build a row.) Put a tower on the patch to its right": what lies on the patch is not to the right of that."""
    beside = scope.rel.removeprefix("not ") not in ("on", "in", "off", "")
    return beside and mark.ref.patch and mark.clause == scene.clause and mark.rel in ("on", "in")
