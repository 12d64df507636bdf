"""Removing objects from a task."""

from __future__ import annotations

from rpg.ir.edits import RemoveAsset, SetField
from rpg.ir.structures import Spells
from rpg.steer.draft import Draft
from rpg.steer.operations.lines import arranged
from rpg.steer.refer import resolve
from rpg.steer.requests import requests as r
from rpg.steer.view import Line


def remove(draft: Draft, request: r.Remove) -> None:
    """Objects leave the task; what stood on them comes down, lines close up."""
    names = resolve(draft.view, request.theme).names
    if request.others:
        names = tuple(name for name in draft.view.world.blocks if name not in names)
        if not names:
            raise draft.refusal("nothing-to-do", "the task has no other blocks", request.span)
    idle = set(draft.view.idle)
    draft.note("remove", list(names))
    for name in names:
        line = draft.view.line_of((name,))
        if line is not None and isinstance(line.node, Spells):
            _shorten(draft, line, name)
        draft.do(RemoveAsset(name=name), request.span)
    draft.aim("TWEAK" if set(names) <= idle else "MODIFY")
    draft.look_at(tuple(name for name in draft.focus if name not in names))


def _shorten(draft: Draft, line: Line, name: str) -> None:
    """A word loses a letter before its cube goes."""
    members = tuple(other for other in line.members if other != name)
    shorter = arranged(draft, line, members)
    assert isinstance(shorter, Spells)
    draft.do(SetField(at=line.path, field="blocks", value=members))
    draft.do(SetField(at=line.path, field="word", value=shorter.word))
