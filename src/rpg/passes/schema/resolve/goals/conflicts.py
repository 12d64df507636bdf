"""Goals that cannot hold together: for sequences (a later stage undoes an earlier one) and for contradictions."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise, product

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import members
from rpg.ir.walk import atoms, instances


def undoes(later: g.Goal, earlier: g.Goal) -> bool:
    """Whether `later` cannot hold while `earlier` does (as far as can be told from names alone)."""
    for a in required(earlier):
        for b in required(later):
            if clash(a, b):
                return True
    return False


def required(goal: g.Goal) -> Iterator[g.Goal]:
    """Atoms and negated atoms that must hold for `goal` to hold."""
    match goal:
        case g.All():
            for child in goal.goals:
                yield from required(child)
        case g.Sequence():
            for stage in goal.stages:
                if not stage.undone:
                    yield from required(stage.goal)
        case g.Always():
            yield from required(goal.goal)
        case g.Any() | g.Count():
            return
        case _:
            yield goal


def impossible(goal: g.Goal, parts: list[g.Goal]) -> bool:
    """Whether too few of the alternatives of a conjunction can hold beside what must, or too many do: "all six on the
    left, three of them on the right", "on its side" and "upright"."""
    few, most = 1, None
    children: tuple[g.Goal, ...]
    match goal:
        case g.All():
            return any(impossible(child, parts) for child in goal.goals)
        case g.Any():
            children = goal.goals
        case g.Count():
            few, most, children = goal.at_least, goal.at_most, instances(goal)
        case g.Not(goal=g.Count(at_most=None) as count):  # "no more than one"
            few, most, children = 0, count.at_least - 1, instances(count)
        case _:
            return False
    left = sum(not any(clash(x, part) for x in required(child) for part in parts) for child in children)
    forced = sum(any(_same(child, part) or _covers(part, child) for part in parts) for child in children)
    return left < few or (most is not None and forced > most)


OPPOSITE = {"left_of": "right_of", "right_of": "left_of", "in_front_of": "behind", "behind": "in_front_of"}


_TOGETHER = r.Touching | r.Adjacent | r.Near
"""Of two blocks that are not apart."""


