"""What carries out each kind of request, and requests carried out one after the other."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from pydantic import ValidationError

from rpg.ir import goal as g
from rpg.ir.edits import AddCondition
from rpg.ir.node import members
from rpg.ir.relations import Stayed
from rpg.ir.shrink import TooSmall
from rpg.ir.walk import names as mentions
from rpg.steer.draft import Draft
from rpg.steer.operations.add import add
from rpg.steer.operations.count import recount
from rpg.steer.operations.kinds import mixed
from rpg.steer.operations.move import move
from rpg.steer.operations.order import group, reorder
from rpg.steer.operations.parties import new_tower, so_many, told_apart
from rpg.steer.operations.parts import drop_part, part
from rpg.steer.operations.remove import remove
from rpg.steer.operations.reshape import reshape
from rpg.steer.operations.restyle import replace as replace_blocks
from rpg.steer.operations.restyle import restyle
from rpg.steer.operations.starts import begin
from rpg.steer.operations.symbols import carry_on, equate, other_word
from rpg.steer.operations.terse import bound, bring, more, pile_up, shift, tint
from rpg.steer.operations.trading import trade, trade_colors
from rpg.steer.operations.tune import loosen, outliers
from rpg.steer.operations.vary import across, climb, closer, copies, divide, enough, free, some, turn
from rpg.steer.refer import resolve
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import m
from rpg.steer.requests.parties import NewTower, SoManyTowers
from rpg.steer.requests.parts import DropPart, Part
from rpg.steer.requests.replacing import TradeColors
from rpg.steer.requests.starts import Begin
from rpg.steer.requests.symbols import Continue, Equate, Respell
from rpg.steer.requests.terse import Bound, Bring, More, PileUp, Shift, Tint

OPERATIONS: dict[type[r.Request], Callable[[Draft, Any], None]] = {
    r.Add: add,
    r.Remove: remove,
    r.Replace: replace_blocks,
    r.Restyle: restyle,
    r.Recount: recount,
    r.Reorder: reorder,
    r.Trade: trade,
    r.Move: move,
    r.Reshape: reshape,
    r.Loosen: loosen,
    r.Outliers: outliers,
    r.Kinds: mixed,
    r.Group: group,
    r.Some: some,
    r.Enough: enough,
    r.Copies: copies,
    r.Divide: divide,
    r.Closer: closer,
    r.Climb: climb,
    r.Turn: turn,
    r.Across: across,
    r.Free: free,
    NewTower: new_tower,
    SoManyTowers: so_many,
    TradeColors: trade_colors,
    Part: part,
    DropPart: drop_part,
    Equate: equate,
    Respell: other_word,
    Tint: tint,
    Bound: bound,
    PileUp: pile_up,
    Bring: bring,
    More: more,
    Shift: shift,
    Begin: begin,
    Continue: carry_on,
}
WEAK = (Shift, Bring, More, Part, DropPart, Respell)
"""Readings of few words: where they cannot be carried out, the words may still be a sentence about the task."""


def carry_out(draft: Draft, requests: Sequence[r.Request]) -> None:
    """Apply requests in turn; what is to be kept counts for all of them."""
    told_apart(draft, requests)
    lasting: list[tuple[r.Keep, g.Goal]] = []
    for index, request in enumerate(requests):
        if isinstance(request, r.Keep):
            names = resolve(draft.view, _meant(request, requests[:index])).names
            draft.kept += names
            if not draft.focus:
                draft.look_at(names)
            lasting += [(request, atom) for atom in _kept_so(draft, request, names)]
    for request in requests:
        if not isinstance(request, r.Keep):
            try:
                OPERATIONS[type(request)](draft, request)
            except (ValidationError, TooSmall) as error:
                told, hint = "this is more than the goal of a task can say", "say it as an instruction of its own"
                raise draft.refusal("edit-unclear", told, request.span, hint) from error
    if requests and all(isinstance(request, r.Keep) for request in requests):
        draft.aim("EXTEND")
        staying = {name for _, atom in draft.view.atoms if isinstance(atom, Stayed) for name in members(atom.a)}
        if not set(draft.kept) <= staying:
            draft.do(AddCondition(goal=Stayed(a=draft.kept)))
    for request, atom in lasting:
        if atom not in [each for _, each in draft.view.atoms]:
            told, hint = "the rest of the request does not leave this as it is", "say what is to change, or what is not"
            raise draft.refusal("edit-unclear", told, request.span, hint)


def _meant(request: r.Keep, before: Sequence[r.Request]) -> m.Meaning:
    """What is kept; a pronoun takes up what the request before is about."""
    earlier = getattr(before[-1], "theme", None) if before else None
    return earlier if isinstance(request.theme, m.Pronoun) and isinstance(earlier, m.Noun) else request.theme


def _kept_so(draft: Draft, request: r.Keep, names: tuple[str, ...]) -> list[g.Goal]:
    """The conditions of the goal that say what a request wants kept, as "keep it to the right of the blue block"."""
    where = request.place
    landmark = getattr(where, "landmark", None)
    if not isinstance(where, m.Loc) or landmark is None:
        return []
    others = resolve(draft.view, landmark).names
    atoms = [atom for _, atom in draft.view.atoms if {*names, *others} <= set(mentions(atom))]
    if not atoms:
        told, hint = "the goal does not say so, so that there is nothing to keep", "say where it is to be put"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    return atoms
