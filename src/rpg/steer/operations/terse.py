"""Requests that say only what is to be otherwise, and leave the rest as it is."""

from __future__ import annotations

from dataclasses import replace

from rpg.core.diagnostics import Refusal
from rpg.ir import goal as g
from rpg.ir.edits import ChangeCondition, DropCondition, Path, SetGoal
from rpg.ir.node import EACH, members
from rpg.ir.relations import Adjacent, Beside, Directional, InRegion, Near, On, OnPatch, OnTable
from rpg.ir.structures import Row, Stack
from rpg.ir.walk import transform
from rpg.steer.draft import Draft
from rpg.steer.matching import matches
from rpg.steer.operations.add import add
from rpg.steer.operations.move import move
from rpg.steer.operations.relate import relation
from rpg.steer.operations.reshape import reshape
from rpg.steer.operations.restyle import restyle
from rpg.steer.operations.vary import some
from rpg.steer.refer import exists, resolve
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import m
from rpg.steer.requests.terse import Bound, Bring, More, PileUp, Shift, Tint


def tint(draft: Draft, request: Tint) -> None:
    """A colour for what was spoken of last; without that, for blocks that have one look."""
    view = draft.view
    names = view.focus or view.busy
    if len({view.world.look[name] for name in names if name in view.world.blocks}) != 1:
        told, hint = "it is not said which blocks get this colour", "name them: make the red block white"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    draft.look_at(names)
    theme = m.Pronoun(word="it" if len(names) == 1 else "them", span=request.span)
    restyle(draft, r.Restyle(theme=theme, traits=m.Traits(colors=(request.color,)), span=request.span))


def bound(draft: Draft, request: Bound) -> None:
    """Another number in the only count of the goal; where nothing is counted yet, of all that a condition is about."""
    found: list[g.Count] = []

    def counting(node: g.Goal) -> g.Goal:
        node = _counted(node) or node
        if isinstance(node, g.Count):
            found.append(node)
        return node

    goal = transform(draft.schema.goal, counting)
    if not found and (request.bound == "as_now" or request.amount is None):
        raise draft.refusal(
            "edit-unclear", "nothing is counted here", request.span, "say which blocks, and what of them"
        )
    if not found and request.amount is not None:
        some(draft, r.Some(bound=request.bound, amount=request.amount, span=request.span))
        return
    wanted = len(found[0].over) if request.amount is None else request.amount
    if len(found) > 1 or not 0 < wanted <= len(found[0].over):
        told = (
            f"there are {len(found[0].over)} blocks that are counted" if len(found) == 1 else "more than one is counted"
        )
        raise draft.refusal("edit-unclear", told, request.span, "say of which blocks, and how many")
    least = request.bound in ("exactly", "at_least") or (request.bound == "as_now" and found[0].at_least > 0)
    most = request.bound in ("exactly", "at_most") or (request.bound == "as_now" and found[0].at_most is not None)
    low, high = wanted if least else 0, wanted if most else None
    new = found[0].model_copy(update={"at_least": low, "at_most": high})
    if new == found[0]:
        raise draft.refusal("nothing-to-do", "it is so many already", request.span)
    draft.aim("TWEAK")
    draft.note("count", {request.bound: wanted})
    draft.do(SetGoal(goal=transform(goal, lambda node: new if node == found[0] else node)), request.span)


def _counted(node: g.Goal) -> g.Count | None:
    """ "At least one of two" as a count: the same is asked of each of several blocks, of which one will do."""
    if not isinstance(node, g.Any) or any(not isinstance(part, OnPatch | OnTable | InRegion) for part in node.goals):
        return None
    over = tuple(name for part in node.goals for name in members(getattr(part, "a", ())))
    each = [part.model_copy(update={"a": (EACH,), "span": None}) for part in node.goals]
    if len(over) != len(each) or any(part != each[0] for part in each):
        return None
    return g.Count(over=over, at_least=1, goal=each[0])


def bring(draft: Draft, request: Bring) -> None:
    """A new block that was named like one that is there; where the task has such a block, that one would be meant: it
    is moved where what it goes to is named likewise, "C on A"."""
    there = [name for name in draft.view.world.blocks if matches(draft.view, name, request.theme.traits)]
    near = getattr(request.place, "landmark", None)
    if there and isinstance(near, m.Noun) and near.det == "bare" and not exists(draft.view, near):
        _bring_other(draft, request, near)
        return
    named = isinstance(near, m.Noun) and near.det == "bare" and near.amount is None
    if len(there) == 1 and named and isinstance(near, m.Noun) and isinstance(request.place, m.Loc):
        one, other = (replace(each, det="the", amount=None) for each in (request.theme, near))
        move(draft, r.Move(theme=one, place=replace(request.place, landmark=other), span=request.span))
        return
    if there:
        told, hint = "the task has such a block", "say 'another ...' for one more, or 'move the ...'"
        raise draft.refusal("ambiguous-object", told, request.theme.span, hint)
    add(draft, r.Add(theme=request.theme, places=(request.place,), span=request.span))


