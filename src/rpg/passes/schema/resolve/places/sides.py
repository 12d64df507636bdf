"""Loose places: sides of the structure built last, or sides that several clauses share among them."""

from __future__ import annotations

import itertools

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import members
from rpg.ir.order import Order, Side
from rpg.ir.walk import atoms, transform
from rpg.language.meaning import At, replace
from rpg.passes.schema.resolve.goals.logic import conj
from rpg.passes.schema.resolve.orders.agreeing import OPPOSITE
from rpg.passes.schema.resolve.orders.between_ends import by_symbols, of_a_range
from rpg.passes.schema.resolve.orders.in_grids import in_figure
from rpg.passes.schema.resolve.orders.loose import once_of_each_look
from rpg.passes.schema.resolve.orders.positions import SIDES, SYMMETRIC, alternatives, looks, places_of, ranks_from
from rpg.passes.schema.resolve.places.across_the_table import REGION, across_the_table
from rpg.passes.schema.resolve.places.either_end import at_an_end, each_at_its_end, one_of_them
from rpg.passes.schema.resolve.places.in_each_way import settled, ways_of
from rpg.passes.schema.resolve.places.in_words import check_word
from rpg.passes.schema.resolve.places.middles import of_a_line, of_a_word, related_to
from rpg.passes.schema.resolve.places.of_themselves import (
    Loose,
    check_between,
    deep,
    of_the_ends,
    of_themselves,
    with_the_one_between,
)
from rpg.passes.schema.resolve.places.rows_of_towers import of_towers
from rpg.passes.schema.resolve.places.utmost import BEYOND, beyond_others, not_beyond_others
from rpg.passes.schema.resolve.structures.structures import either, stack_built
from rpg.passes.schema.resolve.things.operands import UPRIGHT, foot
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse


def place_loose(goal: g.Goal, scene: Scene) -> g.Goal:
    """Refine the order of a structure in `goal`, or make goals of their own; then what is denied."""
    goal = _stated(goal, scene) if scene.loose else goal
    for item in once_of_each_look(scene, [frozenset(node.blocks) for node in _lines(goal)]):
        goal = _denied(goal, item, scene)
    return goal


def _denied(goal: g.Goal, item: Loose, scene: Scene) -> g.Goal:
    """ "the red one is not at the top": the structure, but with no such order."""
    ref, _, span = item
    nodes = [n for n in _lines(goal) if set(ref.names) <= set(n.blocks)]
    node = next((n for n in nodes if n.order.by == "any"), nodes[0] if nodes else None)
    if node is None:
        if not any(isinstance(a, s.Row) for a in atoms(goal)) and (among := not_beyond_others(item, scene)) is not None:
            return _and(goal, among)
        _of_what(item, goal, scene)
        return _and(goal, g.Not(goal=_region(item), span=span))
    kept = node.model_copy(update={"axis": node.axis or "y"}) if isinstance(node, s.Row) else node
    free = kept.model_copy(update={"order": Order()})
    kind = "stack" if isinstance(node, s.Stack) else "column" if node.axis == "x" else "row"
    at_ = item[1]
    items = [item]
    if isinstance(at_, At) and at_an_end(at_):
        each = itertools.product(ref.names, SIDES[kind][:2])
        items = [(Ref(names=(name,)), replace(at_, side=side), span) for name, side in each]
    nots = [g.Not(goal=_refine(free, free, [one], scene, denied=True), span=span) for one in items]
    if sum({*n.blocks} == {*node.blocks} for n in nodes) > 1:  # of each way to build the line
        return _and(goal, conj(nots, span))
    without = conj([kept, *nots], span)
    return transform(goal, lambda x: without if x == node else x)


