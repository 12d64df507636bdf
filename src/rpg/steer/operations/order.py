"""Other orders of the same blocks: reversed, mirrored, sorted, listed, swapped, moved."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.blocks.nouns import bare, join
from rpg.blocks.predicates.order import SORTED
from rpg.blocks.traits import Traits, kind_of, symbol_of
from rpg.core.diagnostics import Span
from rpg.ir.edits import ChangeCondition, Permute, SetField, SetGoal
from rpg.ir.goal import All
from rpg.ir.order import Order, Pattern
from rpg.ir.relations import Between, Facing, Moved, Shifted, Stayed, Turned
from rpg.ir.structures import Cells, GroupBy, Row, Spells, Stack, Staircase
from rpg.ir.walk import conjuncts
from rpg.ir.walk import names as names_in
from rpg.steer.draft import Draft
from rpg.steer.operations.kinds import convert
from rpg.steer.operations.lines import arranged
from rpg.steer.operations.mirror import mirrored
from rpg.steer.operations.sort import BY, color_pattern, ranks_by_class, sorted_members
from rpg.steer.operations.steps import of_steps, turn_steps
from rpg.steer.refer import lines_of, resolve
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import m
from rpg.steer.view import BEGINS, ENDS, Line, Shape
from rpg.steer.wholes import Found


def reorder(draft: Draft, request: r.Reorder) -> None:
    """Another order for a line or a figure: the one named, else the one mentioned last."""
    if of_steps(draft, request):
        turn_steps(draft, request)
        return
    if request.how == "reverse" and len(several := lines_of(draft.view, request.theme)) > 1:
        for each in several:
            _reverse(draft, draft.view.line_of(each.members), None, request.span)
        return
    found = resolve(draft.view, request.theme) if request.theme is not None else None
    line, figure = _target(draft, found)
    if request.how == "swap" and found is not None and not found.whole and len(found.names) == 2:
        line = draft.view.line_of(found.names)
    elif found is not None and not found.whole and line is not None and not set(found.names) <= set(line.members):
        told, hint = "these blocks are in more than one line", "say the order of each of them"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    draft.note("order", {"how": request.how, "descending": request.descending, "first": request.first})
    if request.how == "mirror":
        draft.aim("MODIFY")
        draft.do(SetGoal(goal=mirrored(draft.schema.goal)), request.span)
    elif request.how in ("reverse", "swap"):
        some = found is not None and not found.whole and line is not None and set(found.names) < set(line.members)
        if request.how == "reverse" and some and isinstance(request.theme, m.Noun):
            told, hint = "these are only some of the blocks in a line", "say 'reverse the row', or which two to swap"
            raise draft.refusal("edit-unclear", told, request.span, hint)
        if request.how == "swap" and (line is None or len(line.members) != 2):
            _swap_two(draft, found.names if found is not None and not found.whole else (), request.span)
            return
        _reverse(draft, line, figure, request.span)
    elif request.how == "given":
        _given(draft, line, request)
    elif request.how == "toward":
        _toward(draft, line, request)
    else:
        _sort(draft, line, figure, request)


def _swap_two(draft: Draft, named: tuple[str, ...], span: Span) -> None:
    """The two that were named, the only two blocks that the goal speaks of, or the two mentioned last trade places."""
    two = named or (draft.view.busy if len(draft.view.busy) == 2 else draft.view.focus)
    if len(two) != 2:
        raise draft.refusal("ambiguous-object", "this could be any two blocks", span, "name the two blocks")
    before, looks = draft.schema.goal, draft.view.world.look
    permute(draft, {two[0]: two[1], two[1]: two[0]}, span)
    if draft.schema.goal == before or looks.get(two[0]) == looks.get(two[1], ()):
        raise draft.refusal("nothing-to-do", "the goal does not tell these blocks apart", span)
    draft.aim("MODIFY")
    draft.look_at(tuple(two))


def _target(draft: Draft, found: Found | None) -> tuple[Line | None, Shape | None]:
    if found is not None and found.whole:
        return found.line, found.figure
    if found is not None and (line := draft.view.line_of(found.names)):
        return line, None
    line, figure = draft.view.main_line(), draft.view.main_figure()
    if line is not None and figure is not None:
        recent = next((n for n in reversed(draft.focus) if n in line.members or n in figure.members), None)
        return (None, figure) if recent is not None and recent not in line.members else (line, None)
    return line, figure


def _reverse(draft: Draft, line: Line | None, figure: Shape | None, span: Span) -> None:
    draft.aim("MODIFY")
    if line is None:
        _reverse_figure(draft, figure, span)
        return
    if isinstance(line.node, Spells):
        draft.do(SetField(at=line.path, field="reverse", value=not line.node.reverse), span)
        return
    if not line.ordered or len({draft.view.world.look[n] for n in line.members}) == 1:
        raise draft.refusal(
            "nothing-to-do",
            "the order of these blocks is free, so that it cannot be turned round",
            span,
            "give an order: sort them by colour",
        )
    free = [name for name in line.members if name not in draft.kept]
    node = line.node
    if isinstance(node, Stack | Row) and node.order.by in SORTED and len(free) == len(line.members):
        order = node.order.model_copy(update={"descending": not node.order.descending})
        draft.do(SetField(at=line.path, field="order", value=order.model_dump()), span)
        return
    if isinstance(node, Stack | Row) and node.order.by == "given" and len(free) == len(line.members):
        order = node.order.model_copy(update={"ranks": tuple(reversed(node.order.ranks))})
        draft.do(SetField(at=line.path, field="order", value=order.model_dump()), span)
        return
    permute(draft, dict(zip(reversed(free), free, strict=True)), span)


def _reverse_figure(draft: Draft, figure: Shape | None, span: Span) -> None:
    node = figure.node if figure else None
    if isinstance(node, Staircase) and node.up is not None and figure is not None:
        draft.do(SetField(at=figure.path, field="up", value=ENDS[node.up]), span)
    elif figure is not None and isinstance(node, Cells) and node.pattern is not None and _is_read(node.pattern):
        order = node.pattern.order
        turned = (
            {"ranks": tuple(reversed(order.ranks))} if order.by == "given" else {"descending": not order.descending}
        )
        pattern = node.pattern.model_copy(update={"order": order.model_copy(update=turned)})
        draft.do(SetField(at=figure.path, field="pattern", value=pattern.model_dump()), span)
    else:
        raise draft.refusal(
            "nothing-to-do",
            "nothing here is in an order that could be turned round",
            span,
            "name two blocks to swap, or give an order",
        )


def _is_read(pattern: Pattern) -> bool:
    """Whether there is a way in which the cells are read, and that could be turned round; parts have none."""
    return pattern.kind == "reading" and not pattern.own


def _toward(draft: Draft, line: Line | None, request: r.Reorder) -> None:
    """The same order, beginning on another side."""
    draft.aim("MODIFY")
    node = line.node if line is not None else None
    begin = BEGINS[line.kind] if line is not None else ""
    fits = request.first is not None and request.first in (begin, ENDS.get(begin))
    if line is None or not isinstance(node, Stack | Row) or node.order.by == "any" or not fits:
        raise draft.refusal(
            "edit-unclear",
            "there is no order here that could begin on that side",
            request.span,
            "sort a row or a tower",
        )
    if (node.order.first or begin) == request.first:
        raise draft.refusal("nothing-to-do", "the order begins there already", request.span)
    order = node.order.model_copy(update={"first": request.first})
    draft.do(SetField(at=line.path, field="order", value=order.model_dump()), request.span)


def permute(draft: Draft, parts: dict[str, str], span: Span) -> None:
    """Blocks take each other's parts in the goal."""
    parts = {name: part for name, part in parts.items() if name != part}
    if not parts:
        raise draft.refusal("nothing-to-do", "they are in this order already", span)
    own = [(path, atom) for path, atom in draft.view.atoms if isinstance(atom, _OWN)]
    draft.do(Permute(parts=parts), span)
    now = dict(draft.view.atoms)
    for path, atom in own:
        if now.get(path) != atom:
            draft.do(ChangeCondition(at=path, to=atom), span)


