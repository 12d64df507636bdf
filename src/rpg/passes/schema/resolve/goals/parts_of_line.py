"""A line of which a part is ordered by itself: "2, 4, 6 and 9 in a row: the even ones ascending, then the odd one"."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.walk import transform
from rpg.passes.schema.resolve.things.world import Scene, refuse


def in_one_line(goal: g.Goal, scene: Scene) -> g.Goal:
    """Such a part is no line of its own, which would have nothing next to it: the whole has its order."""

    def change(node: g.Goal) -> g.Goal:
        if not isinstance(node, g.All):
            return node
        goals = list(node.goals)
        _check_then(goals)
        for part in [x for x in goals if isinstance(x, s.Row) and x.order.by in ("number", "label")]:
            for whole in [x for x in goals if isinstance(x, s.Row) and x is not part and x.order.by == "given"]:
                if part in goals and (told := _ordered(whole, part, scene)) is not None:
                    goals[goals.index(whole)] = told
                    goals.remove(part)
        if len(goals) == len(node.goals):
            return node
        return goals[0] if len(goals) == 1 else node.model_copy(update={"goals": tuple(goals)})

    return transform(goal, change)


def _check_then(goals: list[g.Goal]) -> None:
    """Refuse "a line of A, E, B and C: the vowels from the left, then the consonants" as one done after the other."""
    lines = [{*x.blocks} for x in goals if isinstance(x, s.Row)]
    for told in (x for x in goals if isinstance(x, g.Sequence)):
        parts = [stage.goal for stage in told.stages if isinstance(stage.goal, s.Row)]
        inside = [part for part in parts if any({*part.blocks} < line for line in lines)]
        if len(inside) > 1:
            raise refuse("ambiguous", "after it in time, or next to it in the line?", inside[-1].span,
                         "name all blocks of the line in their order")  # fmt: skip


def _ordered(whole: s.Row, part: s.Row, scene: Scene) -> s.Row | None:
    """The whole with its part in order, if that is one of its ranks and begins on the same side."""
    rank = next((rank for rank in whole.order.ranks if {*rank} == {*part.blocks}), None)
    labels = {name: scene.things[name].label or "" for name in whole.blocks}
    same = part.order.first == whole.order.first and part.axis == whole.axis
    if rank is None or not same or len({labels[name] for name in rank}) < len(rank):
        return None
    sequence = sorted(rank, key=lambda name: labels[name], reverse=part.order.descending)
    ranks = tuple(x for old in whole.order.ranks for x in (((name,) for name in sequence) if old == rank else (old,)))
    readable = whole.readable or (part.readable and all(labels.values()))
    return whole.model_copy(update={"order": whole.order.model_copy(update={"ranks": ranks}), "readable": readable})