def _stated(goal: g.Goal, scene: Scene) -> g.Goal:
    loose = scene.loose
    scene.loose = []
    names = [n for ref, _, _ in loose for n in ref.names]
    if any(ref.op != "and" for ref, _, _ in loose):
        return one_of_them(goal, loose, _lines(goal), lambda node, told: _refine(node, node, told, scene))
    told = any(isinstance(a, r.InRegion) for a in atoms(goal))
    told = told or any(ref.built and getattr(at_, "side", "") != "middle" for ref, at_, _ in loose)
    whole = max(len(ref.names) for ref, _, _ in loose) if told else 0
    for node in (n for n in _lines(goal) if set(names) <= set(n.blocks) and whole < len(n.blocks)):
        return _refine(goal, node, loose, scene)
    for node, feet in of_towers(_lines(goal), loose, scene):
        return _refine(goal, node, feet, scene)
    for figure in (a for a in atoms(goal) if isinstance(a, s.Grid | s.Figure) and set(names) < set(a.blocks)):
        return in_figure(goal, figure, loose, scene)
    for word in (a for a in atoms(goal) if isinstance(a, s.Spells) and set(names) < set(a.blocks)):
        check_word(word, loose, scene)
        return goal
    rows = any(isinstance(a, s.Row) for a in atoms(goal))
    if (placed := None if rows else beyond_others(loose, scene)) is not None:
        return _and(goal, placed)
    sides = [at_.side for _, at_, _ in loose if isinstance(at_, At)]
    if across_the_table(loose, goal):
        return _and(goal, conj([_region(item) for item in loose]))
    open_ = next((b for b in scene.built if any(_open(scene, name) for name in b.members)), None)
    if open_ is not None and not all(ref.built or {*ref.names} <= {*open_.members} for ref, _, _ in loose):
        raise refuse("ambiguous", f"these could be blocks of the {open_.kind} or further ones", loose[0][2],
                     "name the blocks in the sentence that builds it")  # fmt: skip
    if "next" in sides:
        return _and(goal, _one_after_another(loose, sides, scene))
    if len(loose) > 1 and any(isinstance(at_, At) and at_.whole == "row" for _, at_, _ in loose):
        return _and(goal, _in_row(loose, scene))
    if all(side in ("top", "bottom", "middle") for side in sides) and len(loose) > 1:
        other = next((b for b in scene.built if b.kind in UPRIGHT and not {*b.members} <= {*names}), None)
        if other is not None:
            raise refuse("ambiguous", f"these could be parts of the {other.kind} or a tower of their own", loose[0][2],
                         f"say it in the sentence that builds the {other.kind}")  # fmt: skip
        return _and(goal, _stack(loose, goal, scene))
    if len(loose) > 1 and all(side in ("left", "right", "middle", "front", "back") for side in sides):
        of_themselves(loose, goal, scene.start_goals)
        if any(b.kind in ("row", "line", "column") and {*names} < {*b.members} for b in scene.built):
            raise refuse("ambiguous", "of the row that is there, or of each other?", loose[0][2], "say 'of the row'")
        return _and(goal, _across(loose))
    if (related := _of_the_pair(loose, goal)) is not None:
        return _and(goal, related)
    for item in loose:
        _of_what(item, goal, scene)
    return _and(goal, conj([_region(item) for item in loose]))


def _of_the_pair(loose: list[Loose], goal: g.Goal) -> g.Goal | None:
    """ "Red and blue side by side, red on the left", "both on the mat, ...": of two blocks close to each other, it is
    left of the other."""
    (ref, at_, span), *more = loose
    node = BEYOND.get(at_.side) if isinstance(at_, At) and at_.index is None and not at_.whole else None
    close = r.Beside | r.Adjacent | r.Touching | r.Near | r.Distance | r.Swapped
    mats = [a for a in atoms(goal) if isinstance(a, r.OnPatch) and {*ref.names} < {*members(a.a)}]
    pairs = [a for a in atoms(goal) if isinstance(a, close) and _about(a, ref)] or mats
    if not pairs and not more and node is not None:
        return of_the_ends(ref, node, goal, span)
    told = {frozenset(_named(a)) for a in pairs}
    if more or node is None or len(ref.names) != 1 or len(told) != 1 or pairs[0] not in _at_the_end(goal):
        return None
    if isinstance(pairs[0], r.Distance) and pairs[0].maximum is None:
        return None
    pair = members(pairs[0].a) + (() if isinstance(pairs[0], r.OnPatch) else members(pairs[0].b))
    if len(pair) != 2 or ref.names[0] not in pair:
        return None
    other = pair[1 - pair.index(ref.names[0])]
    sides = (r.LeftOf, r.RightOf, r.InFrontOf, r.Behind, r.Between)
    spoken = {n for a in atoms(goal) if isinstance(a, sides) for n in _named(a)}
    return None if spoken & set(pair) else node(a=ref.names, b=(other,), span=span)


