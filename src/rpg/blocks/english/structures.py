"""Clauses for what blocks form together: stacks, towers, rows, figures, groups, words and equations."""

from __future__ import annotations

from collections import Counter
from typing import Any

from rpg.blocks.english.measures import cm
from rpg.blocks.english.orders import ATTRIBUTES, along, from_to, ordered, patterned, said_in_turn
from rpg.blocks.english.own_parts import by_parts
from rpg.blocks.english.speaker import Speaker
from rpg.blocks.nouns import join, number
from rpg.ir import structures as s
from rpg.ir.node import SLOPES

WAY = {"left": "to the left", "right": "to the right", "front": "to the front", "back": "to the back"}
SIDE_BY_SIDE = 1.0
"""The widest gaps of what stands side by side, in edges."""
AS_FAR_AS_YOU_LIKE = 10.0
"""The widest gaps of a line that may be of any length, in edges."""
POINTER = {"L": "foot", "U": "opening", "T": "stem"}
"""The part of a figure that its direction is the direction of; the tip of a triangle or a V."""


_LINES: dict[str | None, str] = {
    "x": "in a column on the table", "y": "in a row", None: "in a line",
    **dict.fromkeys(SLOPES, "in a diagonal line"),
}  # fmt: skip
_SLOPES: dict[tuple[str | None, str | None], str] = {
    ("rising", None): "near left to the far right", ("falling", None): "far left to the near right",
    ("rising", "left"): "near left to the far right", ("falling", "left"): "far left to the near right",
    ("rising", "right"): "far right to the near left", ("falling", "right"): "near right to the far left",
}  # fmt: skip
"""A diagonal from where its order begins, or from its left end."""


def _form(node: Any, say: Speaker, what: str) -> str:
    return f"{say.the(node.blocks)} {say.do(node.blocks, 'form', 'forms')} {what}"


def stack(node: s.Stack, say: Speaker) -> str:
    place = f" on {say.the(node.patch)}" if node.patch else ""
    order = ordered(_upward(node), say)
    if node.readable and node.order.by == "given" and node.order.first:
        order = f", reading {said_in_turn(node.order, say)}{from_to(node.order.first)}"
    if node.exact:
        return _form(node, say, f"a tower of exactly {number(len(node.blocks))}{place}{order}")
    if say.negated:
        # "Not stacked" would be said of every two of them.
        return _form(node, say, f"a tower{place}{order}")
    return f"{say.ordered(node.blocks, node.order.ranks)} {say.be(node.blocks)} stacked{place}{order}"


def _upward(node: s.Stack) -> Any:
    """The order of a stack, with its direction said."""
    if node.order.by == "rainbow" and node.order.first is None:
        return node.order.model_copy(update={"descending": False})
    if node.order.by in ("any", "alternating", "mirrored", "together") or node.order.first:
        return node.order
    return node.order.model_copy(update={"first": "bottom"})


def towers(node: s.Towers, say: Speaker) -> str:
    what = f"{number(node.count)} towers" if node.count else "towers"
    if node.heights:
        heights = node.heights[:1] if len(set(node.heights)) == 1 else node.heights
        what = f"{number(len(node.heights))} towers of {join([number(height) for height in heights])}"
    what += " of equal height" if node.equal else ""
    if node.each:
        own = "a different" if node.separate else "a single"
        what += f", each of {own} {ATTRIBUTES[node.each]}"
    what += ", each on a patch of its color" if node.matching else ""
    lots = Counter(say.world.blocks[name].color for name in node.blocks)
    if not node.each and len(lots) == (node.count or len(node.heights or ())) > 1 and min(lots.values()) > 1:
        what += ", in any order"  # else it could be one for each colour
    return _form(node, say, what)


def row(node: s.Row, say: Speaker) -> str:
    if (halfway := _halfway(node, say)) is not None:
        return halfway
    near = "side by side " if node.gap_edges == SIDE_BY_SIDE else ""
    kind, order = _LINES[node.axis], along(node.order, say)
    if way := _SLOPES.get((node.axis, node.order.first)):
        kind, order = f"{kind} from the {way}", ordered(node.order.model_copy(update={"first": None}), say)
    space = " without gaps" if node.touching else ""
    space += f" with {cm(node.spacing)} between centers" if node.spacing is not None else ""
    space += f" with gaps of {_gap(node.gap, node.tolerance)}" if node.gap is not None else ""
    space += ", evenly spaced" if node.evenly else ""
    if node.readable and node.order.by == "given" and node.order.first:
        read = say.do(node.blocks, "read", "reads")
        return f"{say.the(node.blocks)} {read} {said_in_turn(node.order, say)}{from_to(node.order.first)}{space}"
    blocks = say.ordered(node.blocks, node.order.ranks)
    return f"{blocks} {say.be(node.blocks)} {near}{kind}{order}{space}"


def _gap(gap: float, tolerance: float) -> str:
    """A gap; one that may be nothing as the most that it may be."""
    return f"at most {cm(gap + tolerance)}" if tolerance >= gap else cm(gap)