def clash(a: g.Goal, b: g.Goal) -> bool:
    """Whether two atoms contradict each other by their names alone."""
    if isinstance(a, g.Not) or isinstance(b, g.Not):
        inner, other = (a.goal, b) if isinstance(a, g.Not) else (b.goal, a)  # type: ignore[union-attr]
        return _rests(other, inner) or _same(inner, other) or _covers(other, inner) or _stacked(other, inner)
    match a, b:
        case (r.On(), r.On()):
            return (a.a == b.a and a.b != b.b) or (a.b == b.a and a.a == b.b) or (a.b == b.b and a.a != b.a)
        case (r.On(), r.OnTable()) if isinstance(a.a, tuple) and isinstance(b.a, tuple):
            return bool(set(a.a) & set(b.a))
        case (r.OnTable(), r.On()):
            return clash(b, a)
        case (r.OnPatch(), r.OnPatch()) if isinstance(a.a, tuple) and isinstance(b.a, tuple):
            return a.patch != b.patch and bool(set(a.a) & set(b.a))
        case (r.Facing(), r.Facing()) if a.block == b.block and a.toward == b.toward:
            return None not in (a.turn, b.turn) and a.turn != b.turn
        case (r.Facing(), r.Facing()):
            return (a.block, a.label, a.face) == (b.block, b.label, b.face)
        case (r.OnPatch(), r.Empty()):
            return a.patch == b.patch
        case (r.Empty(), r.OnPatch()):
            return a.patch == b.patch
        case (r.OnPatch(), r.Directional() | r.Beside()) | (r.Directional() | r.Beside(), r.OnPatch()):
            there, beside = (a, b) if isinstance(a, r.OnPatch) else (b, a)
            return isinstance(beside, r.Directional | r.Beside) and isinstance(there, r.OnPatch) and _of(beside, there)
        case (r.On(), r.Clear()):
            return bool(members(a.b)) and {*members(a.b)} <= {*members(b.a)}
        case (s.Stack(), r.Clear()) if isinstance(b.a, tuple):  # all but its top carry another
            return len({*a.blocks} & {*b.a}) > 1
        case (r.Clear(), r.On() | s.Stack()):
            return clash(b, a)
        case (r.Stayed(), r.Moved()):
            return a.a == b.a
        case (r.Moved(), r.Stayed()):
            return a.a == b.a
        case (r.InRegion(), r.InRegion()):
            return bool({*members(a.a)} & {*members(b.a)}) and _apart(a.region.split("_"), b.region.split("_"))
    if isinstance(a, r.Stayed | r.Shifted) and isinstance(b, r.Stayed | r.Shifted):
        return _other_way(a, b) and bool({*members(a.a)} & {*members(b.a)})
    if isinstance(a, _TOGETHER | r.Apart) and isinstance(b, _TOGETHER | r.Apart):
        two = {*members(a.a), *members(a.b)} == {*members(b.a), *members(b.b)}
        return two and isinstance(a, r.Apart) != isinstance(b, r.Apart)
    if isinstance(a, r.Distance) and isinstance(b, r.Distance) and a.measure == b.measure:
        two = {*members(a.a), *members(a.b)} == {*members(b.a), *members(b.b)}
        return two and (_farther(a, b) or _farther(b, a))
    if isinstance(a, r.Approached | r.Receded) and isinstance(b, r.Approached | r.Receded) and a.kind != b.kind:
        return {*members(a.a), *members(a.b)} == {*members(b.a), *members(b.b)}
    if isinstance(a, s.Stack | s.Row) and isinstance(b, s.Stack | s.Row) and a.kind == b.kind:
        return _orders_differ(a, b) or _more_on_it(a, b) or _more_on_it(b, a)
    if isinstance(a, s.Spells) and isinstance(b, s.Spells):
        return set(a.blocks) == set(b.blocks) and a.word != b.word
    if any(
        way(one, two) for way in (_along_and_across, _on_and_beside, _lies_elsewhere) for one, two in ((a, b), (b, a))
    ):
        return True
    if isinstance(a, s.Equation) and isinstance(b, s.Equation):
        return set(a.blocks) == set(b.blocks) and None not in (a.text, b.text) and a.text != b.text
    if _flat_and_upright(a, b) or _flat_and_upright(b, a) or _of_other_shape(a, b) or _of_other_shape(b, a):
        return True
    return _opposite(a, b) if isinstance(a, r.Directional) and isinstance(b, r.Directional) else False


def _rests(on: g.Goal, inner: g.Goal) -> bool:
    """Whether what rests on a block is so above it, or touches it."""
    if not isinstance(on, r.On) or not isinstance(inner, r.Above | r.Touching):
        return False
    pair = {*members(inner.a), *members(inner.b)} == {*members(on.a), *members(on.b)}
    return pair if isinstance(inner, r.Touching) else (inner.a, inner.b) == (on.a, on.b)


def _apart(one: list[str], other: list[str]) -> bool:
    """Whether no block is in both of two parts of the table."""
    opposite = any({*pair} in ({"left", "right"}, {"near", "far"}) for pair in product(one, other))
    return opposite or ("middle" in (*one, *other) and not {"corner", "edge"}.isdisjoint((*one, *other)))


def _other_way(a: r.Stayed | r.Shifted, b: r.Stayed | r.Shifted) -> bool:
    """Whether a block cannot have gone both ways, or stays where it is."""
    if isinstance(a, r.Stayed) or isinstance(b, r.Stayed):
        return a.kind != b.kind
    return {a.toward, b.toward} in ({"left", "right"}, {"front", "back"})


def _farther(one: r.Distance, other: r.Distance) -> bool:
    return one.minimum is not None and other.maximum is not None and one.minimum > other.maximum