def _at_the_end(goal: g.Goal) -> list[g.Goal]:
    """What holds at the end, step by step."""
    match goal:
        case g.All():
            return [x for part in goal.goals for x in _at_the_end(part)]
        case g.Sequence():
            return [x for stage in goal.stages if not stage.undone for x in _at_the_end(stage.goal)]
    return [goal]


def _open(scene: Scene, name: str) -> bool:
    """Whether nothing was said of how a block looks."""
    thing = scene.things[name]
    return thing.color is None and thing.label is None


def _one_after_another(loose: list[Loose], sides: list[str], scene: Scene) -> g.Goal:
    """ "A leftmost, then B, C rightmost": from one side to the other, one block after another."""
    first, others, span = sides[0], sides[1:], (loose[0][2][0], loose[-1][2][1])
    last = OPPOSITE.get(first)
    follow = last is not None and set(others) <= {"next", last} and last not in others[:-1]
    if not follow or any(len(ref.names) != 1 for ref, _, _ in loose):
        raise refuse("ambiguous", "it is not clear in which order these are", span, "list them from side to side")
    blocks = tuple(ref.names[0] for ref, _, _ in loose)
    if len(set(blocks)) != len(blocks):
        raise refuse("contradiction", "one block is given two places", span, "name each block once")
    if first in ("top", "bottom"):
        ranks = tuple((name,) for name in blocks)
        tower = s.Stack(blocks=blocks, order=Order(by="given", ranks=ranks, first=first), span=span)  # type: ignore[arg-type]
        stack_built(tower, scene)
        return tower
    node = BEYOND[first]
    goals: list[g.Goal] = [node(a=(a,), b=(b,), span=span) for a, b in itertools.pairwise(blocks)]
    return conj(goals, span)