_OWN = (Facing, Turned, Stayed, Moved, Shifted)
"""What is asked of a block and not of its place: it does not go over to the block that takes the place."""


def _given(draft: Draft, line: Line | None, request: r.Reorder) -> None:
    """The order that the request lists, from where the line begins."""
    draft.aim("MODIFY")
    items = request.items.items if isinstance(request.items, m.Coord) else ()
    listed: list[str] = []
    for item in items:
        listed += [name for name in resolve(draft.view, item).names if name not in listed]
    if line is None or set(listed) != set(line.members):
        missing = [bare(n, draft.view.world) for n in (line.members if line else ()) if n not in listed]
        told = f"the order leaves out the {join(missing)}" if missing else "these blocks do not stand in a line"
        raise draft.refusal("edit-unclear", told, request.span, "list every block of the tower or the row once")
    if request.first not in (None, BEGINS[line.kind], ENDS[BEGINS[line.kind]]):
        told = f"a {line.kind} has no {request.first} end"
        hint = f"say the order from {BEGINS[line.kind]} to {ENDS[BEGINS[line.kind]]}"
        raise draft.refusal("edit-unclear", told, request.span, hint)
    if request.first == ENDS[BEGINS[line.kind]]:
        listed.reverse()
    put_in_order(draft, line, listed, request.span)
    _drop_between(draft, line, request.span)


