"""Blocks by their place or rank: "the top block", "the leftmost cube", "the second block from the left"."""

from __future__ import annotations

from rpg.language.meaning import Noun
from rpg.passes.schema.resolve.world import Built, Ref, Scene, Scope, refuse

_FIRST = {"stack": "bottom", "row": "left", "line": "left", "column": "front", "word": "left"}


def ranked(noun: Noun, scene: Scene, scope: Scope) -> Ref:
    """The block at a place of the structure spoken of last, or the extreme in size."""

    rank = noun.traits.rank or ""
    if rank in ("largest", "smallest"):
        sized = sorted(
            ((t.edge or {"small": 0.03, "big": 0.05}.get(t.size or "", 0.04), t.name) for t in scene.blocks()),
            reverse=rank == "largest",
        )
        if len(sized) > 1 and sized[0][0] != sized[1][0]:
            return Ref(names=(sized[0][1],))
        raise refuse("no-referent", f"no block is the {rank}", noun.span, "name its colour")
    for built in reversed(scene.built):
        if not built.ordered:
            continue
        found = _in(built, rank)
        if found is not None and (noun.head != "patch"):
            return Ref(names=(found,))
    if rank.isdigit() or rank == "last":
        raise refuse(
            "no-referent",
            "it is not clear in which order the blocks are counted",
            noun.span,
            "name its colour or its label",
        )
    raise refuse(
        "no-referent", f"it is not clear which block is the {rank} one", noun.span, "name its colour or its label"
    )


def _in(built: Built, rank: str) -> str | None:
    first = built.side or _FIRST.get(built.kind, "")
    opposite = {
        "bottom": "top",
        "top": "bottom",
        "left": "right",
        "right": "left",
        "front": "back",
        "back": "front",
    }.get(first)
    members = built.members
    if rank == first:
        return members[0]
    if rank == opposite or rank == "last":
        return members[-1]
    if rank == "middle" and len(members) % 2:
        return members[len(members) // 2]
    if rank.isdigit() and int(rank) <= len(members):
        return members[int(rank) - 1]
    return None
