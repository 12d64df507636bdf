"""How the blocks of a task start."""

from __future__ import annotations

from rpg.ir.edits import SetStart
from rpg.ir.order import Order
from rpg.ir.schema import InitialState
from rpg.ir.structures import Row, Stack
from rpg.steer.draft import Draft
from rpg.steer.refer import resolve
from rpg.steer.requests.starts import Begin


def begin(draft: Draft, request: Begin) -> None:
    """Another start: all blocks scattered, in a heap, in a row, or the tower of the goal turned round."""
    draft.aim("TWEAK")
    draft.note("start", request.how)
    init = InitialState(vacant=draft.schema.init.vacant)
    if request.how in ("heap", "row"):
        view = draft.view
        names = view.busy if view.idle else tuple(view.world.blocks)
        if len(names) < 2:
            raise draft.refusal("edit-unclear", f"one block is no {request.how}", request.span, "say where it starts")
        told = {"heaps": (names,)} if request.how == "heap" else {"arranged": (Row(blocks=names),)}
        init = init.model_copy(update=told)
    if request.how == "reverse":
        init = init.model_copy(update={"arranged": (_turned(draft, request),)})
    if init == draft.schema.init:
        raise draft.refusal("nothing-to-do", "the blocks start like this already", request.span)
    draft.do(SetStart(init=init), request.span)


def _turned(draft: Draft, request: Begin) -> Stack:
    """The tower of the goal, its lowest block on top."""
    line = draft.view.main_line()
    looks = draft.view.world.look
    distinct = line is not None and len({looks[name] for name in line.members}) == len(line.members)
    if line is None or line.kind != "tower" or not line.ordered or not distinct:
        told, hint = (
            "there is no tower in a certain order that could be turned round",
            "say what is on what at the start",
        )
        raise draft.refusal("edit-unclear", told, request.span, hint)
    told_names = [name for each in request.told for name in resolve(draft.view, each).names]
    if request.told and told_names != list(line.members):
        hint = "leave out what is said again"
        raise draft.refusal("edit-unclear", "this is not the tower the other way round", request.told[0].span, hint)
    members = tuple(reversed(line.members))
    return Stack(blocks=members, order=Order(by="given", ranks=tuple((name,) for name in members)))
