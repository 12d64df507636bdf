""" "Red is on green. Put a blue block between them": what goes between blocks that lie on each other goes into the
tower."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import members
from rpg.ir.order import Order
from rpg.ir.walk import atoms
from rpg.passes.schema.resolve.things.world import Scene


def into_their_tower(goal: g.Goal, scene: Scene) -> g.Goal:
    """`goal` with the tower of the start and the block in it, where nothing else is said of the blocks around it."""
    parts = goal.goals if isinstance(goal, g.All) else (goal,)
    found = [_within(part, parts, scene) or part for part in parts]
    if found == [*parts]:
        return goal
    return goal.model_copy(update={"goals": tuple(found)}) if isinstance(goal, g.All) else found[0]


def _within(part: g.Goal, parts: tuple[g.Goal, ...], scene: Scene) -> g.Goal | None:
    if not isinstance(part, r.Between):
        return None
    ends = [members(end) for end in (part.a, part.b, part.c)]
    if any(len(end) != 1 for end in ends):
        return None
    (block,), *around = ends
    told = {n for other in parts if other is not part for atom in atoms(other) for n in members(getattr(atom, "a", ()))}
    pair = {end[0] for end in around}
    towers = (_upward(start) for start in scene.start_goals)
    tower = next((x for x in towers if any({*x[n : n + 2]} == pair for n in range(len(x) - 1))), ())
    if not tower or block in tower or told & {*tower, block}:
        return None
    at = min(tower.index(name) for name in pair) + 1
    names = (*tower[:at], block, *tower[at:])
    order = Order(by="given", ranks=tuple((n,) for n in names), first="bottom")
    return s.Stack(blocks=names, order=order, span=part.span)


def _upward(start: g.Goal) -> tuple[str, ...]:
    """The blocks of a tower of the start from the bottom up, where that is said."""
    if isinstance(start, r.On) and isinstance(start.a, tuple) and isinstance(start.b, tuple):
        return (*start.b, *start.a) if len(start.a) == len(start.b) == 1 else ()
    if not isinstance(start, s.Stack) or start.order.by != "given" or any(len(x) > 1 for x in start.order.ranks):
        return ()
    ranks = tuple(rank[0] for rank in start.order.ranks)
    return ranks[::-1] if start.order.first == "top" else ranks
