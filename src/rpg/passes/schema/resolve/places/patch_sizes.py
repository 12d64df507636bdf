"""Patches by their size among others: "the biggest patch", "the smaller of the two mats"."""

from __future__ import annotations

from dataclasses import replace as changed
from typing import TYPE_CHECKING

from rpg.ir.assets import PATCH_SIDE
from rpg.language.later import later
from rpg.language.meaning import Amount, Noun, Traits, replace
from rpg.passes.schema.resolve.things.things import PATCH_SCALE, matching
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, Thing, refuse

if TYPE_CHECKING:
    from rpg.passes.schema.resolve.things.refer import refer
else:
    (refer,) = later(__name__, "rpg.passes.schema.resolve.things.refer", "refer")

_SIZES: dict[int, tuple[str | None, ...]] = {2: ("small", "big"), 3: ("small", None, "big")}
"""Of so many patches of which no more is said than that they differ in size."""
_MANY = {2: "two", 3: "three"}


def of_patches(noun: Noun, scene: Scene, scope: Scope) -> bool:
    """Whether a patch is meant: "the biggest patch"; "on the biggest one", where only patches are several."""
    if noun.head != "any":
        return noun.head == "patch"
    several = sum(t.patch for t in scene.things.values()) > 1 >= len([*scene.blocks()])
    return scope.like_patch or (scope.role == "landmark" and several)


def patch_by_size(noun: Noun, scene: Scene, scope: Scope) -> Ref:
    """The patch that is so, of those that are named or of all that there are."""
    rank = noun.traits.rank or ""
    if noun.plural or noun.det not in ("the", "bare"):
        raise refuse("ambiguous", f"it is not said which of the patches is the {rank} one", noun.span,
                     f"say 'the {rank} patch'")  # fmt: skip
    those = _those(noun, scene, scope)
    if rank.endswith("er") and len(those) > 2:
        raise refuse("ambiguous", f"of more than two patches none is the {rank} one", noun.span, "name its colour")
    if len(those) in _SIZES and not any(t.color or t.shape or t.long or _told(t) for t in those):
        for thing, size in zip(those, _SIZES[len(those)], strict=True):
            thing.size = size
        told = "one small, one large" if len(those) == 2 else "one small, one as usual, one large"
        scene.assume(f"the sizes of the {_MANY[len(those)]} patches are not said: {told}")
    for thing in those:
        thing.declared = True  # "the biggest of three": the others are there as well
    sizes = sorted({_area(t) for t in those}, reverse="large" in rank)
    nth = int(rank.split()[0]) if rank[:1].isdigit() else 1
    found = [t for t in those if _area(t) == sizes[nth - 1]] if nth <= len(sizes) else []
    if len(sizes) < 2 or len(found) != 1 or (nth > 1 and len(sizes) != len(those)):
        raise refuse("no-referent", f"no patch is said to be the {rank}", noun.span,
                     "say how large the patches are, as in 'a small red patch and a large blue patch', or name its "
                     "colour")  # fmt: skip
    return Ref(names=(found[0].name,), patch=True)


def _those(noun: Noun, scene: Scene, scope: Scope) -> list[Thing]:
    """The patches among which it is that one; where none was told of, as many as differ in size."""
    if noun.part_of is not None:
        lot = noun.part_of
    elif there := matching(replace(noun.traits, rank=None), scene, True):
        return there
    elif any(t.patch for t in scene.things.values()) or noun.traits != Traits(rank=noun.traits.rank):
        return []
    else:
        count = min(_SIZES) if (noun.traits.rank or "").endswith("er") else max(_SIZES)
        scene.assume(f"the number of patches is not said: {count}")
        lot = Noun(head="patch", amount=Amount(count, count), plural=True, span=noun.span)
    them = refer(lot, scene, changed(scope, role="part", pool=(), need=None))
    scene.mentions.pop()
    return [scene.things[name] for name in them.names] if them.patch and them.quant is None else []


def _told(thing: Thing) -> bool:
    return thing.size is not None or thing.extent is not None


def _area(thing: Thing) -> float:
    """How large a patch is, as far as that is said."""
    wide, deep = thing.extent or (PATCH_SIDE, PATCH_SIDE)
    return round(wide * deep * PATCH_SCALE.get(thing.size or "", 1.0) ** 2, 6)
