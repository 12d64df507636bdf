"""Patches told by the colours of the blocks: "mats in both colours", "its patch"."""

from __future__ import annotations

from rpg.core.diagnostics import Refusal, Span
from rpg.ir import relations as r
from rpg.ir.walk import names as names_in
from rpg.language.grammar.things.theirs import THEIRS
from rpg.language.meaning import Noun, Traits
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def in_their_colors(noun: Noun, scene: Scene, scope: Scope) -> Ref:
    """ "red and blue blocks, and mats in both colours": one patch in every colour of the blocks there are."""
    colors = tuple(dict.fromkeys(t.color for t in scene.blocks() if t.color and not t.extra))
    if not scope.given or not colors:
        raise refuse("misplaced", "it is not said in which colours", noun.span, "name the colours")
    if noun.amount is not None and noun.plural and noun.amount.low != len(colors):
        raise refuse("count-mismatch", f"the blocks have {len(colors)} colours", noun.span, "say as many patches",
                     colors=len(colors), patches=noun.amount.low)  # fmt: skip
    names = []
    for color in colors:
        there = [t for t in scene.things.values() if t.patch and t.color == color]
        patch = (
            there[0] if there else scene.fresh(patch=True, color=color, shape=noun.traits.shape, long=noun.traits.long)
        )
        patch.declared = True
        names.append(patch.name)
    return Ref(names=tuple(names), patch=True, plural=len(names) > 1, det=noun.det)


def its_own(noun: Noun, scene: Scene) -> bool:
    """ "each block on its patch": the one of its colour, where nothing begins on a patch that would be its own."""
    begun = any(isinstance(goal, r.OnPatch) for goal in scene.start_goals)
    return noun.det == "its" and noun.traits == Traits() and noun.amount is None and not begun


def begun_on(noun: Noun, scene: Scene, scope: Scope) -> Ref | None:
    """ "Take the red block off its mat": the one that it begins on."""
    theme = [m.ref for m in scene.mentions if m.clause == scene.clause and m.role == "theme"]
    if noun.det != "its" or noun.traits != Traits() or noun.amount is not None or scope.role != "landmark" or not theme:
        return None
    starts = [goal for goal in scene.start_goals if isinstance(goal, r.OnPatch)]
    patches = {goal.patch for name in theme[-1].names for goal in starts if name in names_in(goal)}
    return Ref(names=tuple(patches), patch=True, det="the") if len(patches) == 1 else None


def off_which(span: Span) -> Refusal:
    """ "It is on the pink mat. Take it off its mat": where that may be told of the end, nothing begins on a mat."""
    return refuse("contradiction", "it is not said on which patch this begins", span, "say where it is at the start")


__all__ = ["THEIRS", "begun_on", "in_their_colors", "its_own", "off_which"]