def _of_what(item: Loose, goal: g.Goal, scene: Scene) -> None:
    """Refuse a side or a middle that could be that of the table or of something spoken of before."""
    ref, at_, _ = item
    if not isinstance(at_, At):
        return
    if at_.whole:
        raise refuse("no-referent", f"it is not clear which {at_.whole} this is of", at_.span, "name the block there")
    for own in (a for a in atoms(goal) if isinstance(a, s.Equation | s.GroupBy) and set(ref.names) < _parts(a)):
        what = "equation" if isinstance(own, s.Equation) else "groups"
        raise refuse("ambiguous", f"this could be a side of the table or of the {what}", at_.span,
                     "say 'half of the table', or of what")  # fmt: skip
    for b in scene.built:
        if b.kind not in (*SIDES, "pile", "towers", "word", "equation") and set(ref.names) < set(b.members):
            raise refuse("ambiguous", f"this could be a side of the table or of the {b.kind}", at_.span, "say of what")
    others = [b for b in scene.built if not set(ref.names) & set(b.members)]
    if at_.side == "middle" and any(b.kind not in SIDES and len(b.members) > 2 for b in others):
        raise refuse("ambiguous", "this could be the middle of the table or of the figure", at_.span,
                     "say 'of the table'")  # fmt: skip
    of_a_line(ref, at_, scene)
    of_a_word(ref, at_, scene)
    line = next((b for b in scene.built if b.kind in SIDES and not {*b.members} <= {*ref.names}), None)
    by_it = line or next((b for b in others if b.kind == "word"), None)
    if by_it is not None and ref.built and at_.side != "middle":
        raise refuse("ambiguous", f"this could be a side of the table or of the {by_it.kind}", at_.span,
                     "say 'half of the table', or of what")  # fmt: skip
    if line is not None and line.kind != "stack" and at_.side in SIDES[line.kind]:
        raise refuse("ambiguous", f"this could be a side of the table or an end of the {line.kind}", at_.span,
                     f"say 'of the table', or name the block among those of the {line.kind}")  # fmt: skip
    beside = r.LeftOf | r.RightOf | r.InFrontOf | r.Behind
    related = related_to(ref, goal, scene)
    if at_.side != "middle" and related:
        raise refuse("ambiguous", "this could be a side of the table or of a block", at_.span,
                     "say 'half of the table', or of what")  # fmt: skip
    if any(isinstance(a, s.Row) and not set(ref.names) & set(a.blocks) for a in atoms(goal)):
        raise refuse("ambiguous", "this could be a place on the table or in the line", at_.span,
                     "say 'of the table', or name the block among those of the line")  # fmt: skip
    sided = [a for a in atoms(goal) if isinstance(a, beside)]
    pairs = [{*members(a.a), *members(a.b)} for a in sided]  # of these it is only told how far the one is on its side
    close = r.Beside | r.Adjacent | r.Touching | r.Distance
    near = [a for a in atoms(goal) if isinstance(a, close) and {*members(a.a), *members(a.b)} not in pairs]
    its = _said_first(item, sided)
    among = at_.side == "middle" and not its and any(isinstance(a, beside | r.Near | r.Apart) for a in atoms(goal))
    if any(at_.side == "middle" or set(ref.names) & {*members(a.a), *members(a.b)} for a in near) or among:
        raise refuse("ambiguous", "this could be a side of the table or of the other block", at_.span,
                     "say 'of the table', or of what")  # fmt: skip
    patched = [a for a in atoms(goal) if isinstance(a, r.OnPatch)]
    if any(_about(a, ref) or (at_.side == "middle" and a.span and a.span[0] < at_.span[0]) for a in patched):
        raise refuse("ambiguous", "this could be a side of the table or of the patch", at_.span, "say of what")
    ends = ("edge", *(("corner",) if at_.side != "middle" else ()))
    if any(isinstance(a, r.InRegion) and any(end in a.region for end in ends) for a in atoms(goal)):
        raise refuse("ambiguous", "this could be a half or an edge of the table", at_.span, "say which")


def _said_first(item: Loose, beside: list[r.LeftOf | r.RightOf | r.InFrontOf | r.Behind]) -> bool:
    """ "Red in the middle, blue on its left": the middle is told before what is told of it, so it is the table's."""
    ref, at_, _ = item
    return bool(beside) and all(members(a.b) == ref.names and a.span and a.span[0] > at_.span[0] for a in beside)


def _about(atom: g.Goal, ref: Ref) -> bool:
    """Whether a relation is one of the blocks spoken of."""
    return bool(set(ref.names) & _named(atom))


def _named(atom: g.Goal) -> set[str]:
    return {n for part in ("a", "b", "c") for n in members(getattr(atom, part, ()))}


def _parts(node: s.Equation | s.GroupBy) -> set[str]:
    return set(node.blocks if isinstance(node, s.Equation) else (n for group in node.groups for n in group))


def _and(goal: g.Goal, more: g.Goal) -> g.Goal:
    return more if isinstance(goal, g.All) and not goal.goals else conj([goal, more])


def _lines(goal: g.Goal) -> list[s.Stack | s.Row]:
    return [a for a in atoms(goal) if isinstance(a, s.Stack | s.Row)][::-1]


