"""Conditions in another way: of some instead of all, to the right instead of to the left."""

from __future__ import annotations

from rpg.blocks.traits import Traits
from rpg.ir import goal as g
from rpg.ir.edits import AddAsset, AddCondition, ChangeCondition, DropCondition, SetField, SetGoal
from rpg.ir.goal import Count
from rpg.ir.node import EACH, members
from rpg.ir.relations import Behind, Directional, InFrontOf, InRegion, LeftOf, OnPatch, OnTable, RightOf, Stayed
from rpg.ir.structures import Row, Stack, Staircase
from rpg.ir.walk import conjuncts, rename, transform
from rpg.steer.draft import Draft
from rpg.steer.operations.count import recount
from rpg.steer.operations.exchange import exchange
from rpg.steer.operations.make import named
from rpg.steer.refer import resolve
from rpg.steer.requests import requests as r

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


def enough(draft: Draft, request: r.Enough) -> None:
    """So many blocks will do: at least so many of those that a place is asked of, else a smaller structure."""
    placed = [a for _, a in draft.view.atoms if isinstance(a, OnPatch | OnTable | InRegion) and len(members(a.a)) > 1]
    built = draft.view.lines or draft.view.figures
    if placed and (built or not request.of_them):
        told = "this may be how many blocks there are, or how many of them have to be there"
        hint = "say 'use two blocks', or 'at least two of them'"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    if placed:
        some(draft, r.Some(bound="at_least", amount=request.amount, span=request.span))
        return
    recount(draft, r.Recount(theme=None, amount=request.amount, what="blocks", span=request.span))


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


def climb(draft: Draft, request: r.Climb) -> None:
    """A staircase goes up another way, or one way at all."""
    figure = next((figure for figure in draft.view.figures if isinstance(figure.node, Staircase)), None)
    node = figure.node if figure is not None else None
    if figure is None or not isinstance(node, Staircase):
        raise draft.refusal("no-such-object", "the task builds no staircase", request.span, "say which way blocks go")
    if node.up == request.to:
        raise draft.refusal("nothing-to-do", f"it goes up to the {request.to} already", request.span)
    draft.aim("EXTEND" if node.up is None else "MODIFY")
    draft.note("up", request.to)
    draft.do(SetField(at=figure.path, field="up", value=request.to), request.span)


def closer(draft: Draft, request: r.Closer) -> None:
    """The only relation of this kind asks for more: to be exactly on that side, or close by."""
    kind = WAYS.get(request.rel)
    found = [(path, atom) for path, atom in draft.view.atoms if kind is not None and isinstance(atom, kind)]
    flags = [mod for mod in request.mods if mod in ("directly", "immediate")]
    if len(found) != 1 or len(flags) != len(request.mods):
        told, hint = "it is not settled what this is about", "say which block is to be where"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    path, atom = found[0]
    draft.aim("EXTEND")
    draft.note("closer", flags)
    for flag in flags:
        if getattr(atom, flag):
            raise draft.refusal("nothing-to-do", "it is so already", request.span)
        draft.do(SetField(at=path, field=flag, value=True), request.span)


def divide(draft: Draft, request: r.Divide) -> None:
    """So many blocks of this colour, so many of that one, where the goal does not say which block is where."""
    names = draft.view.busy
    line, figure = draft.view.main_line(), draft.view.main_figure()
    names = line.members if line is not None else figure.members if figure is not None else names
    wanted = [color for number, color in request.parts for _ in range(number)]
    if len(wanted) != len(names):
        told = f"there are {len(names)} blocks, and these are {len(wanted)}"
        raise draft.refusal("count-mismatch", told, request.span, "say a colour for every block")
    free = isinstance(line.node, Stack | Row) and line.node.order.by == "any" if line is not None else True
    if not free or any(Traits(draft.view.world).symbol(name) for name in names):
        told, hint = "the goal says which block is where", "say which ones: make the top block red"
        raise draft.refusal("ambiguous-object", told, request.span, hint)
    draft.aim("TWEAK")
    draft.note("restyle", dict(request.parts and [(color, number) for number, color in request.parts]))
    blocks = [draft.view.world.blocks[name] for name in names]
    pairs = zip(blocks, wanted, strict=True)
    exchange(draft, {block.name: block.model_copy(update={"color": color}) for block, color in pairs}, request.span)