def _along_and_across(read: g.Goal, line: g.Goal) -> bool:
    """A word or an equation, which is read from left to right, against a column of two of its blocks, or one of them
    in front of another: "spell ON with the N in front of the O"."""
    if not isinstance(read, s.Spells | s.Equation) or read.along != "row":
        return False
    if isinstance(line, r.InFrontOf | r.Behind) and isinstance(line.a, tuple) and isinstance(line.b, tuple):
        front, back = {*read.blocks} & {*line.a}, {*read.blocks} & {*line.b}
        return bool(front and back) and not front & back  # a whole in front of its own part is refused elsewhere
    return isinstance(line, s.Row) and line.axis == "x" and len({*read.blocks} & {*line.blocks}) > 1


def _on_and_beside(on: g.Goal, beside: g.Goal) -> bool:
    """A block on another one, against the two side by side: "a blue block on top of the red one and next to it"."""
    if not isinstance(on, r.On) or not isinstance(beside, r.Beside | r.Adjacent):
        return False
    one = len(members(on.a)) == len(members(on.b)) == 1
    return one and {*members(on.a), *members(on.b)} == {*members(beside.a), *members(beside.b)}


def _lies_elsewhere(stack: g.Goal, other: g.Goal) -> bool:
    """A stack told block by block, against one of its blocks on the table or on another block than the one below it,
    or another block on one that has the next of them on it."""
    if not isinstance(stack, s.Stack) or stack.order.by != "given" or not isinstance(other, r.On | r.OnTable):
        return False
    ranks = stack.order.ranks if stack.order.first != "top" else stack.order.ranks[::-1]
    upper, lower = {n for rank in ranks[1:] for n in rank}, {n for rank in ranks[:-1] for n in rank}
    if isinstance(other, r.OnTable):
        return isinstance(other.a, tuple) and not upper.isdisjoint(other.a)
    next_to = {(a, b) for under, over in pairwise(ranks) for a in over for b in under}
    within = {(a, b) for rank in ranks if len(rank) > 1 for a in rank for b in rank}
    pairs = {*product(members(other.a), members(other.b))} - next_to - within
    return any(a in upper or b in lower for a, b in pairs)


def _of(beside: r.Directional | r.Beside, there: r.OnPatch) -> bool:
    """Whether a block beside a patch would have to be on it."""
    return beside.b == (there.patch,) and bool(set(members(beside.a)) & set(members(there.a)))


def _opposite(a: r.Directional, b: r.Directional) -> bool:
    one, two = getattr(a, "kind", ""), getattr(b, "kind", "")
    if one == two:
        return a.a == b.b and a.b == b.a
    return OPPOSITE.get(one) == two and a.a == b.a and a.b == b.b


_FLAT = s.Row | s.Figure
_RIGHT_ANGLED = {"square", "rectangle"}
"""Figures that one line of blocks may form both at once."""


def _of_other_shape(spread: g.Goal, line: g.Goal) -> bool:
    """A figure of several rows or layers, or several towers, against a line or a tower of the same blocks."""
    if isinstance(spread, s.Grid) and isinstance(line, s.Grid) and set(spread.blocks) == set(line.blocks):
        return (spread.rows, spread.columns, spread.layers) != (line.rows, line.columns, line.layers)
    if isinstance(spread, s.Towers) and isinstance(line, s.Stack):
        return (spread.count or 1) > 1 and set(spread.blocks) == set(line.blocks)
    if isinstance(spread, _FLAT) and isinstance(line, s.Towers | s.Pyramid | s.Staircase):
        figure = isinstance(spread, s.Figure) and (spread.shape == "triangle" or isinstance(line, s.Staircase))
        return not figure and set(spread.blocks) == set(line.blocks)
    if isinstance(spread, s.Figure) and isinstance(line, s.Figure | s.Row) and len(line.blocks) > 2:
        other = isinstance(line, s.Row) or (spread.shape != line.shape and {spread.shape, line.shape} != _RIGHT_ANGLED)
        return other and set(spread.blocks) == set(line.blocks)
    if not isinstance(spread, s.Grid | s.Pyramid | s.Staircase) or not isinstance(line, s.Row | s.Stack):
        return False
    sides = (spread.rows, spread.columns, spread.layers) if isinstance(spread, s.Grid) else (2, 2)
    return sum(side > 1 for side in sides) > 1 and set(spread.blocks) == set(line.blocks)


