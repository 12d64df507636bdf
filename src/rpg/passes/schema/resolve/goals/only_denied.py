"""Goals that only deny: "no red block touches the blue one" holds wherever blocks usually start."""

from __future__ import annotations

from rpg.blocks.english import clause
from rpg.blocks.state import World
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.assets import Asset
from rpg.ir.relations import OnTable
from rpg.ir.schema import InitialState
from rpg.ir.walk import atoms


def still_ahead(goal: g.Goal, start: InitialState, assets: tuple[Asset, ...]) -> tuple[InitialState, tuple[str, ...]]:
    """A start in which what the goal denies is so, where nothing is said of the start, and the assumption.

    That blocks are on the table is so at most starts, too.
    """
    parts = goal.goals if isinstance(goal, g.All) else (goal,)
    parts = tuple(part for part in parts if not isinstance(part, OnTable))
    broken = [denied for part in parts if (denied := _broken(part)) is not None]
    if start != InitialState() or not broken or len(broken) < len(parts):
        return start, ()
    first = broken[0].model_copy(update={"span": None})
    told = clause(first, World(assets))
    return InitialState(arranged=(first,)), (f"the goal would hold at most starts, so at the start {told}",)


def _broken(part: g.Goal) -> g.Goal | None:
    """What such a part denies, by as little as it can; None where it asks for something, or tells of what is moved:
    at the start nothing is."""
    if any(isinstance(atom, r.Stayed | r.Moved | r.Shifted | r.Swapped | r.TookPlace) for atom in atoms(part)):
        return None
    match part:
        case g.Not(goal=g.Any(goals=goals)):
            return goals[0]
        case g.Not():
            return part.goal
        case g.Count(goal=g.Not()) if part.at_least == 0:
            return None
        case g.Count() if part.at_least == 0 and part.at_most is not None and part.at_most < len(part.over):
            more = part.at_most + 1
            return part.model_copy(update={"at_least": more, "at_most": more})
        case g.Any(goals=goals) if all(isinstance(x, g.Not) for x in goals):
            return g.All(goals=tuple(x.goal for x in goals if isinstance(x, g.Not)))
        case g.Count(goal=g.Not(goal=told)) if part.at_most is None and part.at_least > 0:
            many = len(part.over) - part.at_least + 1
            return part.model_copy(update={"goal": told, "at_least": many, "at_most": many})
    return None