def put_in_order(draft: Draft, line: Line, members: Sequence[str], span: Span) -> None:
    if line.node is None:
        permute(draft, dict(zip(members, line.members, strict=True)), span)
    else:
        draft.do(ChangeCondition(at=line.path, to=arranged(draft, line, members)), span)


def _sort(draft: Draft, line: Line | None, figure: Shape | None, request: r.Reorder) -> None:
    members = line.members if line else figure.members if figure else draft.view.busy
    if request.how in ("label", "number", "color") and not _can(draft, members, request.how):
        convert(draft, members, {"label": "letter", "number": "digit", "color": "plain"}[request.how], request.span)
        line, figure = _target(draft, None)
        members = line.members if line else figure.members if figure else draft.view.busy
    if line is not None:
        _sort_line(draft, line, request)
    elif figure is not None:
        _sort_figure(draft, figure, request)
    elif request.how in ("color", "kind", "label", "vowel", "parity", "size"):
        _group(draft, members, request.how, request.span)
    else:
        raise draft.refusal(
            "edit-unclear",
            "these blocks do not stand in a line that could be ordered",
            request.span,
            "say what they form: a row, a tower",
        )


def _can(draft: Draft, members: Sequence[str], how: str) -> bool:
    """Whether blocks have what an order compares."""
    symbols = [symbol_of(draft.view.world, name) for name in members]
    if how == "label":
        return all(symbols)
    if how == "number":
        return sum(kind_of(symbol) == "digit" for symbol in symbols) > 1
    colors = {draft.view.world.blocks[name].color for name in members if name in draft.view.world.blocks}
    return len(colors) > 1 or (any(symbols) and len(colors) > 1)


def _sort_line(draft: Draft, line: Line, request: r.Reorder) -> None:
    """Sorting an order that was free adds to the goal; any other one replaces what it asked for."""
    node = line.node
    was_free = isinstance(node, Stack | Row) and node.order.by == "any"
    draft.aim("EXTEND" if was_free else "MODIFY")
    if request.how == "any":
        if not isinstance(node, Stack | Row):
            raise draft.refusal(
                "edit-unclear",
                "these places are related one by one, so that their order is the goal",
                request.span,
                "remove the relation instead",
            )
        draft.do(SetField(at=line.path, field="order", value=Order().model_dump()), request.span)
        draft.aim("MODIFY")
        return
    if request.how in ("even_first", "odd_first", "vowel_first", "consonant_first"):
        _sort_by_class(draft, line, request)
        return
    by, descending = _by(draft, line.members, request)
    if isinstance(node, Stack | Row):
        first = request.first or (None if line.kind == "tower" else BEGINS[line.kind])
        order = Order.model_validate({"by": by, "descending": descending, "first": first})
        if by == "size" and len({draft.view.world.edge[name] for name in node.blocks}) == 1:
            told, hint = "these blocks are all of one size", "sort by something that they differ in"
            raise draft.refusal("nothing-to-do", told, request.span, hint)
        if by in SORTED and draft.view.sequence(node.blocks, order, line.kind) is None:
            raise draft.refusal(
                "edit-unclear",
                f"not every block has what an order by {by} compares",
                request.span,
                "list the order you want",
            )
        draft.do(SetField(at=line.path, field="order", value=order.model_dump()), request.span)
        _drop_between(draft, line, request.span)
        return
    members = sorted_members(draft, line.members, by, descending)
    if request.first == ENDS[BEGINS[line.kind]]:
        members.reverse()
    put_in_order(draft, line, members, request.span)


def _drop_between(draft: Draft, line: Line, span: Span) -> None:
    """A new order of a line gives up which of its blocks were to be between which."""
    parts = conjuncts(draft.schema.goal)
    left = [part for part in parts if not (isinstance(part, Between) and set(names_in(part)) <= set(line.members))]
    if len(left) < len(parts):
        draft.aim("MODIFY")
        draft.do(SetGoal(goal=left[0] if len(left) == 1 else All(goals=tuple(left))), span)