def _stacked(stack: g.Goal, inner: g.Goal) -> bool:
    """Whether a stack that is told block by block has one block above another, or on the next."""
    if not isinstance(stack, s.Stack) or not isinstance(inner, r.On | r.Above) or stack.order.by != "given":
        return False
    ranks = stack.order.ranks if stack.order.first != "top" else stack.order.ranks[::-1]
    height = {name: n for n, rank in enumerate(ranks) for name in rank}
    steps = [height[a] - height[b] for a in members(inner.a) for b in members(inner.b) if {a, b} <= height.keys()]
    known = [step for step in steps if step > 0 and (isinstance(inner, r.Above) or step == 1)]
    single = all(len(rank) == 1 for rank in ranks)
    return bool(known) and (single or isinstance(inner, r.Above))


def _flat_and_upright(flat: g.Goal, upright: g.Goal) -> bool:
    """A line on the table against a stack of two of its blocks: "spell GO with the G on top of the O"."""
    if not isinstance(flat, s.Row | s.Figure | s.Spells | s.Equation | r.OnTable):
        return False
    if isinstance(flat, s.Spells | s.Equation) and flat.along == "stack":
        return False
    on_table = flat.a if isinstance(flat, r.OnTable) else flat.blocks
    line = set(on_table) if isinstance(on_table, tuple) else set()  # of a tower it is its lowest block, whichever it is
    if isinstance(upright, s.Stack):
        return len(line & set(upright.blocks)) > 1
    if isinstance(upright, s.Towers | s.Pyramid | s.Staircase) or (isinstance(upright, s.Grid) and upright.layers > 1):
        return isinstance(flat, r.OnTable) and {*upright.blocks} <= line
    if isinstance(upright, r.On | r.Above) and isinstance(upright.a, tuple) and isinstance(upright.b, tuple):
        return bool(line & set(upright.a)) and bool(line & set(upright.b))
    return False


def _orders_differ(a: s.Stack | s.Row, b: s.Stack | s.Row) -> bool:
    """Two orders of the same blocks, block by block, or a line that would have to run two ways."""
    if isinstance(a, s.Row) and isinstance(b, s.Row) and None not in (a.axis, b.axis) and a.axis != b.axis:
        return len({*a.blocks} & {*b.blocks}) > 1
    given = a.order.by == b.order.by == "given" and a.order.first == b.order.first
    single = all(len(rank) == 1 for rank in (*a.order.ranks, *b.order.ranks))
    return given and single and set(a.blocks) == set(b.blocks) and a.order.ranks != b.order.ranks


def _more_on_it(tower: g.Goal, other: g.Goal) -> bool:
    """A tower of just these blocks against one that has some of these, and others."""
    if not isinstance(tower, s.Stack) or not isinstance(other, s.Stack) or not tower.exact or tower.raised:
        return False
    return bool({*tower.blocks} & {*other.blocks}) and not {*other.blocks} <= {*tower.blocks}


def _covers(whole: g.Goal, part: g.Goal) -> bool:
    """Whether what holds of several blocks holds of these: "red and blue are on the mat" and "red is not"."""
    kinds = (r.OnPatch, r.InRegion, r.OnTable, r.Stayed)
    if not isinstance(whole, kinds) or not isinstance(part, kinds) or not isinstance(whole.a, tuple):
        return False
    fewer = isinstance(part.a, tuple) and set(part.a) < set(whole.a)
    return fewer and _same(whole.model_copy(update={"a": part.a}), part)


def _same(a: g.Goal, b: g.Goal) -> bool:
    return a.model_copy(update={"span": None}) == b.model_copy(update={"span": None})


__all__ = ["atoms", "clash", "required", "undoes"]
