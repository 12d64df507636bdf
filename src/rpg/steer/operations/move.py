"""Moving: objects of the task go elsewhere in the goal, in their line or out of it, or onto a new patch."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.blocks.traits import symbol_of
from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir.edits import AddCondition, SetGoal
from rpg.ir.node import Lowest, members
from rpg.ir.relations import Adjacent, Apart, Beside, Directional, Facing, InRegion, Near, OnPatch, Turned
from rpg.ir.shrink import close, without
from rpg.ir.structures import GroupBy
from rpg.ir.walk import conjuncts
from rpg.steer.draft import Draft
from rpg.steer.operations.make import new_assets
from rpg.steer.operations.order import put_in_order
from rpg.steer.operations.place import put, stand_on, there
from rpg.steer.operations.relate import relation
from rpg.steer.operations.reshape import reshape
from rpg.steer.proof.shape import structures
from rpg.steer.refer import exists, resolve
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import m
from rpg.steer.requests.phrases import fresh
from rpg.steer.view import Line
from rpg.steer.wholes import Found


def _by_a_new_one(draft: Draft, request: r.Move) -> r.Move:
    """Phrases such as "behind a yellow block", "left of a green mat", which the task does not have so far."""
    place = request.place
    if not isinstance(place, m.Loc) or _onto(place):
        return request
    mark = place.landmark
    if not isinstance(mark, m.Noun) or not fresh(mark) or mark.plural or exists(draft.view, mark):
        return request
    draft.add(new_assets(draft, mark), request.span)
    return replace(request, place=replace(place, landmark=replace(mark, det="the", amount=None)))


def _of_the_table(draft: Draft, place: r.Place, names: Sequence[str], span: Span) -> r.Place:
    """The middle is that of the table where nothing that is built has one, and a block is in a part of the table."""
    if not isinstance(place, r.Spot) or place.side != "middle" or place.whole is not None:
        return place
    somewhere = any(isinstance(atom, InRegion) and set(members(atom.a)) & set(names) for _, atom in draft.view.atoms)
    built = draft.view.lines or draft.view.figures
    return m.In(region="middle", span=span) if somewhere and not built else place


def _stacked_first(draft: Draft, request: r.Move) -> r.Move:
    """What is to form a stack on a patch, or somewhere on the table, forms it first. On a block it is piled one by
    one."""
    place = there(draft, request.place)
    mark = getattr(place, "landmark", None)
    patch = isinstance(mark, m.Noun) and mark.head == "patch" and fresh(mark)
    patch = patch or (mark is not None and not fresh(mark) and _patches(draft, mark))
    if request.piled and (isinstance(place, m.In) or (_onto(place) and patch)):
        stack = m.Structure(kind="stack", span=request.span)
        reshape(draft, r.Reshape(structure=stack, theme=request.theme, span=request.span))
    return request


def _patches(draft: Draft, mark: m.Meaning) -> bool:
    return exists(draft.view, mark) and set(resolve(draft.view, mark).names) <= set(draft.view.world.patches)


def _onto(place: m.Meaning | r.Spot) -> bool:
    return getattr(place, "rel", "") in ("on", "in")


def move(draft: Draft, request: r.Move) -> None:
    """What the goal said of where these blocks are gives way to the place that the request names."""
    found = resolve(draft.view, request.theme)
    names = found.names
    request = _by_a_new_one(draft, _stacked_first(draft, request))
    request = replace(request, place=_of_the_table(draft, request.place, names, request.span))
    request = replace(request, place=_beside_as_now(draft, there(draft, request.place), names))
    request = replace(request, place=_by_the_other(draft, request.place, found))
    near = getattr(request.place, "landmark", None) or getattr(request.place, "whole", None)
    if near is not None and exists(draft.view, near) and set(resolve(draft.view, near).names) <= set(names):
        told, hint = "a block cannot be moved next to itself", "name another block"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    line = draft.view.line_of(names)
    draft.note("move", list(names))
    landmark = getattr(request.place, "landmark", None)
    if _onto(request.place) and isinstance(landmark, m.Noun) and landmark.head == "patch" and fresh(landmark):
        (patch,) = draft.add(new_assets(draft, landmark), request.span)[:1]
        together = _stays_together(draft, names, request.place)
        whole = found.line or (line if together else None)
        if whole is not None:
            draft.aim("MODIFY" if _leave(draft, names, (), request.span) else "EXTEND")
            stand_on(draft, draft.view.line_of(whole.members) or whole, patch, request.span)
            return
        if found.figure is not None or together:
            draft.aim("MODIFY" if _leave(draft, names, (), request.span) else "EXTEND")
            draft.do(AddCondition(goal=OnPatch(a=names, patch=patch)), request.span)
            return
        draft.aim("MODIFY")
        _give_way(draft, names, request, Found((patch,)))
        return
    if set(names) <= set(draft.view.world.patches):
        told, hint = "where a patch lies is not part of the goal", "say where it must be: in the left half of the table"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    if found.whole and not isinstance(request.place, r.Spot):
        _whole_elsewhere(draft, found, request)
        return
    if _stays_together(draft, names, request.place):
        _whole_elsewhere(draft, Found(names, line), request)
        return
    draft.aim("MODIFY")
    other = isinstance(near, m.Structure) and not set(names) <= set(resolve(draft.view, near).names)
    spot = isinstance(request.place, r.Spot) and request.place.side != "beside"
    if line is not None and line.ordered and spot and not other:
        _move_in_line(draft, line, names, request)
        return
    landmark = near if other and spot else landmark
    anchor = None if landmark is None or isinstance(landmark, m.TableTop) else resolve(draft.view, landmark)
    if line is not None and anchor is not None and _beside_in_line(draft, line, names, request, anchor):
        return
    _give_way(draft, names, request, _without(anchor, names))


def _stays_together(draft: Draft, names: Sequence[str], place: r.Place) -> bool:
    """Whether blocks that are named one by one form all of a tower, a row or a group, and go elsewhere as that."""
    landmark = getattr(place, "landmark", None)
    if len(names) < 2 or isinstance(place, r.Spot) or isinstance(landmark, m.TableTop):
        return False
    parties = [line.members for line in draft.view.lines if line.node is not None]
    parties += [group for f in draft.view.figures if isinstance(f.node, GroupBy) for group in f.node.groups]
    return any(set(party) == set(names) for party in parties)


def _beside_in_line(draft: Draft, line: Line, names: Sequence[str], request: r.Move, anchor: Found) -> bool:
    """Whether blocks go to another place of their row, told by one that stays in it: "shift A to the right of C"."""
    rel = request.place.rel if isinstance(request.place, m.Loc) and not request.place.negated else ""
    inside = line.ordered and line.node is not None and line.kind == "row" and len(anchor.names) == 1
    if rel not in ("left", "right") or not inside or not {*names, *anchor.names} <= set(line.members):
        return False
    rest = [name for name in line.members if name not in names]
    index = rest.index(anchor.names[0]) + (rel == "right")
    put_in_order(draft, line, [*rest[:index], *names, *rest[index:]], request.span)
    draft.look_at(tuple(names))
    return True


def _by_the_other(draft: Draft, place: r.Place, found: Found) -> r.Place:
    """What "the other one" means where a tower or a row is spoken of: the only other one that there is."""
    landmark = getattr(place, "landmark", None)
    other_one = isinstance(landmark, m.Pronoun) and landmark.word in ("the other one", "the other")
    other_one = other_one or (isinstance(landmark, m.Structure) and landmark.det == "other")
    if not isinstance(place, m.Loc) or landmark is None or not other_one or found.line is None:
        return place
    others = [line for line in draft.view.lines if line.kind == found.line.kind and line != found.line]
    if len(others) != 1:
        return place
    world, other = draft.view.world, others[0]
    model = next((n for n in other.members if sum(world.look[n] == world.look[b] for b in world.blocks) == 1), None)
    if model is None:
        return place
    symbol = symbol_of(world, model)
    traits = m.Traits(labels=(symbol,)) if symbol else m.Traits(colors=(world.assets[model].color,))
    held = m.Noun(head="block", det="the", traits=traits, span=landmark.span)
    kind = "stack" if other.kind == "tower" else other.kind
    return replace(place, landmark=m.Structure(kind=kind, det="the", members=held, span=landmark.span))


def _beside_as_now(draft: Draft, place: r.Place, names: Sequence[str]) -> r.Place:
    """What "it" means where a block is to be on another side of it: not that block, but what it is beside so far."""
    landmark = getattr(place, "landmark", None)
    if not isinstance(place, m.Loc) or not isinstance(landmark, m.Pronoun) or not exists(draft.view, landmark):
        return place
    found = [
        atom for _, atom in draft.view.atoms if isinstance(atom, Directional | Beside) and members(atom.a) == names
    ]
    if set(resolve(draft.view, landmark).names) != set(names) or len(found) != 1:
        return place
    if isinstance(found[0].b, Lowest) and sum(line.kind == "tower" for line in draft.view.lines) == 1:
        return replace(place, landmark=m.Structure(kind="stack", det="the", span=landmark.span))
    if not isinstance(found[0].b, tuple) or len(found[0].b) != 1:
        return place
    world, other = draft.view.world, found[0].b[0]
    symbol = symbol_of(world, other)
    traits = m.Traits(labels=(symbol,)) if symbol else m.Traits(colors=(world.assets[other].color,))
    return replace(place, landmark=m.Noun(head="any", det="the", traits=traits, span=landmark.span))


def _without(anchor: Found | None, names: Sequence[str]) -> Found | None:
    """What a place is next to, once the blocks that are to go there have left it."""
    if anchor is None or not set(anchor.names) & set(names):
        return anchor
    rest = tuple(name for name in anchor.names if name not in names)
    return Found(rest, anchor.line and replace(anchor.line, members=rest), None)


def _whole_elsewhere(draft: Draft, found: Found, request: r.Move) -> None:
    """A structure stays what it is and goes elsewhere: a region, a patch or a side that it had gives way to the new."""
    landmark = getattr(request.place, "landmark", None)
    anchor = None if landmark is None or isinstance(landmark, m.TableTop) else resolve(draft.view, landmark)
    near = anchor.names if anchor is not None else ()
    draft.aim("MODIFY" if _leave(draft, found.names, near, request.span) else "EXTEND")
    if isinstance(request.place, m.In) or anchor is None:
        put(draft, found.names, request.place, anchor, request.span)
    elif _onto(request.place) and set(anchor.names) <= set(draft.view.world.patches) and found.line is not None:
        stand_on(draft, draft.view.line_of(found.names) or found.line, anchor.names[-1], request.span)
    else:
        foot = Lowest(lowest=found.names) if found.line is not None and found.line.kind == "tower" else found.names
        place = request.place
        assert isinstance(place, m.Loc)
        goal = relation(draft, place.rel, foot, anchor.names, place.mods, request.span, place)
        draft.do(AddCondition(goal=goal), request.span)
    draft.look_at(found.names)


def _leave(draft: Draft, names: Sequence[str], near: Sequence[str], span: Span) -> bool:
    """Drop the conditions that only say where a structure is; whether there were any."""
    whole = conjuncts(draft.schema.goal)
    rest = [part for part in whole if not _only_where(part, names, near)]
    if rest and len(rest) < len(whole):
        draft.do(SetGoal(goal=rest[0] if len(rest) == 1 else g.All(goals=tuple(rest))), span)
    return len(rest) < len(whole)


def _only_where(part: g.Goal, names: Sequence[str], near: Sequence[str]) -> bool:
    """Does a condition say of a structure only in which region or on which patch it is, or where beside `near`?"""
    if isinstance(part, _FROM_ANOTHER) and set(members(part.b)) != set(near):
        return False
    return isinstance(part, InRegion | OnPatch | _FROM_ANOTHER) and set(members(part.a)) <= set(names)


_FROM_ANOTHER = Directional | Near | Beside | Adjacent | Apart
"""Where something is, seen from something else."""


def _give_way(draft: Draft, names: Sequence[str], request: r.Move, anchor: Found | None) -> None:
    """Drop what the goal asks of `names`, but for how they are turned, then ask for the new place."""
    before = draft.schema.goal
    turned = [part for part in conjuncts(before) if isinstance(part, Facing | Turned) and part.block in names]
    goal = before
    for name in names:
        goal = close(goal, name)
    left = without(goal, set(names))
    if isinstance(before, g.Sequence) and not (isinstance(left, g.Sequence) and len(left.stages) == len(before.stages)):
        told, hint = "this would leave nothing of one of the steps", "say the steps anew: first ..., then ..."
        raise draft.refusal("breaks-structure", told, request.span, hint)
    if left is not None:
        draft.do(SetGoal(goal=left), request.span)
    if anchor is not None and anchor.line is not None:
        anchor = replace(anchor, line=draft.view.line_of(anchor.names))
    put(draft, names, request.place, anchor, request.span, draft.view.main_line() if left is not None else None)
    if left is None:
        new = conjuncts(draft.schema.goal)[len(conjuncts(before)) :]
        if not new:
            raise draft.refusal(
                "edit-unclear", "this place cannot be asked for here", request.span, "say the whole goal"
            )
        draft.do(SetGoal(goal=new[0] if len(new) == 1 else g.All(goals=new)), request.span)
        if ("stack" in structures(before)) != ("stack" in structures(draft.schema.goal)):
            draft.aim("PIVOT")
    for part in turned:
        draft.do(AddCondition(goal=part), request.span)
    draft.look_at(tuple(names))


def _move_in_line(draft: Draft, line: Line, names: Sequence[str], request: r.Move) -> None:
    assert isinstance(request.place, r.Spot)
    rest = [name for name in line.members if name not in names]
    side = request.place.side
    last = side in ("top", "end", "right", "back")
    index = len(rest) // 2 if side == "middle" else len(rest) if last else 0
    fits = {"top": "tower", "bottom": "tower", "left": "row", "right": "row", "front": "column", "back": "column"}
    if fits.get(side, line.kind) != line.kind:
        raise draft.refusal(
            "edit-unclear", f"a {line.kind} has no {side} end", request.span, "name a block to put it beside"
        )
    put_in_order(draft, line, [*rest[:index], *names, *rest[index:]], request.span)
    draft.look_at(tuple(names))
