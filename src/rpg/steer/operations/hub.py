"""A block in the middle of an outline."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.blocks.figures import ideals
from rpg.blocks.predicates.pattern import reading_order
from rpg.core.diagnostics import Span
from rpg.ir.edits import ChangeCondition
from rpg.ir.order import Order, Pattern
from rpg.ir.structures import Figure, Grid
from rpg.steer.draft import Draft
from rpg.steer.view import Shape


def into_the_middle(draft: Draft, names: Sequence[str], figure: Shape, span: Span) -> bool:
    """Whether the figure is an outline that has a single middle; the new block is put there."""
    node, look = figure.node, draft.view.world.look
    ring = isinstance(node, Figure) and node.shape == "circle"
    square = isinstance(node, Figure) and node.shape == "square" and len(figure.members) == 8
    if not isinstance(node, Figure) or node.filled or node.pattern is not None or len(names) != 1:
        return False
    looks = {look[name] for name in figure.members}
    if not (ring or square) or len(looks) > 1 or look[names[0]] in looks:
        return False
    every = (*figure.members, *names)
    full = node.model_copy(update={"blocks": every, "filled": True})
    form: Figure | Grid = full if ring else Grid(blocks=every, rows=3, columns=3)
    found = ideals(form, len(every))
    cells = [found[0].cells[k] for k in reading_order(found[0].cells, False)] if found else []
    at = next((k for k, cell in enumerate(cells) if abs(cell.x) + abs(cell.y) < 0.01), None)
    if at is None:
        return False
    ranks = (figure.members[:at], tuple(names), figure.members[at:])
    pattern = Pattern(kind="reading", order=Order(by="given", ranks=ranks))
    draft.aim("EXTEND")
    draft.do(ChangeCondition(at=figure.path, to=form.model_copy(update={"pattern": pattern})), span)
    return True
