"""The goal put in order: towers that something goes on are not exact, stacks put on patches carry the patch."""

from __future__ import annotations

from collections.abc import Iterable

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.assets import EDGE
from rpg.ir.node import members
from rpg.ir.walk import children, rebuild, transform, without_span
from rpg.passes.schema.resolve.goals.each_on_one import each_on_one
from rpg.passes.schema.resolve.goals.neighbours import in_lines, in_stacks
from rpg.passes.schema.resolve.goals.not_directly import not_directly
from rpg.passes.schema.resolve.goals.parts_of_line import in_one_line
from rpg.passes.schema.resolve.goals.spacing import spaced
from rpg.passes.schema.resolve.things.world import Scene


def tidy(goal: g.Goal, scene: Scene) -> g.Goal:
    """Rewrites that keep the meaning of the whole, and of how it starts."""
    if len(scene.start_goals) > 1:
        scene.start_goals = list(children(_open_tops(g.All(goals=tuple(scene.start_goals)))))
    sizes = {thing.name: thing.edge or EDGE for thing in scene.blocks()}
    goal = in_stacks(in_lines(_diagonals(_excused(each_on_one(in_one_line(goal, scene)))), scene), scene)
    return spaced(_open_tops(_stack_patches(not_directly(_group_by_group(goal, scene)))), sizes)


MANY = 3
"""Of so many at least, what is said of all of them has exceptions."""


def _excused(goal: g.Goal) -> g.Goal:
    """ "All letters are upright, but the N is upside down": the turn of one is an exception to what is said of all."""

    def change(node: g.Goal) -> g.Goal:
        if not isinstance(node, g.All):
            return node
        turns = [x for x in node.goals if isinstance(x, r.Facing) and x.turn is not None]
        several = [x.span for x in turns]
        own = {x.block for x in turns if x.turn and several.count(x.span) < MANY}
        goals = tuple(
            x
            for x in node.goals
            if not (isinstance(x, r.Facing) and x.turn == 0 and x.block in own and several.count(x.span) >= MANY)
        )
        return node if goals == node.goals else node.model_copy(update={"goals": goals})

    return transform(goal, change)


def _diagonals(goal: g.Goal) -> g.Goal:
    """ "Behind it and to its left": along each axis alone, for no block is more behind than left and more left than
    behind at once."""

    def change(node: g.Goal) -> g.Goal:
        if not isinstance(node, g.All):
            return node
        across = {(x.a, x.b) for x in node.goals if isinstance(x, r.LeftOf | r.RightOf) and not x.directly}
        deep = {(x.a, x.b) for x in node.goals if isinstance(x, r.InFrontOf | r.Behind) and not x.directly}
        sides = r.LeftOf | r.RightOf | r.InFrontOf | r.Behind
        goals = tuple(
            x.model_copy(update={"somewhere": True}) if isinstance(x, sides) and (x.a, x.b) in across & deep else x
            for x in node.goals
        )
        return node if goals == node.goals else node.model_copy(update={"goals": goals})

    return transform(goal, change)


def _group_by_group(goal: g.Goal, scene: Scene) -> g.Goal:
    """ "Group the cubes A, B, 1 and 2: letters together, digits together": not all of them in one."""

    def change(node: g.Goal) -> g.Goal:
        if not isinstance(node, g.All):
            return node
        groupings = [x for x in node.goals if isinstance(x, s.GroupBy)]
        lots = [frozenset(lot) for x in groupings for lot in x.groups]
        parted = {frozenset(lot) for x in groupings if len(x.groups) > 1 and not x.outliers for lot in x.groups}
        gone = [
            x
            for x in groupings
            for whole in map(frozenset, x.groups)
            if len(x.groups) == 1
            and ((whole in scene.gathered and sum(lot < whole for lot in lots) > 1) or whole in parted)
        ]
        return node.model_copy(update={"goals": tuple(x for x in node.goals if x not in gone)}) if gone else node

    return transform(goal, change)


def once(goals: Iterable[g.Goal]) -> tuple[g.Goal, ...]:
    """`goals` without those that say the same as an earlier one, in whatever words."""
    kept: dict[g.Goal, g.Goal] = {}
    for goal in goals:
        kept.setdefault(transform(goal, without_span), goal)
    return tuple(kept.values())


