""" "It" in a clause that goes like the one before it: "a red block left of the mat and a blue one right of it"."""

from __future__ import annotations

from rpg.language.meaning import Pronoun
from rpg.passes.schema.resolve.things.operands import DIRECTIONS
from rpg.passes.schema.resolve.things.world import Mention, Ref, Scene, Scope

ACROSS = ({"left", "right"}, {"front", "behind"})


def parallel(word: Pronoun, rivals: list[Mention], scene: Scene, scope: Scope) -> Ref | None:
    """What "it" is where the clause before says something of just that kind; None where nothing settles it.

    "Brown goes left of it and black right of it" is one thing in one sentence. "Red must be on the patch, and blue must
    not be on it", "a red block left of green and another red one right of it": of the same again. "To the left of red
    put blue; to its right green": of what came first in the sentence.
    """
    marks = [m for m in rivals if m.role == "landmark"]
    if len(marks) != 1 or not scope.rel:
        return None
    before, again = marks[0].rel, scope.rel
    kept_off = before in ("on", "in") and again in ("not on", "not in", "not above", "off")
    kept_off = kept_off or (before in ("off", "not on", "not in") and again in ("on", "in"))
    if marks[0].ref.patch and kept_off:
        return marks[0].ref
    others = [m for m in rivals if m is not marks[0]]
    first = all(marks[0].ref.span < m.ref.span for m in others) and not any(
        m.ref.span < word.span for m in scene.mentions if m.clause == scene.clause and m.role == "theme"
    )
    if first and {before, again} in ACROSS:
        return marks[0].ref
    if marks[0].sentence != scene.sentence:
        return None
    same = marks[0].word == "it" and before in DIRECTIONS and again in DIRECTIONS
    across = {before, again} in ACROSS and (marks[0].ref.patch or _alike(others, scene))
    return marks[0].ref if same or across else None


def _alike(others: list[Mention], scene: Scene) -> bool:
    """ "A pink block left of the yellow one and another pink one right of it": what stands there looks the same."""
    now = [n for m in scene.mentions if m.clause == scene.clause and m.role == "theme" for n in m.ref.names]
    before = [n for m in others for n in m.ref.names]
    looks = {(scene.things[n].color, scene.things[n].label, scene.things[n].size) for n in (*now, *before)}
    return bool(now) and bool(before) and len(looks) == 1
