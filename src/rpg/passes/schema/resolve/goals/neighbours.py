"""Blocks of a row that must not be next to each other, and those of a tower that must be, or must not be."""

from __future__ import annotations

from itertools import chain, combinations, pairwise
from math import comb

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import members
from rpg.ir.order import Order
from rpg.ir.walk import transform
from rpg.passes.schema.resolve.orders.positions import looks
from rpg.passes.schema.resolve.things.world import Scene, refuse

FEW = 2
"""So many orders at most stand side by side in a goal; of more the goal says what is between whom."""


def in_lines(goal: g.Goal, scene: Scene) -> g.Goal:
    """ "A row in which red is not next to blue": another of its blocks is between them, however wide its gaps are.
    "No two red ones are neighbours": as an order of the row where few are possible."""

    def change(node: g.Goal) -> g.Goal:
        if not isinstance(node, g.All):
            return node
        goals = list(node.goals)
        for row in (x for x in goals if isinstance(x, s.Row) and x.spacing is None and x.gap is None):
            denied = {x: {*members(x.goal.a), *members(x.goal.b)} for x in goals if _not_beside(x)}  # type: ignore[union-attr]
            inside = {x: pair for x, pair in denied.items() if len(pair) == 2 and pair <= {*row.blocks}}
            if not inside:
                continue
            _possible(row, inside)
            if ordered := _ordered(row, [*inside.values()], scene):
                goals[goals.index(row)] = ordered
                goals = [x for x in goals if x not in inside]
                continue
            for x, pair in inside.items():
                one, two = sorted(pair, key=row.blocks.index)
                others = [n for n in row.blocks if n not in (one, two)]
                between = tuple(r.Between(a=(n,), b=(one,), c=(two,), span=x.span) for n in others)
                goals[goals.index(x)] = g.Any(goals=between, span=x.span) if len(between) > 1 else between[0]
        return node if tuple(goals) == node.goals else node.model_copy(update={"goals": tuple(goals)})

    return transform(goal, change)


def in_stacks(goal: g.Goal, scene: Scene) -> g.Goal:
    """ "A tower of A, B and C in which A is next to B": one lies on the other, as none are side by side there."""

    def change(node: g.Goal) -> g.Goal:
        parts = node.goals if isinstance(node, g.All) else ()
        stacks = [{*x.blocks} for x in parts if isinstance(x, s.Stack)]
        goals = tuple(_on_one_another(x, stacks) for x in parts)
        if goals == tuple(parts):
            return node
        scene.assume("blocks of a tower are next to each other where one lies on the other")
        return node.model_copy(update={"goals": goals})

    return transform(goal, change)


def _on_one_another(goal: g.Goal, stacks: list[set[str]]) -> g.Goal:
    if isinstance(goal, g.Not | g.All | g.Any):
        inner = goal.goal if isinstance(goal, g.Not) else goal.goals
        found = tuple(_on_one_another(x, stacks) for x in (inner if isinstance(inner, tuple) else (inner,)))
        return goal.model_copy(update={"goal": found[0]} if isinstance(goal, g.Not) else {"goals": found})
    if not isinstance(goal, r.Beside | r.Adjacent):
        return goal
    two = {*members(goal.a), *members(goal.b)}
    inside = len(two) > 1 and any(two <= stack for stack in stacks)
    return r.Touching(a=goal.a, b=goal.b, span=goal.span) if inside else goal


def _not_beside(goal: g.Goal) -> bool:
    return isinstance(goal, g.Not) and isinstance(goal.goal, r.Beside)


def _possible(row: s.Row, inside: dict[g.Goal, set[str]]) -> None:
    """Raises a contradiction where too many, or neighbours of the order that was told, are kept apart."""
    span = next(iter(inside)).span
    help_ = "say how wide the gaps are, as in 'with gaps of 5 cm'"
    count = len(row.blocks)
    if _each_other([*inside.values()]) and len({*chain(*inside.values())}) > (most := (count + 1) // 2):
        raise refuse("contradiction", f"of {count} blocks in a line {most} at most are no neighbours", span, help_)
    told = row.order.ranks if row.order.by == "given" else ()
    beside = [{*a, *b} for a, b in pairwise(told) if len(a) == len(b) == 1]
    if any(pair in beside for pair in inside.values()):
        raise refuse("contradiction", "neighbours in a line are next to each other", span, help_)


def _each_other(pairs: list[set[str]]) -> bool:
    """Are the pairs all that there are of their members?"""
    return len({*map(frozenset, pairs)}) == comb(len({*chain(*pairs)}), 2)


def _ordered(row: s.Row, pairs: list[set[str]], scene: Scene) -> g.Goal | None:
    """The row in one of its few possible orders, where all pairs of one look are kept apart and the rest look alike."""
    apart = {*chain(*pairs)}
    rest = [n for n in row.blocks if n not in apart]
    one, other = ({looks(scene.things[name]) for name in names} for names in (apart, rest))
    if row.order.by != "any" or not _each_other(pairs) or len(one) != 1 or len(other) != 1 or one == other:
        return None
    last = len(row.blocks) - 1
    places = [
        at
        for at in combinations(range(len(row.blocks)), len(apart))
        if all(b - a > 1 for a, b in pairwise(at)) and at <= tuple(last - i for i in reversed(at))
    ]
    if len(places) > FEW:
        return None
    orders = tuple(row.model_copy(update={"order": _given(row, apart, at)}) for at in places)
    return g.Any(goals=orders, span=row.span) if len(orders) > 1 else orders[0]


def _given(row: s.Row, apart: set[str], places: tuple[int, ...]) -> Order:
    these, others = iter([n for n in row.blocks if n in apart]), iter([n for n in row.blocks if n not in apart])
    ranks = tuple((next(these if i in places else others),) for i in range(len(row.blocks)))
    return Order(by="given", ranks=ranks)