def _stack_patches(goal: g.Goal) -> g.Goal:
    """all(stack(b...), on_patch(b..., p)) is stack(b..., patch=p)."""

    def change(node: g.Goal) -> g.Goal:
        if not isinstance(node, g.All):
            return node
        goals = list(once(node.goals))
        for stack in [x for x in goals if isinstance(x, s.Stack)]:
            for on in [x for x in goals if isinstance(x, r.OnPatch)]:
                if stack.patch is None and isinstance(on.a, tuple) and set(on.a) == set(stack.blocks):
                    goals[goals.index(stack)] = stack.model_copy(update={"patch": on.patch})
                    goals.remove(on)
                    break
        goals = _one_grouping(_tower_patches(_one_account(_without_implied(goals))))
        return goals[0] if len(goals) == 1 else node.model_copy(update={"goals": tuple(goals)})

    return transform(goal, change)


def _without_implied(goals: list[g.Goal]) -> list[g.Goal]:
    """ "All in one tower" adds nothing to a stack of the same blocks in an order, and no more does a row to a row."""
    rows = [x for x in goals if isinstance(x, s.Row)]
    bare = [x for x in rows if x == s.Row(blocks=x.blocks, axis=x.axis, span=x.span)]
    for row in bare:
        told = [y for y in rows if y not in bare and set(y.blocks) == set(row.blocks) and row.axis in (None, y.axis)]
        goals = [x for x in goals if x is not row] if told else goals
    stacks = [x for x in goals if isinstance(x, s.Stack)]
    plain = [x for x in stacks if x == s.Stack(blocks=x.blocks, span=x.span)]
    implied = [x for x in plain if any(y not in plain and set(y.blocks) == set(x.blocks) for y in stacks)]
    return [x for x in goals if x not in implied]


def _one_account(goals: list[g.Goal]) -> list[g.Goal]:
    """ "Three towers" and "towers of equal height" of the same blocks are one account of them."""
    towers = [x for x in goals if isinstance(x, s.Towers)]
    if len(towers) < 2 or len({frozenset(x.blocks) for x in towers}) > 1:
        return goals
    told: dict[str, object] = {}
    for tower in towers:
        for field in ("count", "heights", "equal", "each", "separate", "matching"):
            value = getattr(tower, field)
            if value and told.setdefault(field, value) != value:
                return goals
    return [x.model_copy(update=told) if x is towers[0] else x for x in goals if x is towers[0] or x not in towers]


def _one_grouping(goals: list[g.Goal]) -> list[g.Goal]:
    """Piles named one by one are groups that lie apart."""
    piles = [x for x in goals if isinstance(x, s.GroupBy) and len(x.groups) == 1 and x.inner_edges == 2.0]
    named = [n for x in piles for n in x.groups[0]]
    if len(piles) < 2 or len(set(named)) < len(named):
        return goals
    whole = piles[0].model_copy(update={"groups": tuple(x.groups[0] for x in piles)})
    return [whole if x is piles[0] else x for x in goals if x is piles[0] or x not in piles]


def _tower_patches(goals: list[g.Goal]) -> list[g.Goal]:
    """all(towers(...), on_patch of every colour) is towers(..., matching=patches)."""
    for towers in [x for x in goals if isinstance(x, s.Towers)]:
        patched = [
            x for x in goals if isinstance(x, r.OnPatch) and isinstance(x.a, tuple) and set(x.a) <= set(towers.blocks)
        ]
        covered = {n for x in patched for n in members(x.a)}
        if towers.each == "color" and len(patched) > 1 and covered == set(towers.blocks) and towers.matching is None:
            new = towers.model_copy(update={"matching": tuple(x.patch for x in patched)})
            return [new if x is towers else x for x in goals if x not in patched]
    return goals


Put = tuple[frozenset[str], frozenset[str]]
"""What goes on what."""


def _open_tops(goal: g.Goal, beside: tuple[Put, ...] = ()) -> g.Goal:
    """A counted tower that something else goes on is not exact any more; what goes there is denied or another
    alternative leaves it as it is."""
    if isinstance(goal, g.Not):
        return goal
    if isinstance(goal, s.Stack):
        open_ = goal.exact and any(upper - {*goal.blocks} and lower & {*goal.blocks} for upper, lower in beside)
        return goal.model_copy(update={"exact": False}) if open_ else goal
    if not (inner := children(goal)):
        return goal
    told = [tuple(_put(part)) if not isinstance(goal, g.Any) else () for part in inner]
    others = [tuple(put for k, puts in enumerate(told) if k != n for put in puts) for n in range(len(inner))]
    return rebuild(goal, tuple(_open_tops(part, (*beside, *more)) for part, more in zip(inner, others, strict=True)))


def _put(goal: g.Goal) -> Iterable[Put]:
    """What goes on what, where it is not denied."""
    if isinstance(goal, r.On | r.Above):
        yield frozenset(members(goal.a)), frozenset(members(goal.b))
    elif not isinstance(goal, g.Not):
        for part in children(goal):
            yield from _put(part)
