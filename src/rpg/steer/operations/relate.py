"""Relation words of the language as goal atoms."""

from __future__ import annotations

from typing import Any

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as rel
from rpg.ir.node import Operand, members
from rpg.steer.draft import Draft
from rpg.steer.requests.language import m

DIRECTIONS: dict[str, type[rel.Directional]] = {
    "left": rel.LeftOf,
    "right": rel.RightOf,
    "front": rel.InFrontOf,
    "behind": rel.Behind,
}
PLAIN: dict[str, Any] = {
    "on": rel.On,
    "above": rel.Above,
    "beside": rel.Beside,
    "side_by_side": rel.Beside,
    "adjacent": rel.Adjacent,
    "touching": rel.Touching,
    "near": rel.Near,
    "together": rel.Near,
    "apart": rel.Apart,
}


def relation(
    draft: Draft, word: str, a: Operand, b: Operand, mods: tuple[str, ...], span: Span, place: m.Loc | None = None
) -> g.Goal:
    """The atom that says `a` is `word` of `b`."""
    if "start" in mods or (place is not None and place.second is not None):
        raise draft.refusal(
            "edit-unclear", "this place cannot be asked for in an edit", span, "give the whole instruction"
        )
    if word in DIRECTIONS:
        flags = {name: True for name in ("directly", "immediate", "somewhere") if name in mods}
        atom: g.Goal = DIRECTIONS[word].model_validate({"a": a, "b": b, **flags})  # type: ignore[assignment]
        if place is not None and (place.low is not None or place.high is not None):
            atom = g.All(goals=(atom, _distance(a, b, place)))
    elif word == "under":
        atom = rel.On(a=b, b=a)
    elif word in ("between", "sandwiched") and len(members(b)) == 2:
        atom = rel.Between(a=a, b=members(b)[:1], c=members(b)[1:])
    elif word == "distance" and place is not None:
        atom = _distance(a, b, place)
    elif word in PLAIN:
        atom = PLAIN[word](a=a, b=b)
    else:
        raise draft.refusal(
            "edit-unclear",
            f"{word!r} is no place beside a block",
            span,
            "say on top of, beside, to the left of, between ...",
        )
    return g.Not(goal=atom) if place is not None and place.negated else atom


def _distance(a: Operand, b: Operand, place: m.Loc) -> rel.Distance:
    measure = "faces" if place.measure == "faces" else "centres"
    return rel.Distance.model_validate(
        {"a": a, "b": b, "minimum": place.low, "maximum": place.high, "measure": measure}
    )