def _sort_by_class(draft: Draft, line: Line, request: r.Reorder) -> None:
    if not isinstance(line.node, Stack | Row):
        raise draft.refusal("edit-unclear", "this order needs a row or a tower", request.span)
    ranks = ranks_by_class(draft, line.members, request.how)
    first = request.first or (None if line.kind == "tower" else BEGINS[line.kind])
    order = Order.model_validate({"by": "given", "ranks": ranks, "first": first})
    draft.do(SetField(at=line.path, field="order", value=order.model_dump()), request.span)


def _by(draft: Draft, members: Sequence[str], request: r.Reorder) -> tuple[str, bool]:
    """What the order compares; "ascending" goes by what the blocks have."""
    if request.how in ("size_up", "size_down"):
        return "size", request.how == "size_down"
    if request.how == "ascending":
        kinds = {kind_of(symbol_of(draft.view.world, name)) for name in members}
        return ("number" if kinds == {"digit"} else "label" if kinds == {"letter"} else "size"), request.descending
    if request.how == "color":
        colors = [draft.view.world.blocks[name].color for name in members]
        return ("rainbow" if len(set(colors)) == len(colors) else "together"), request.descending
    return BY.get(request.how, request.how), request.descending


def _sort_figure(draft: Draft, figure: Shape, request: r.Reorder) -> None:
    node = figure.node
    draft.aim("MODIFY")
    if isinstance(node, GroupBy):
        _group(draft, figure.members, request.how, request.span, figure)
        return
    if not isinstance(node, Cells):
        raise draft.refusal(
            "edit-unclear", "this structure has no order", request.span, "sort a row, a tower or a pyramid"
        )
    if request.how == "color":
        color_pattern(draft, figure, request.span)
        return
    by, descending = _by(draft, figure.members, request)
    pattern = Pattern(kind="reading", order=Order.model_validate({"by": by, "descending": descending}))
    traits = Traits(draft.view.world)
    if by in ("number", "label") and not all(traits.symbol(name) for name in figure.members):
        marked = [name for name in figure.members if traits.symbol(name)]
        ranks = tuple((name,) for name in sorted_members(draft, marked, by, descending))
        pattern = Pattern(kind="reading", order=Order(by="given", ranks=ranks))
    draft.do(SetField(at=figure.path, field="pattern", value=pattern.model_dump()), request.span)
    if not node.readable and by in ("number", "label"):
        draft.do(SetField(at=figure.path, field="readable", value=True), request.span)


def _group(draft: Draft, members: Sequence[str], attribute: str, span: Span, figure: Shape | None = None) -> None:
    """Blocks without a line are sorted into groups."""
    draft.aim("MODIFY")
    groups = Traits(draft.view.world).by_value(tuple(members), attribute)  # type: ignore[arg-type]
    if len(groups) < 2:
        raise draft.refusal(
            "nothing-to-do",
            f"all of these blocks have the same {attribute}",
            span,
            "sort by something that they differ in",
        )
    goal = GroupBy.model_validate({"groups": tuple(tuple(names) for names in groups.values()), "by": attribute})
    if figure is not None:
        draft.do(ChangeCondition(at=figure.path, to=goal), span)
    else:
        draft.do(SetGoal(goal=goal), span)


def group(draft: Draft, request: r.Group) -> None:
    """Blocks are sorted into groups by what the request says, else by what they differ in: kind before colour."""
    names = resolve(draft.view, request.theme).names if request.theme is not None else draft.view.busy
    figure = next((f for f in draft.view.figures if isinstance(f.node, GroupBy)), None)
    members = figure.members if figure is not None and request.theme is None else names
    by = request.by or ""
    if not by:
        kinds = {kind_of(symbol_of(draft.view.world, name)) for name in members}
        by = "kind" if len(kinds) > 1 else "label" if kinds != {"plain"} else "color"
    draft.note("group", by)
    groups = Traits(draft.view.world).by_value(tuple(members), by)  # type: ignore[arg-type]
    wanted = {frozenset(group) for group in groups.values()}
    if figure is not None and isinstance(figure.node, GroupBy):
        now = {frozenset(group) for group in figure.node.groups}
        if figure.node.by == by and now == wanted:
            return
    _group(draft, members, by, request.span, figure)
