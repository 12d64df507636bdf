"""Turns by degrees of symbols that are read: they tell how the symbol stands there, not how far it came."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.language.meaning import Manner
from rpg.passes.schema.resolve.goals.logic import disj
from rpg.passes.schema.resolve.things.world import Built, Scene


def spun(name: str, by: Manner, described: bool, scene: Scene, span: Span, state: bool = False) -> g.Goal | None:
    """ "the word ON with the N turned by 90 degrees": how a symbol of a structure stands; None for other blocks.

    `described`: the turn is part of a picture of the end, and not something to be done. `state`: how it lies is told as
    well, "on its side, rotated clockwise", so that this is of a symbol by itself, too.
    """
    homes = [b for b in scene.built if name in b.members and _reads(b, described)]
    if scene.things[name].label is None or not (homes or (described and state)):
        return None
    toward = "viewer" if homes and (homes[-1].kind == "stack" or homes[-1].side == "top") else "up"
    degrees = float(by.value or 0.0) % 360.0
    turns = dict.fromkeys((degrees, 360.0 - degrees)) if by.kind == "by?" else {degrees: None}
    label = scene.things[name].label or ""
    goals = [r.Facing(block=name, label=label, toward=toward, turn=_signed(turn), span=span) for turn in turns]  # type: ignore[arg-type]
    scene.assume("a symbol that is read is turned from upright, as its reader sees it")
    return goals[0] if len(goals) == 1 else disj([*goals])


def _reads(built: Built, described: bool) -> bool:
    return built.kind in ("word", "equation") or (described and built.kind != "pile")


def _signed(degrees: float) -> float:
    return degrees - 360.0 if degrees > 180.0 else degrees