def _refine(goal: g.Goal, node: s.Stack | s.Row, loose: list[Loose], scene: Scene, *, denied: bool = False) -> g.Goal:
    """A line with blocks at their places. `denied`: where it is not to be so, which says nothing of the others."""
    kind = "stack" if isinstance(node, s.Stack) else "column" if node.axis == "x" else "row"
    if node.order.by != "any" and scene.lenient:
        return goal
    total = len(node.blocks)
    sides = SIDES[kind]
    places: dict[int, str] = {}
    ats, turned = each_at_its_end([(r, at_, span) for r, at_, span in loose if isinstance(at_, At)], sides[0])
    for ref, at_, span in ats:
        indices = places_of(at_, total, len(ref.names), sides, kind)
        if len(indices) != len(ref.names) or len(indices) >= total:
            raise refuse("contradiction", "so many blocks have no room there", span, "name fewer blocks", blocks=total)
        for index, name in zip(indices, ref.names, strict=True):
            if index in places or name in places.values() or not 0 <= index < total:
                raise refuse(
                    "contradiction", "two blocks are given the same place", span, "give each a place of its own"
                )
            places[index] = name
    if node.order.by != "any":
        whole, ways = ways_of(goal, node)
        if turned or any(len(ref.names) > 1 for ref, _, _ in ats):
            ways = []
        return transform(goal, lambda x: settled(ways, places, sides, scene, loose[0][2]) if x == whole else x)
    bunches = [ref.names for ref, _, _ in ats if len(ref.names) > 1]
    told = ranks_from({index: (name,) for index, name in places.items()}, node.blocks, scene, bunches)
    paired = all(isinstance(at_, At) and at_.side in SYMMETRIC for _, at_, _ in loose)
    backwards = isinstance(node, s.Row) and ats[0][0].names != node.blocks[:1]  # "A, B and C, beginning with C"
    in_turn = of_a_range if backwards else by_symbols
    ranks = tuple(told) if paired or denied else in_turn(tuple(told), node.blocks, scene)
    first = "bottom" if kind == "stack" else "left"
    order = Order(by="given", ranks=ranks, first=first)  # type: ignore[arg-type]
    if isinstance(node, s.Row):
        of_no_side = all(at_.side in ("middle", "first") for _, at_, _ in ats)
        seen = {index: looks(scene.things[name]) for index, name in places.items()}
        either_way = turned or (of_no_side and all(seen.get(total - 1 - index) == look for index, look in seen.items()))
        if len({looks(scene.things[name]) for name in node.blocks}) == 1 and len({span for _, _, span in ats}) > 1:
            either_way = False  # blocks that look alike are told apart by what else is said of them
        if node.axis == "x" or either_way:
            order = order.model_copy(update={"first": None if either_way else "front"})
        update = {"axis": node.axis if either_way else node.axis or "y"}
        lines: list[s.Stack | s.Row] = [
            node.model_copy(update={"order": o, **update}) for o in alternatives(order, scene, line=True)
        ]
    else:
        if turned:
            raise refuse("ambiguous", "the top, or the bottom?", loose[0][2], "say 'on top' or 'at the bottom'")
        lines = [node.model_copy(update={"order": o}) for o in alternatives(order, scene)]
    fixed = either(lines)
    return transform(goal, lambda x: fixed if x == node else x)


def _stack(loose: list[Loose], goal: g.Goal, scene: Scene) -> g.Goal:
    """Bottom, middle and top of a tower that only its parts speak of."""
    level = {"bottom": 0, "middle": 1, "top": 2}
    if any(sum(getattr(at_, "side", "") == side for _, at_, _ in loose) > 1 for side in ("bottom", "top")):
        raise refuse("contradiction", "two blocks are given the same place", loose[-1][2], "name another place")
    _has_middle(loose, "top", "bottom")
    check_between(loose, scene)
    ranked = sorted(loose, key=lambda item: level[item[1].side if isinstance(item[1], At) else "middle"])
    ranks = with_the_one_between(tuple(ref.names for ref, _, _ in ranked), loose, goal, scene)
    blocks = tuple(n for rank in ranks for n in rank)
    if len(blocks) < 2 or len(set(blocks)) != len(blocks):
        raise refuse("contradiction", "one block is given two places", loose[0][2])
    span = (loose[0][2][0], loose[-1][2][1])
    node = s.Stack(blocks=blocks, order=Order(by="given", ranks=ranks, first="bottom"), span=span)
    stack_built(node, scene)
    return node


