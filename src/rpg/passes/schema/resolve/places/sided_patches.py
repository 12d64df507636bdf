"""Patches that are told apart by where they lie: "the left mat", "the right one"."""

from __future__ import annotations

from rpg.ir import relations as r
from rpg.language.meaning import Noun, Traits
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, Thing, refuse

_OPPOSITE = {"left": "right", "right": "left", "front": "back", "back": "front"}
_TOWARDS = {"left": r.LeftOf, "right": r.RightOf, "front": r.InFrontOf, "back": r.Behind}


def sided_patch(noun: Noun, side: str, scene: Scene, scope: Scope) -> Ref:
    """The patch on that side of the others; the first time one of them, for they look alike."""
    marks = noun.traits
    there = [t for t in scene.things.values() if t.patch]
    if noun.head != "patch" and (scope.role != "landmark" or (len(there) < 2 and not scene.patch_sides)):
        raise refuse("no-referent", f"it is not clear what the {side} one is", noun.span, "name it")
    if marks != Traits(rank=marks.rank, shape=marks.shape) or noun.plural or noun.det not in ("the", "bare"):
        raise refuse("ambiguous", "a patch is told by its side or by its look", noun.span, "say 'the left patch'")
    if side not in scene.patch_sides:
        if _OPPOSITE.get(side) is None and not {*scene.patch_sides} - {"middle"} and len(there) != MIDDLED:
            raise refuse("no-referent", "it is not said in the middle of which patches this is", noun.span,
                         "say first how many patches there are")  # fmt: skip
        scene.patch_sides[side] = _one_more(noun, there, scene).name
    scene.patch_sides_at = noun.span
    return Ref(names=(scene.patch_sides[side],), patch=True)


MIDDLED = 3
"""So many patches have one in the middle."""


def _one_more(noun: Noun, there: list[Thing], scene: Scene) -> Thing:
    """A patch that no side was told of yet."""
    free = [t for t in there if t.name not in scene.patch_sides.values()]
    if any(t.color for t in free):
        raise refuse("ambiguous", "it is not said which of the patches lies there", noun.span, "name its colour")
    if not free and any(t.declared for t in there):
        raise refuse("too-many-asked", "there is no further patch", noun.span, "say how many patches there are")
    return free[0] if free else scene.fresh(patch=True, shape=noun.traits.shape)


def settle_sides(scene: Scene) -> None:
    """Where the patches lie that were told by their sides: the left one left of all the others."""
    told = dict(scene.patch_sides)
    every = [t.name for t in scene.things.values() if t.patch]
    if not told:
        return
    if any(scene.things[name].color for name in every) or len(every) < 2 or not _agree(told, len(every)):
        raise refuse("ambiguous", "it is not clear on which side of which patches this is", scene.patch_sides_at,
                     "say how many patches there are, or name their colours")  # fmt: skip
    if "middle" in told:  # it is there only between the two others
        ends = ("front", "back") if told.keys() & {"front", "back"} else ("left", "right")
        rest = (name for name in every if name not in told.values())
        told |= {side: next(rest) for side in ends if side not in told}
    for side, name in told.items():
        others = (other for other in every if other != name)
        for other in others if side in _TOWARDS else ():
            if told.get(_OPPOSITE[side]) != other or side in ("left", "back"):
                scene.start_goals.append(_TOWARDS[side](a=(name,), b=(other,), span=scene.patch_sides_at))


def _agree(told: dict[str, str], many: int) -> bool:
    """Whether the sides are those of one line, and each of its patches has one of them."""
    across = not told.keys() & {"front", "back"} or not told.keys() & {"left", "right"}
    return across and ("middle" not in told or many == MIDDLED)