def turn(draft: Draft, request: r.Turn) -> None:
    """Relations and regions that point one way point the other way."""
    before = draft.schema.goal

    def change(node: g.Goal) -> g.Goal:
        return _pointed(node, request.old, request.to) if isinstance(node, WAYS[request.old] | InRegion) else node

    goal = transform(before, change)
    if goal == before:
        told = f"nothing in the goal is {request.old.replace('front', 'in front')} of anything"
        raise draft.refusal("edit-unclear", told, request.span, "say what is to be where")
    draft.aim("MODIFY")
    draft.note("turn", {"from": request.old, "to": request.to})
    draft.do(SetGoal(goal=goal), request.span)


def free(draft: Draft, request: r.Free) -> None:
    """Blocks that had to stay where they are may be moved."""
    names = resolve(draft.view, request.theme).names
    found = [(path, atom) for path, atom in draft.view.atoms if isinstance(atom, Stayed)]
    stuck = {name for _, atom in found for name in members(atom.a)}
    if not set(names) <= stuck:
        told, hint = "nothing says that it has to stay where it is", "say what is to change"
        raise draft.refusal("nothing-to-do", told, request.span, hint)
    draft.aim("MODIFY")
    draft.note("free", list(names))
    for path, atom in reversed(found):
        rest = tuple(name for name in members(atom.a) if name not in names)
        if not rest:
            draft.do(DropCondition(at=path), request.span)
        elif len(rest) < len(members(atom.a)):
            draft.do(ChangeCondition(at=path, to=atom.model_copy(update={"a": rest})), request.span)
    draft.look_at(names)


_ACROSS = {"left": "right", "right": "left", "front": "behind", "behind": "front"}


def across(draft: Draft, request: r.Across) -> None:
    """The one relation to a side, or the one half of the table, is that of the other side."""
    names = set(resolve(draft.view, request.theme).names) if request.theme is not None else set()
    found = []
    for path, atom in draft.view.atoms:
        way = next((way for way in WAYS if isinstance(atom, WAYS[way])), None)
        region = atom.region.split("_") if isinstance(atom, InRegion) else []
        way = way or next((way for way in _ACROSS if _REGIONS.get(way, way) in region[:-1] and len(region) == 2), None)
        about = [set(members(getattr(atom, end))) for end in ("a", "b") if hasattr(atom, end)] if way else []
        if way is not None and (not names or names in about):
            found.append((path, atom, way))
    if len(found) != 1:
        told = "it is not clear which side this is"
        raise draft.refusal("ambiguous", told, request.span, "say 'to the left of' or 'to the right of'")
    path, atom, way = found[0]
    draft.aim("MODIFY")
    draft.note("turn", {"from": way, "to": _ACROSS[way]})
    draft.do(ChangeCondition(at=path, to=_pointed(atom, way, _ACROSS[way])), request.span)
    draft.look_at(tuple(name for name in members(getattr(atom, "a", ())) if name in draft.view.world.blocks))


def _pointed(atom: g.Goal, old: str, to: str) -> g.Goal:
    """A relation, or a region, that points one way instead of another."""
    if isinstance(atom, InRegion):
        new = {_REGIONS.get(old, old): _REGIONS.get(to, to)}
        return atom.model_copy(update={"region": "_".join(new.get(part, part) for part in atom.region.split("_"))})
    turned: g.Goal = WAYS[to].model_validate(atom.model_dump(exclude={"kind"}))  # type: ignore[assignment]
    return turned