def _has_middle(loose: list[Loose], *ends: str) -> None:
    """Refuse the middle of what is said to have one end at most: "big red in the middle with small blue on top"."""
    sides = {at_.side for _, at_, _ in loose if isinstance(at_, At)}
    middle = next((at_ for _, at_, _ in loose if isinstance(at_, At) and at_.side == "middle"), None)
    if middle is not None and not sides.issuperset(ends):
        raise refuse("ambiguous", "this could be the middle of the table or of what is built", middle.span,
                     "say 'of the table', or name what is on both sides of it")  # fmt: skip


def _in_row(loose: list[Loose], scene: Scene) -> g.Goal:
    """Sides and middle of a row that only its parts speak of."""
    rank = {"left": 0, "front": 0, "middle": 1, "right": 2, "back": 2}
    along = any(isinstance(at_, At) and at_.side in ("front", "back") for _, at_, _ in loose)
    first: Side = "front" if along else "left"
    placed, free = each_at_its_end([(ref, at_, span) for ref, at_, span in loose if isinstance(at_, At)], first)
    ranked = sorted(placed, key=lambda item: rank.get(item[1].side, 1))
    for n, (_, at_, _) in enumerate(ranked):
        ahead = sum(len(ref.names) for ref, _, _ in ranked[:n])
        sure = at_.side in rank or (at_.side, at_.index) == ("first", ahead + 1)
        if free or not sure or len(placed) < len(loose):
            raise refuse("ambiguous", "it is not clear which blocks of the row are there", at_.span,
                         "say how many blocks are at the left end, and how many at the right end")  # fmt: skip
    ranks = tuple(ref.names for ref, _, _ in ranked)
    blocks = tuple(n for names in ranks for n in names)
    order = Order(by="given", ranks=ranks, first=first)
    scene.add_built("row", blocks, True, loose[0][2], "left")
    return s.Row(blocks=blocks, axis="x" if along else "y", order=order, span=(loose[0][2][0], loose[-1][2][1]))


def _across(loose: list[Loose]) -> g.Goal:
    """ "A on the left and B on the right": each left of the next."""
    _has_middle(loose, *(("front", "back") if deep(loose) else ("left", "right")))
    rank = {"left": 0, "front": 0, "middle": 1, "right": 2, "back": 2}
    ranked = sorted(loose, key=lambda item: rank[item[1].side if isinstance(item[1], At) else "middle"])
    sides = {item[1].side for item in loose if isinstance(item[1], At)}
    node: type[r.LeftOf | r.InFrontOf] = r.InFrontOf if deep(loose) else r.LeftOf
    if len(sides) < len(loose):
        raise refuse("ambiguous", "several blocks are said to be on the same side", loose[-1][2], "say of what")
    goals: list[g.Goal] = []
    for (a, _, span), (b, _, _) in itertools.pairwise(ranked):
        goals.append(node(a=foot(a), b=foot(b), span=span))
    return conj(goals)


def _region(item: Loose) -> g.Goal:
    ref, at_, span = item
    side = at_.side if isinstance(at_, At) else ""
    if isinstance(at_, At) and at_.own:
        raise refuse("no-referent", "it is not said of which blocks this is one", at_.span, "name the others")
    side = "end" if side == "first" and isinstance(at_, At) and (at_.index or 0) < 0 else side
    if side not in REGION or (isinstance(at_, At) and at_.index) or ref.quant is not None:
        raise refuse(
            "no-referent", f"it is not clear of what this is the {side}", at_.span, "name the tower or the row"
        )
    return r.InRegion(a=ref.names, region=REGION[side], span=span)  # type: ignore[arg-type]
