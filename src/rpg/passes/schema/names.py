"""Family names: short slugs from the goal."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import members
from rpg.ir.schema import shortened
from rpg.ir.walk import children

LONGEST = 48


def family_name(goal: g.Goal) -> str:
    """ "red-on-yellow", "stack-of-3", "spell-cat" ...; two atoms at most."""
    parts = list(dict.fromkeys(_parts(goal)))
    text = ("-or-" if isinstance(goal, g.Any) else "-and-").join(parts[:2]) or "task"
    slug = re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-") or "task"
    return shortened(slug, LONGEST, "-")


def _parts(goal: g.Goal) -> Iterator[str]:
    """What each atom asks for; of counted ones, how many."""
    if isinstance(goal, g.Count):
        many = goal.at_least or goal.at_most or 0
        yield from (part.replace(f"{goal.var}-", f"{many}-of-{len(goal.over)}-", 1) for part in _parts(goal.goal))
    elif isinstance(goal, g.Not):
        yield from (f"not-{part}" for part in _parts(goal.goal))
    elif inner := children(goal):
        for part in inner:
            yield from _parts(part)
    else:
        yield _part(goal)


def _short(operand: object) -> str:
    names = members(operand)
    if len(names) > 2:
        return f"{len(names)}-blocks"
    return "-".join(re.sub(r"_block|_patch$", "", n).replace("_", "-") for n in names)


def _part(atom: g.Goal) -> str:
    match atom.kind:
        case "stack":
            return f"stack-of-{len(atom.blocks)}"
        case "towers":
            return f"{atom.count or 'some'}-towers"
        case "row" | "grid" | "pyramid" | "staircase":
            return f"{atom.kind}-of-{len(atom.blocks)}"
        case "figure":
            return f"{atom.shape}-of-{len(atom.blocks)}"
        case "group_by":
            return f"{len(atom.groups)}-groups" + (f"-by-{atom.by}" if atom.by else "")
        case "spells":
            return f"spell-{atom.word}"
        case "equation":
            return "equation"
        case "on_patch":
            return f"{_short(atom.a)}-on-{atom.patch.replace('_', '-')}"
    if isinstance(atom, r.Facing | r.Turned):
        return f"{_short((atom.block,))}-{'facing' if atom.kind == 'facing' else 'turned'}"
    a = _short(getattr(atom, "a", None) or (getattr(atom, "patch", ""),))
    b = getattr(atom, "b", None)
    return f"{a}-{atom.kind}-{_short(b)}" if b is not None and b != getattr(atom, "a", None) else f"{a}-{atom.kind}"
