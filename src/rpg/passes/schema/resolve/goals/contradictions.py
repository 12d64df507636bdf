"""Goals that contradict themselves, found from names alone: support cycles, two places at once, opposite sides."""

from __future__ import annotations

import itertools

from rpg.core.diagnostics import Refusal, Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import Highest, Lowest, members
from rpg.ir.relations import Region
from rpg.ir.walk import atoms
from rpg.ir.walk import names as names_in
from rpg.passes.schema.resolve.goals.conflicts import clash, impossible, required
from rpg.passes.schema.resolve.things.world import Scene, refuse


def check(goal: g.Goal, scene: Scene) -> None:
    """Refuse a goal that cannot hold."""
    for stage in _stages(goal):
        check(stage, scene)
    parts = list(required(goal))
    _to_themselves(goal)
    _cycles(parts)
    _cycles(scene.start_goals)
    for index, a in enumerate(parts):
        for b in parts[index + 1 :]:
            if clash(a, b):
                raise _clash(a, b)
    if impossible(goal, parts):
        raise _clash(goal, goal)
    _direction_cycles(parts)
    _turned_in_words(parts)
    _between_neighbours(parts)
    _of_those_that_stay(parts)
    _done_and_kept(goal)
    _inside_lines(parts)
    _along_an_edge(parts)
    _next_to_the_top(parts)
    _above_side_by_side(parts)
    _swapped_in_what_is_built(parts, scene)


def _swapped_in_what_is_built(parts: list[g.Goal], scene: Scene) -> None:
    """Refuse "a row of A, B and C, but swap A and C": in the row, or with where each of them starts? And "red on blue,
    green on yellow. Swap red and green", where these are no more as they were told."""
    begun = {n for start in scene.start_goals for n in names_in(start)}
    wholes = [{*x.blocks} for x in parts if isinstance(x, s.Row | s.Stack | s.Cells | s.Spells | s.Equation)]
    for swap in (x for x in parts if isinstance(x, r.Swapped)):
        two = {*swap.a, *swap.b}
        if not two & begun and any(two <= whole for whole in wholes):
            raise refuse("ambiguous", "the places that these have in what is built, or those where they start?",
                         swap.span, "say how it should be in the end, or how the blocks start")  # fmt: skip
        placed = [*wholes, *({*members(x.a)} for x in parts if isinstance(x, r.On))]
        if not two & begun and sum(not two.isdisjoint(whole) for whole in placed) > 1:
            raise refuse("contradiction", "these are swapped, and stand at the end as they are told", swap.span,
                         "say how it should be in the end, or how the blocks start")  # fmt: skip


def _above_side_by_side(parts: list[g.Goal]) -> None:
    """Refuse "the word ONE, and TWO below it": no two side by side are in a tower with a third."""
    lines = [
        {*x.blocks}
        for x in parts
        if isinstance(x, s.Row | s.Equation) or (isinstance(x, s.Spells) and x.along == "row")
    ]
    for above in (x for x in parts if isinstance(x, r.Above)) if lines else ():
        if any(len(line & {*members(side)}) > 1 for line in lines for side in (above.a, above.b)):
            raise refuse("ambiguous", "what lies side by side is not above a block as a whole, nor below it",
                         above.span, "say 'behind' or 'in front of', or which block lies on which")  # fmt: skip


def _next_to_the_top(parts: list[g.Goal]) -> None:
    """Refuse "put blue on top of the tower and red next to it" as red up in the air beside the blue block."""
    upper = {n for x in parts if isinstance(x, r.On) and isinstance(x.b, Highest) for n in members(x.a)}
    for x in parts:
        sides = [members(x.a), members(x.b)] if isinstance(x, r.Beside | r.Adjacent) else []
        if sum(len(side) == 1 and upper.issuperset(side) for side in sides) == 1:
            raise refuse("ambiguous", "next to this block, or to the tower that it lies on?", x.span, "say which")


