"""A goal in one compact line, for messages and tests."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel

from rpg.ir import goal as g
from rpg.ir.node import Highest, Lowest


def sketch(goal: g.Goal) -> str:
    """ "on(red_block, blue_block) and row(A_block, B_block; axis=y)"."""
    match goal:
        case g.All():
            return " and ".join(_wrapped(x) for x in goal.goals)
        case g.Any():
            return " or ".join(_wrapped(x) for x in goal.goals)
        case g.Not():
            return f"not {_wrapped(goal.goal)}"
        case g.Count():
            high = "" if goal.at_most is None else str(goal.at_most)
            return f"count[{goal.at_least}..{high}]({', '.join(goal.over)}: {sketch(goal.goal)})"
        case g.Sequence():
            return " then ".join(_wrapped(x.goal) + (" (undone)" if x.undone else "") for x in goal.stages)
        case g.Always():
            return f"always({sketch(goal.goal)})"
    return _atom(goal)


def _wrapped(goal: g.Goal) -> str:
    text = sketch(goal)
    return f"({text})" if isinstance(goal, g.All | g.Any | g.Sequence) else text


def _atom(goal: Any) -> str:
    main, rest = [], []
    for name, field in type(goal).model_fields.items():
        value = getattr(goal, name)
        if name in ("kind", "span") or (not field.is_required() and value == field.default):
            continue
        if field.is_required():
            main.append(_value(value))
        else:
            rest.append(f"{name}={_value(value)}")
    inner = ", ".join(main) + ("; " + ", ".join(rest) if rest else "")
    return f"{goal.kind}({inner})"


def _value(value: Any) -> str:
    if isinstance(value, Lowest):
        return f"lowest({' '.join(value.lowest)})"
    if isinstance(value, Highest):
        return f"highest({' '.join(value.highest)})"
    if isinstance(value, BaseModel):
        parts = [_value(getattr(value, n)) if n in ("by", "kind") else f"{n}={_value(getattr(value, n))}" for n,
            f in type(value).model_fields.items()
                 if getattr(value, n) != f.default]  # fmt: skip
        return "[" + " ".join(parts) + "]"
    if isinstance(value, tuple):
        return " ".join("{" + _value(v) + "}" if isinstance(v, tuple) and len(v) > 1 else _value(v) for v in value)
    return str(value)
