"""Words of which a letter is told apart from others that show the same: "spell ANNA with the second A upside down"."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.ir.walk import transform
from rpg.passes.schema.resolve.things.world import Scene, refuse


def letters_in_place(goal: g.Goal, scene: Scene) -> g.Goal:
    """The goal with each cube of such a word in its own place."""
    for names, span in scene.one_by_one.items():
        placed = _placed(goal, names)
        if placed == goal or any({*names} & {*getattr(begun, "blocks", ())} for begun in scene.start_goals):
            raise told_alike(span)
        goal = placed
    return goal


def told_alike(span: Span) -> Exception:
    """Why one of several such letters is not told apart."""
    return refuse("ambiguous", "this stands several times in the word, and any of them may stand at each place", span,
                  "speak of a letter that stands there once")  # fmt: skip


def _placed(goal: g.Goal, names: tuple[str, ...]) -> g.Goal:
    def change(node: g.Goal) -> g.Goal:
        if not isinstance(node, s.Spells) or node.blocks != names or node.reverse:
            return node
        upright = node.along == "stack"
        ranks = tuple((name,) for name in names)
        order = Order(by="given", ranks=ranks, first="top" if upright else "left", match="name")
        line: g.Goal = s.Row(blocks=names, axis="y", order=order, span=node.span)
        if upright:
            line = s.Stack(blocks=names, order=order, span=node.span)
        return g.All(goals=(node, line), span=node.span)

    return transform(goal, change)
