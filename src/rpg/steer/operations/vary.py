"""Conditions in another way: of some instead of all, to the right instead of to the left."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir.edits import AddAsset, AddCondition, ChangeCondition, SetGoal
from rpg.ir.goal import Count
from rpg.ir.node import EACH
from rpg.ir.relations import Behind, Directional, InFrontOf, InRegion, LeftOf, OnPatch, OnTable, RightOf
from rpg.ir.walk import rename, transform
from rpg.steer import requests as r
from rpg.steer.draft import Draft
from rpg.steer.operations.make import named
from rpg.steer.shape import conjuncts

WAYS: dict[str, type[Directional]] = {"left": LeftOf, "right": RightOf, "front": InFrontOf, "behind": Behind}
_REGIONS = {"front": "near", "behind": "far"}


def some(draft: Draft, request: r.Some) -> None:
    """The last condition that is asked of several blocks alike is asked of so many of them."""
    single = (OnPatch, OnTable, InRegion)
    found = [
        (path, atom)
        for path, atom in draft.view.atoms
        if isinstance(atom, single) and isinstance(atom.a, tuple) and len(atom.a) > 1
    ]
    if not found:
        told, hint = "nothing is asked of several blocks alike here", "say which blocks, and what of them"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    path, atom = found[-1]
    assert isinstance(atom, single) and isinstance(atom.a, tuple)
    if not 0 < request.amount < len(atom.a):
        told = f"there are {len(atom.a)} blocks that this could be some of"
        raise draft.refusal("edit-unclear", told, request.span, "say how many blocks there should be: use three blocks")
    each = atom.model_copy(update={"a": (EACH,)})
    bounds = ("at_least", "at_most") if request.bound == "exactly" else (request.bound,)
    goal = Count.model_validate({"over": atom.a, "goal": each, **dict.fromkeys(bounds, request.amount)})
    draft.aim("MODIFY")
    draft.note("some", {request.bound: request.amount})
    draft.do(ChangeCondition(at=path, to=goal), request.span)


def copies(draft: Draft, request: r.Copies) -> None:
    """As many structures as asked for, of blocks that look like those of the one that is there."""
    line = draft.view.main_line()
    parts = conjuncts(draft.schema.goal)
    if line is None or line.node is None or len(parts) != 1 or request.kind not in (None, line.kind):
        told = "the goal is no single tower or row that there could be more of"
        raise draft.refusal("edit-unclear", told, request.span, "add what there should be besides, one by one")
    if request.amount < 2:
        raise draft.refusal("nothing-to-do", "there is one already", request.span)
    draft.aim("EXTEND")
    draft.note("copies", request.amount)
    for _ in range(request.amount - 1):
        models = [draft.view.world.blocks[name] for name in line.members]
        new: dict[str, str] = {}
        for model in models:
            (asset,) = named(draft, [model.model_copy(update={"origin": None})])
            draft.do(AddAsset(asset=asset), request.span)
            new[model.name] = asset.name
        draft.do(AddCondition(goal=rename(line.node, new)), request.span)


def turn(draft: Draft, request: r.Turn) -> None:
    """Relations and regions that point one way point the other way."""
    before = draft.schema.goal

    def change(node: g.Goal) -> g.Goal:
        if isinstance(node, Directional) and isinstance(node, WAYS[request.old]):
            turned: g.Goal = WAYS[request.to].model_validate(node.model_dump(exclude={"kind"}))  # type: ignore[assignment]
            return turned
        region = getattr(node, "region", "")
        old, new = (_REGIONS.get(way, way) for way in (request.old, request.to))
        if old in region.split("_"):
            return node.model_copy(update={"region": "_".join(new if p == old else p for p in region.split("_"))})
        return node

    goal = transform(before, change)
    if goal == before:
        told = f"nothing in the goal is {request.old.replace('front', 'in front')} of anything"
        raise draft.refusal("edit-unclear", told, request.span, "say what is to be where")
    draft.aim("MODIFY")
    draft.note("turn", {"from": request.old, "to": request.to})
    draft.do(SetGoal(goal=goal), request.span)