def _inside_lines(parts: list[g.Goal]) -> None:
    """Refuse what is said of some blocks of a line as if they stood alone: "a tower of two red and two blue blocks with
    the blue ones together", "... with the reds on top of the blues"; and "apart" of the blocks of one group."""
    lots = [{*lot} for x in parts if isinstance(x, s.GroupBy) and not x.outliers for lot in x.groups]
    for apart in (x for x in parts if isinstance(x, r.Apart)):
        if any({*members(apart.a), *members(apart.b)} <= lot for lot in lots):
            raise refuse("ambiguous", "blocks of one group are to be apart, or is this said of the groups?", apart.span,
                         "say 'the groups', which are apart from each other anyway, or name single blocks")  # fmt: skip
    told = [x.goal if isinstance(x, g.Not) else x for x in parts]
    for lot in (x for x in told if isinstance(x, s.GroupBy)):
        wholes = [x for x in parts if isinstance(x, s.Stack | s.Row | s.Figure) and lot.groups != (x.blocks,)]
        lines = [{*x.blocks} for x in wholes if isinstance(x, s.Figure) or x.order.by == "any"]
        if any({n for group in lot.groups for n in group} <= line for line in lines):
            raise refuse("ambiguous", "how these are together in the line is not clear", lot.span,
                         "say in which order the blocks of the line come")  # fmt: skip
    for line in (x for x in parts if isinstance(x, s.Stack | s.Row)):
        pairs = [x for x in parts if isinstance(x, r.On) and {*members(x.a), *members(x.b)} < {*line.blocks, ""}]
        lower = {n for x in pairs for n in members(x.b)}
        pairs = [x for x in pairs if x.span and line.order.by == "any" and not lower & {*members(x.a)}]
        alike = [x for x in pairs if sum(y.span == x.span for y in pairs) > 1]
        if alike and isinstance(line, s.Stack):
            raise refuse("ambiguous", "each of these on one of those, or all of them above those?", alike[0].span,
                         "say in which order the blocks of the tower come")  # fmt: skip


_ACROSS: dict[str, tuple[Region, ...]] = {"y": ("left_edge", "right_edge"), "x": ("near_edge", "far_edge")}
"""Edges at which a line along an axis has room for one of its blocks."""


def _along_an_edge(parts: list[g.Goal]) -> None:
    """Refuse "a row along the left edge", "a column along the near edge": no line that way is all at that edge."""
    lines = [(x, x.axis or "") for x in parts if isinstance(x, s.Row)]
    read = [(x, "y") for x in parts if isinstance(x, s.Spells | s.Equation) and x.along == "row"]
    for line, axis in (*lines, *read):
        for there in (x for x in parts if isinstance(x, r.InRegion) and x.region in _ACROSS.get(axis, ())):
            if len({*line.blocks} & {*members(there.a)}) < _BESIDE_AN_EDGE:
                continue
            row = "word" if not isinstance(line, s.Row) else "row" if axis == "y" else "column"
            way = {"word": "'along the near edge'", "row": "'from front to back'", "column": "'a row'"}[row]
            raise refuse("ambiguous", f"a {row} leads away from this edge: is all of it to be there, or one end?",
                         there.span, f"say {way}, or which block is at the edge")  # fmt: skip


_BESIDE_AN_EDGE = 3
"""So many blocks in a line away from an edge are no more all at it."""


def _done_and_kept(goal: g.Goal) -> None:
    """Refuse "then, keeping it there, put green on the mat" of green: what is so all the time is not to be done."""
    parts = goal.goals if isinstance(goal, g.All) else ()
    bare = [x.model_copy(update={"span": None}) for x in parts if isinstance(x, r.On | r.OnPatch | r.InRegion)]
    for always in (x for x in parts if isinstance(x, g.Always)):
        if always.goal.model_copy(update={"span": None}) in bare:
            raise refuse("ambiguous", "this is to be done, and is to be so all the time", always.span,
                         "name what is to be kept where it is")  # fmt: skip


def _of_those_that_stay(parts: list[g.Goal]) -> None:
    """Refuse "all blocks to the right half, but red stays where it is": is red to be there or not?"""
    stays = [x for x in parts if isinstance(x, r.Stayed)]
    for there in (x for x in parts if isinstance(x, r.InRegion | r.OnPatch)):
        if any({*members(stay.a)} < {*members(there.a)} for stay in stays):
            raise refuse("ambiguous", "a block that is to stay is one of those to be put somewhere", there.span,
                         "say 'all but the red one', or name the blocks that are to be there")  # fmt: skip


def check_all(goal: g.Goal, scene: Scene) -> None:
    """Refuse a goal that cannot hold, and a start that cannot be."""
    check(goal, scene)
    _begun_just_so(goal, scene)
    _never_as_begun(goal, scene)
    _put_though_it_stays(goal, scene)
    try:
        check(g.All(goals=tuple(scene.start_goals)), scene)
    except Refusal as refusal:
        told = {"code": "contradiction", "message": "what is told of the start cannot all be so"}
        raise Refusal([refusal.diagnostics[0].model_copy(update=told)]) from None