_BACK = {"left": "right", "right": "left", "front": "behind", "behind": "front", "beside": "beside"}


def _bring_other(draft: Draft, request: Bring, near: m.Noun) -> None:
    """Phrases such as "blue left of white", where the task has a blue block alone: a white one comes to its right."""
    place = request.place
    if not isinstance(place, m.Loc) or place.rel not in _BACK or place.negated or near.head == "patch" or near.plural:
        told, hint = "the task does not have both of these", "say 'a white block' for one that is to be added"
        raise draft.refusal("ambiguous-object", told, near.span, hint)
    there = replace(place, rel=_BACK[place.rel], landmark=replace(request.theme, det="the", amount=None))
    new = replace(near, det="a", amount=m.Amount(1, 1))
    add(draft, r.Add(theme=new, places=(there,), span=request.span))


def more(draft: Draft, request: More) -> None:
    """One more of what was spoken of last, or of blocks of the look that is said."""
    view, plain = draft.view, request.theme.traits == m.Traits() and request.theme.head in ("any", "block")
    if plain and not set(view.focus) & set(view.world.blocks) and len({view.world.look[n] for n in view.busy}) > 1:
        told, hint = "these blocks do not all look alike, so that it is not said which", "say its colour"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    add(draft, r.Add(theme=request.theme, span=request.span))


def shift(draft: Draft, request: Shift) -> None:
    """What the goal says of where one thing is gives way to the place that is named."""
    place, view = request.place, draft.view
    if isinstance(place, m.In):
        regions = [(path, atom) for path, atom in view.atoms if isinstance(atom, InRegion)]
        if len(regions) != 1 or place.negated:
            raise _unclear(draft, request)
        path, region = regions[0]
        if request.former is not None and region.region != request.former.region:
            told, hint = "it is not there so far", "say only where it is to be"
            raise draft.refusal("edit-unclear", told, request.former.span, hint)
        _put(draft, path, InRegion.model_validate({"a": region.a, "region": place.region}), request)
        return
    found = [(path, atom) for path, atom in view.atoms if isinstance(atom, PLACED)]
    if view.focus:
        found = [each for each in found if set(members(each[1].a)) <= set(view.focus)]
    if not isinstance(place, m.Loc) or len(found) != 1:
        raise _unclear(draft, request)
    path, atom = found[0]
    landmark = place.landmark
    if landmark is not None and set(resolve(view, landmark).names) != set(members(atom.b)):
        raise _unclear(draft, request)
    mods = place.mods or tuple(mod for mod in ("directly", "immediate", "somewhere") if getattr(atom, mod, False))
    _put(draft, path, relation(draft, place.rel, atom.a, atom.b, mods, request.span, place), request)
    draft.look_at(tuple(name for name in members(atom.a) if name in view.world.blocks))


PLACED = (Directional, On, Beside, Adjacent, Near)
"""Relations of one thing to another, of which another one may take the place."""


def _put(draft: Draft, path: Path, new: g.Goal, request: Shift) -> None:
    draft.aim("MODIFY")
    draft.note("place", new.kind)
    before = draft.schema.goal
    draft.do(ChangeCondition(at=path, to=new), request.span)
    if draft.schema.goal == before:
        raise draft.refusal("nothing-to-do", "it is there already", request.span)


def _unclear(draft: Draft, request: Shift) -> Refusal:
    told, hint = "it is not settled what is to be there", "say which block: put the red block behind the blue one"
    return draft.refusal("edit-unclear", told, request.span, hint)


def pile_up(draft: Draft, request: PileUp) -> None:
    """Blocks on a patch are stacked there; others that form something together form a stack instead."""
    on = [(path, a) for path, a in draft.view.atoms if isinstance(a, OnPatch) and isinstance(a.a, tuple) and a.a[1:]]
    if not on:
        wanted = m.Structure(kind="stack", span=request.span)
        reshape(draft, r.Reshape(structure=wanted, theme=m.Pronoun(word="them", span=request.span), span=request.span))
        return
    draft.aim("MODIFY")
    draft.note("structure", {"to": "stack"})
    for path, atom in on:
        assert isinstance(atom.a, tuple)
        draft.do(ChangeCondition(at=path, to=Stack(blocks=atom.a, patch=atom.patch)), request.span)
    stacked = [set(atom.a) for _, atom in on if isinstance(atom.a, tuple)]
    for path, other in reversed(draft.view.atoms):
        if isinstance(other, Row) and any(set(other.blocks) <= each for each in stacked):
            draft.do(DropCondition(at=path), request.span)