def _halfway(node: s.Row, say: Speaker) -> str | None:
    """Three in a line, however far apart: the middle one is halfway between the others."""
    order = node.order
    loose = node.evenly and node.gap_edges == AS_FAR_AS_YOU_LIKE and node.axis is None and order.first is None
    if not loose or order.by != "given" or [len(rank) for rank in order.ranks] != [1, 1, 1]:
        return None
    a, b, c = order.ranks
    return f"{say.the(b)} {say.be(b)} halfway between {say.the(a)} and {say.the(c)}"


def grid(node: s.Grid, say: Speaker) -> str:
    if node.rows == 1 and node.layers > 1:
        what = f"a wall {number(node.columns)} blocks wide and {number(node.layers)} blocks high"
    elif node.layers > 1:
        what = f"a {node.rows}x{node.columns}x{node.layers} cube"
    else:
        what = f"a grid of {number(node.rows)} rows and {number(node.columns)} columns"
    return _cells(node, say, what, patterned(node.pattern, say, upright=node.layers > 1, in_rows=True))


def _cells(node: s.Cells, say: Speaker, what: str, pattern: str) -> str:
    """A figure with its gaps, where these are not as usual."""
    if node.gap is not None:
        what += f" with gaps of {_gap(node.gap, node.tolerance)}" if node.gap else " without gaps"
    return _form(node, say, what + pattern)


def pyramid(node: s.Pyramid, say: Speaker) -> str:
    long, deep = node.base
    base = f"{long}x{deep} base" if deep > 1 else f"base of {number(long)} blocks"
    other = any(blocks != frozenset(node.blocks) for blocks in say.figures)
    say.figures[frozenset(node.blocks)] = "" if other else "the pyramid"
    return _cells(node, say, f"a pyramid with a {base}", patterned(node.pattern, say, upright=True))


def staircase(node: s.Staircase, say: Speaker) -> str:
    way = f" going up {WAY[node.up]}" if node.up else ""
    what = f"a staircase of {number(node.steps)} steps{way}"
    return _cells(node, say, what, by_parts(node, say) or patterned(node.pattern, say, upright=True))


def figure(node: s.Figure, say: Speaker) -> str:
    name = {"plus": "plus sign"}.get(node.shape, node.shape)
    sides = f"{node.sides[0]}x{node.sides[1]} " if node.sides and node.shape in ("square", "rectangle") else ""
    if node.shape in ("square", "rectangle", "triangle", "circle"):
        what = f"a filled {sides}{name}" if node.filled else f"a hollow {sides}{name}"
        what = f"the outline of a {name}" if not node.filled and not sides else what
        what = f"a {name}" if node.shape == "circle" and not node.filled else what
    else:
        what = f"{'an' if name in 'LX' else 'a'} {name}" + (" shape" if len(name) == 1 else "")
    if node.shape == "plus" and node.sides is not None and node.sides[0] == node.sides[1]:
        arm = node.sides[0] // 2
        what += f" with each arm of {number(arm)} block{'s' * (arm > 1)}"
    way = f" with its {POINTER.get(node.shape, 'tip')} {WAY[node.pointing]}" if node.pointing else ""
    return _cells(node, say, what + way, by_parts(node, say) or patterned(node.pattern, say))


def group_by(node: s.GroupBy, say: Speaker) -> str:
    blocks = tuple(name for group in node.groups for name in group)
    odd = f" with {number(node.outliers)} outlier{'s' * (node.outliers > 1)} in each group" if node.outliers else ""
    if node.by:
        count = number(len(node.groups))
        return f"{say.the(blocks)} {say.be(blocks)} sorted by {ATTRIBUTES[node.by]} into {count} groups{odd}"
    if len(node.groups) == 1 and node.inner_edges == s.TOUCHING_EDGES and not odd:
        return f"{say.the(blocks)} {say.do(blocks, 'touch', 'touches')} each other"
    groups = [f"{say.the(group)} {say.be(group)} in {_which(i)} group" for i, group in enumerate(node.groups)]
    return f"{join(groups)}{odd}"


def _which(index: int) -> str:
    return "one" if index == 0 else "another"


def spells(node: s.Spells, say: Speaker) -> str:
    way = " from top to bottom in a tower" if node.along == "stack" else ""
    way = {"row": " backwards", "stack": " from bottom to top in a tower"}[node.along] if node.reverse else way
    what, verb = "word", say.do(node.blocks, "spell", "spells")
    if node.word.isdigit():
        what, verb = "number", say.do(node.blocks, "form", "forms")
    some = "some of " if len(node.blocks) > len(node.word) else ""
    return f"{some}{say.the(node.blocks)} {verb} the {what} {node.word}{way}"


def equation(node: s.Equation, say: Speaker) -> str:
    what = f"the equation {node.text}" if node.text else "a true equation"
    return _form(node, say, what + (" from top to bottom in a tower" if node.along == "stack" else ""))


TABLE: dict[str, Any] = {
    "stack": stack,
    "towers": towers,
    "row": row,
    "grid": grid,
    "pyramid": pyramid,
    "staircase": staircase,
    "figure": figure,
    "group_by": group_by,
    "spells": spells,
    "equation": equation,
}