def _put_though_it_stays(goal: g.Goal, scene: Scene) -> None:
    """Refuse "all the blocks stay where they are, and red goes on the mat", unless it is told where red starts."""
    parts = goal.goals if isinstance(goal, g.All) else ()
    stay = {n for x in parts if isinstance(x, r.Stayed) for n in members(x.a)}
    stay -= {n for start in scene.start_goals for n in names_in(start)}
    for there in (x for x in parts if isinstance(x, r.On | r.OnPatch)) if stay else ():
        if stay & {*members(there.a)}:
            raise refuse("contradiction", "this block is to stay where it is, and to be put somewhere", there.span,
                         "say 'all the others stay where they are'")  # fmt: skip


def _never_as_begun(goal: g.Goal, scene: Scene) -> None:
    """Refuse "red starts on the mat, and must never be on it"."""
    begun = [x.model_copy(update={"span": None}) for start in scene.start_goals for x in required(start)]
    for always in (x for x in (goal.goals if isinstance(goal, g.All) else (goal,)) if isinstance(x, g.Always)):
        for never in (x for x in required(always.goal) if isinstance(x, g.Not)):
            if never.goal.model_copy(update={"span": None}) in begun:
                raise refuse("contradiction", "this is said to be so at the start, and never to be so", always.span,
                             "say 'no longer', or 'not ... at the end'")  # fmt: skip


def _begun_just_so(goal: g.Goal, scene: Scene) -> None:
    """Refuse "A, B and C start in a row, and end in a row as C, B and A": without an order it is so from the start."""
    if not isinstance(goal, s.Row | s.Stack) or goal.order.by != "any":
        return
    told = goal.model_dump(exclude={"span", "blocks", "exact"})
    for start in (x for x in scene.start_goals if isinstance(x, s.Row | s.Stack)):
        if {*start.blocks} == {*goal.blocks} and start.model_dump(exclude={"span", "blocks", "exact"}) == told:
            raise refuse("ambiguous", "they are in such a line from the beginning, in no other order", goal.span,
                         "say the order, for example 'from left to right' or 'from bottom to top'")  # fmt: skip


def _between_neighbours(parts: list[g.Goal]) -> None:
    """Nothing is between two blocks that touch."""
    direct: list[g.Goal] = [part for part in parts if not isinstance(part, r.Above)]
    touching = {frozenset((a, b)) for a, b, _ in _supports(direct)}
    pairs = (part for part in parts if isinstance(part, s.Stack) and len(part.blocks) == 2 and not part.exact)
    touching |= {frozenset(pair.blocks) for pair in pairs}
    touching |= {frozenset((*members(part.a), *members(part.b))) for part in parts if isinstance(part, r.Touching)}
    for part in parts:
        if not isinstance(part, r.Between) or not isinstance(part.b, tuple) or not isinstance(part.c, tuple):
            continue
        if len(part.b) == len(part.c) == 1 and frozenset((*part.b, *part.c)) in touching:
            raise refuse("contradiction", "nothing is between two blocks that touch", part.span,
                         "say which block touches or lies on which")  # fmt: skip


def _stages(goal: g.Goal) -> list[g.Goal]:
    """The stages of every sequence in a conjunction: each must hold at some time."""
    if isinstance(goal, g.Sequence):
        return [stage.goal for stage in goal.stages]
    return [x for part in goal.goals for x in _stages(part)] if isinstance(goal, g.All) else []


def _to_themselves(goal: g.Goal) -> None:
    """A relation of a tower to one of its own blocks says nothing that could be meant."""
    for atom in atoms(goal):
        a, b = getattr(atom, "a", ()), getattr(atom, "b", ())
        if isinstance(atom, r.Beside | r.Adjacent | r.Touching | r.Apart) and set(members(a)) & set(members(b)):
            told = "apart from" if isinstance(atom, r.Apart) else "next to"
            raise refuse("self-reference", f"a block cannot be {told} itself", atom.span, "name other blocks")
        towers = isinstance(a, Lowest | Highest) or isinstance(b, Lowest | Highest)
        if towers and set(members(a)) & set(members(b)):
            raise refuse(
                "self-reference", "a tower cannot be placed relative to its own blocks", atom.span, "name another block"
            )


def _turned_in_words(parts: list[g.Goal]) -> None:
    """A word is read from one side: none of its cubes can face another one at the same time."""
    read = {n: _read_from(x) for x in parts if _is_read(x) for n in x.blocks}  # type: ignore[union-attr]
    for part in parts:
        if isinstance(part, r.Facing) and part.block in read and part.toward != read[part.block]:
            raise refuse(
                "contradiction",
                "a block of a word is read from one side, and cannot face another one as well",
                part.span,
                "leave the direction out",
            )


def _is_read(part: g.Goal) -> bool:
    return isinstance(part, s.Spells) or (isinstance(part, s.Row | s.Stack) and part.readable)


def _read_from(part: g.Goal) -> str:
    """Where the cubes of a word or of an order are read from."""
    upright = isinstance(part, s.Stack) or (isinstance(part, s.Spells) and part.along == "stack")
    return "viewer" if upright else "up"


def _clash(a: g.Goal, b: g.Goal) -> Exception:
    first, second = a.span or (0, 0), b.span or (0, 0)
    labels = ((first, "this"),) if first != second else ()
    return refuse(
        "contradiction", "two parts of this cannot both hold at the end", second,
        "leave one of them out, or say 'then' if one comes after the other", labels=labels,
    )  # fmt: skip


def _supports(parts: list[g.Goal]) -> list[tuple[str, str, Span | None]]:
    edges: list[tuple[str, str, Span | None]] = []
    for part in parts:
        if isinstance(part, r.On | r.Above):
            # what lies on the top of a tower is above all of it, and so is all of a tower above what its foot lies on
            upper = part.a.lowest if isinstance(part.a, Lowest) else part.a
            lower = part.b.highest if isinstance(part.b, Highest) else part.b
            pairs = itertools.product(upper, lower) if isinstance(upper, tuple) and isinstance(lower, tuple) else ()
            edges += [(a, b, part.span) for a, b in pairs]
        elif isinstance(part, s.Stack) and part.order.by == "given":
            ranks = part.order.ranks if part.order.first != "top" else part.order.ranks[::-1]
            for below, over in itertools.pairwise(ranks):
                edges += [(a, b, part.span) for a in over for b in below]
    return edges


def _cycles(parts: list[g.Goal]) -> None:
    cycle = _find_cycle(_supports(parts))
    if cycle:
        spans = [span for span in cycle if span]
        raise refuse(
            "support-cycle", "these blocks would have to lie on each other in a circle", spans[-1] if spans else None,
            "let one of them lie on the table",
            labels=tuple((span, "this") for span in dict.fromkeys(spans[:-1]) if span != spans[-1]),
        )  # fmt: skip


def _direction_cycles(parts: list[g.Goal]) -> None:
    for kinds in (("left_of", "right_of"), ("in_front_of", "behind")):
        edges: list[tuple[str, str, Span | None]] = []
        for part in parts:
            if getattr(part, "kind", "") in kinds and isinstance(part.a, tuple) and isinstance(part.b, tuple):  # type: ignore[union-attr]
                pairs = [(a, b) for a in part.a for b in part.b]  # type: ignore[union-attr]
                edges += [(a, b, part.span) if part.kind == kinds[0] else (b, a, part.span) for a, b in pairs]
        cycle = _find_cycle(edges)
        if cycle:
            spans = [span for span in cycle if span]
            raise refuse("contradiction", "these places contradict each other", spans[-1] if spans else None,
                "leave one of them out",
                         labels=tuple((s_, "this") for s_ in dict.fromkeys(spans[:-1]) if s_ != spans[-1]))  # fmt: skip


def _find_cycle(edges: list[tuple[str, str, Span | None]]) -> list[Span | None]:
    """The spans along a cycle of edges, or nothing."""
    out: dict[str, list[tuple[str, Span | None]]] = {}
    for a, b, span in edges:
        out.setdefault(a, []).append((b, span))
    for start in out:
        stack: list[tuple[str, list[Span | None]]] = [(start, [])]
        seen: set[str] = set()
        while stack:
            node, path = stack.pop()
            for nxt, span in out.get(node, ()):
                if nxt == start:
                    return [*path, span]
                if nxt not in seen:
                    seen.add(nxt)
                    stack.append((nxt, [*path, span]))
    return []
