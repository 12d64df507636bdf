"""Places: where blocks without a duty are put, in a line, beside something, on a patch, in a group."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from rpg.blocks.nouns import bare
from rpg.blocks.traits import Traits
from rpg.core.diagnostics import Span
from rpg.ir.edits import AddCondition, ChangeCondition, SetField
from rpg.ir.goal import Count, Not
from rpg.ir.node import EACH, Highest, Lowest, Operand
from rpg.ir.relations import InRegion, On, OnPatch, OnTable
from rpg.ir.structures import Equation, Figure, GroupBy, Pyramid, Row, Spells, Stack
from rpg.steer.draft import Draft
from rpg.steer.operations.hub import into_the_middle
from rpg.steer.operations.lines import insert
from rpg.steer.operations.relate import relation
from rpg.steer.requests import requests as r
from rpg.steer.requests.language import m
from rpg.steer.view import Line, Shape
from rpg.steer.wholes import Found

_RELATIONS = {"top": "on", "bottom": "under", "front": "front", "back": "behind", "left": "left", "right": "right"}


def join(draft: Draft, names: Sequence[str], line: Line | None, figure: bool, span: Span) -> None:
    """No place was said: on top of the tower, at the end of the row, in the group it belongs to."""
    groups = draft.view.figures
    group = next((f for f in groups if isinstance(f.node, GroupBy)), None)
    if group is not None:
        for name in names:
            _join_group(draft, name)
        return
    loose = next((f for f in groups if isinstance(f.node, Figure) and f.node.sides is None and not f.node.filled), None)
    if line is not None:
        end = (
            "on top of the tower"
            if line.kind == "tower"
            else "at the right end of the row"
            if line.kind == "row"
            else "at the back of the column"
        )
        for name in names:
            if not _sorted_in(draft, _same(draft, line), name, span):
                draft.assume(f"what is added without a place goes {end}")
                insert(draft, _same(draft, line), len(_same(draft, line).members), name, span)
    elif loose is not None:
        members = (*loose.members, *names)
        draft.do(SetField(at=loose.path, field="blocks", value=members), span)
    else:
        what = "this structure has no free place" if figure else "the request does not say where it goes"
        raise draft.refusal(
            "edit-unclear", what, span, "say where: on top of, beside, to the left of ..., or as a distractor"
        )


def _sorted_in(draft: Draft, line: Line, name: str, span: Span) -> bool:
    """Put a block where the order of a line has it, if the line has one that tells: alphabetical, numeric, by size."""
    node = line.node
    if not isinstance(node, Stack | Row) or node.order.by not in ("label", "number", "rainbow", "size"):
        return False
    blocks = (*line.members, name)
    if draft.view.sequence(blocks, node.order, line.kind) is None:
        return False
    draft.do(SetField(at=line.path, field="blocks", value=blocks), span)
    return True


def _same(draft: Draft, line: Line) -> Line:
    """The line as it is now, after something joined it."""
    return draft.view.line_of(line.members) or line


def _join_group(draft: Draft, name: str) -> None:
    """Into the group that shares what the groups are told apart by; else a group of its own."""
    figure = next(f for f in draft.view.figures if isinstance(f.node, GroupBy))
    node = figure.node
    assert isinstance(node, GroupBy)
    traits = Traits(draft.view.world)
    by = node.by or "color"
    home = next((k for k, group in enumerate(node.groups) if traits.of(group[0], by) == traits.of(name, by)), None)
    groups = (
        [*node.groups, (name,)]
        if home is None
        else [(*group, name) if k == home else group for k, group in enumerate(node.groups)]
    )
    draft.do(ChangeCondition(at=figure.path, to=node.model_copy(update={"groups": tuple(groups)})))


def _own_group(draft: Draft, names: Sequence[str], side: str, span: Span) -> None:
    """A group of their own, which nothing else belongs in; "group 3" is the third one."""
    figure = next((f for f in draft.view.figures if isinstance(f.node, GroupBy)), None)
    node = figure.node if figure is not None else None
    if figure is None or not isinstance(node, GroupBy):
        raise draft.refusal("no-such-object", "the task has no groups", span, "sort the blocks into groups first")
    if side not in ("group", f"group {len(node.groups) + 1}"):
        told = f"there are {len(node.groups)} groups, so that the next one is number {len(node.groups) + 1}"
        raise draft.refusal("edit-unclear", told, span, "say 'as another group'")
    traits = Traits(draft.view.world)
    values = {traits.of(name, node.by) for name in names} if node.by else set()
    others = {traits.of(group[0], node.by) for group in node.groups} if node.by else set()
    if len(values) > 1 or values & others:
        told = f"these blocks are no group of their own, as groups go by {node.by} here"
        raise draft.refusal("edit-unclear", told, span, f"add blocks of one new {node.by}")
    groups = (*node.groups, tuple(names))
    draft.do(ChangeCondition(at=figure.path, to=node.model_copy(update={"groups": groups})), span)


def put(
    draft: Draft, names: Sequence[str], place: r.Place, anchor: Found | None, span: Span, line: Line | None = None
) -> None:
    """Put blocks that have no duty yet at one place."""
    if isinstance(place, r.Spot) and anchor is not None and not anchor.whole:
        beside = m.Loc(rel=_RELATIONS.get(place.side, "beside"), landmark=place.whole, span=span)
        _at_landmark(draft, names, beside, anchor, span, line)
    elif isinstance(place, r.Spot):
        _at_spot(draft, names, place.side, anchor.line if anchor else line, anchor, span)
    elif isinstance(place, m.In):
        inside = InRegion.model_validate({"a": tuple(names), "region": place.region})
        draft.do(AddCondition(goal=Not(goal=inside) if place.negated else inside), span)
    elif isinstance(place, m.Loc):
        _at_landmark(draft, names, place, anchor, span, line)
    else:
        raise draft.refusal("edit-unclear", "this is no place for a block", span)


def there(draft: Draft, place: r.Place) -> r.Place:
    """The place that "there" means: the patch spoken of, else the only patch or region that the goal puts blocks in."""
    landmark = getattr(place, "landmark", None)
    if not isinstance(place, m.Loc) or not isinstance(landmark, m.Pronoun) or landmark.word != "there":
        return place
    patches = set(draft.view.world.patches)
    if draft.view.focus and draft.view.focus[-1] in patches:
        return place
    on = {atom.patch for _, atom in draft.view.atoms if isinstance(atom, OnPatch)}
    on |= {patch for _, atom in draft.view.atoms if (patch := getattr(atom, "patch", None)) is not None}
    regions = {atom.region for _, atom in draft.view.atoms if isinstance(atom, InRegion)}
    if len(on | regions) != 1:
        told, hint = "it is not settled which place this is", "name the place: on the red patch, in the left half"
        raise draft.refusal("ambiguous-object", told, place.span, hint)
    if regions:
        return m.In(region=regions.pop(), span=place.span)
    color = draft.view.world.patches[on.pop()].color
    return replace(place, landmark=m.Noun(head="patch", det="the", traits=m.Traits(colors=(color,)), span=place.span))


_ACROSS = {"tower": ("left", "right", "front", "back"), "row": ("front", "back"), "column": ("left", "right")}
"""Sides of a line that are no ends of it: what is put there is beside all of it."""


def _at_spot(
    draft: Draft, names: Sequence[str], side: str, line: Line | None, anchor: Found | None, span: Span
) -> None:
    """A place in a line: its ends, its middle, or beside it."""
    if side.startswith("group"):
        _own_group(draft, names, side, span)
        return
    if side == "any" and anchor is not None and anchor.figure is not None:
        join(draft, names, None, True, span)
        return
    if line is None:
        _beside_last(draft, names, side, anchor, span)
        return
    symbols = all(Traits(draft.view.world).symbol(name) for name in names)
    apart = isinstance(line.node, Spells | Equation) and not symbols and side in ("left", "right")
    if side == "beside" or side in _ACROSS[line.kind] or apart:
        rel = {"front": "front", "back": "behind"}.get(side, side)
        for name in names:
            draft.do(
                AddCondition(
                    goal=relation(
                        draft,
                        rel,
                        (name,),
                        Lowest(lowest=line.members) if line.kind == "tower" else line.members,
                        (),
                        span,
                    )
                ),
                span,
            )
        return
    if line.kind != "tower" and side in ("top", "bottom"):
        _beside_last(draft, names, side, anchor, span)
        return
    for name in names:
        now = _same(draft, line)
        at_end = side in ("top", "end", "any", "right", "back")
        index = len(now.members) if at_end else (len(now.members) + 1) // 2 if side == "middle" else 0
        insert(draft, now, index, name, span)
    if side in ("bottom", "middle") and line.kind == "tower":
        draft.aim("MODIFY")


def _beside_last(draft: Draft, names: Sequence[str], side: str, anchor: Found | None, span: Span) -> None:
    """A spot without a line: by the block mentioned last, or by the only figure."""
    figure = anchor.figure if anchor else draft.view.main_figure()
    if figure is not None and side == "top" and not isinstance(figure.node, GroupBy):
        _on_figure(draft, names, figure, span)
        return
    if figure is not None and side == "middle" and into_the_middle(draft, names, figure, span):
        return
    others = [n for n in (anchor.names if anchor else draft.view.busy) if n not in names]
    if len(others) != 1:
        raise draft.refusal(
            "ambiguous-object",
            "this could be by any of several blocks",
            span,
            "say by which one: on top of the red block",
        )
    if side not in _RELATIONS and side != "beside":
        raise draft.refusal("edit-unclear", f"there is no line that has such a place ({side})", span, "say beside what")
    rel = _RELATIONS.get(side, "beside")
    for name in names:
        draft.do(AddCondition(goal=relation(draft, rel, (name,), (others[0],), (), span)), span)
        others = [name]


def _on_figure(draft: Draft, names: Sequence[str], figure: Shape, span: Span) -> None:
    """On the tip of a pyramid; on any block of a figure that has none."""
    node = figure.node
    first = names[:1]
    if isinstance(node, Pyramid) and node.base[1] in (1, node.base[0]):
        draft.do(AddCondition(goal=On(a=tuple(first), b=Highest(highest=figure.members))), span)
    else:
        goal = Count(over=figure.members, at_least=1, goal=On(a=tuple(first), b=(EACH,)))
        draft.do(AddCondition(goal=goal), span)
    for lower, upper in pairwise(names):
        draft.do(AddCondition(goal=On(a=(upper,), b=(lower,))), span)


def _at_landmark(
    draft: Draft, names: Sequence[str], place: m.Loc, anchor: Found | None, span: Span, line: Line | None
) -> None:
    """A relation to something that is there."""
    if place.rel in ("after", "before"):
        _in_reading(draft, names, place, anchor, span)
        return
    if place.rel in ("left", "right") and anchor is not None and _continues_word(draft, names, anchor):
        _in_reading(draft, names, replace(place, rel={"left": "before", "right": "after"}[place.rel]), anchor, span)
        return
    if place.rel in ("left", "right") and anchor is not None and _among(draft, names, place, anchor, span):
        return
    if anchor is None:
        if isinstance(place.landmark, m.TableTop) and place.rel == "on":
            on_table = OnTable(a=tuple(names))
            draft.do(AddCondition(goal=Not(goal=on_table) if place.negated else on_table), span)
            return
        raise draft.refusal(
            "edit-unclear", "the request does not say next to what", span, "name a block: beside the red block"
        )
    if (
        not place.negated
        and (
            place.rel in ("on", "above", "under", "between", "sandwiched")
            or (anchor.line and place.rel in ("left", "right", "front", "behind"))
        )
        and _into_line(draft, names, place, anchor, span)
    ):
        return
    if place.rel == "on" and all(n in draft.view.world.patches for n in anchor.names):
        if len(anchor.names) > 1 and not place.negated:
            raise draft.refusal("ambiguous-object", "this could be any of several patches", span, "say which of them")
        for name in names:
            for patch in anchor.names:
                on = OnPatch(a=(name,), patch=patch)
                draft.do(AddCondition(goal=Not(goal=on) if place.negated else on), span)
        return
    if len(names) > 1 and len(anchor.names) > 1 and not anchor.whole and place.rel in ("on", "above", "under"):
        told, hint = "it is not said which goes on which", "say it of each: C on A and D on B"
        raise draft.refusal("edit-unclear", told, span, hint)
    operand = _operand(draft, anchor)
    for name in names:
        draft.do(AddCondition(goal=relation(draft, place.rel, (name,), operand, place.mods, span, place)), span)
        if place.rel == "on":
            operand = (name,)


def _among(draft: Draft, names: Sequence[str], place: m.Loc, anchor: Found, span: Span) -> bool:
    """Whether blocks go beside one of an ordered row that has a neighbour there: between the two, as nothing said is
    that they come after all others."""
    line = draft.view.line_of(anchor.names)
    if line is None or line.kind != "row" or not line.ordered or not isinstance(line.node, Row) or place.negated:
        return False
    at = line.members.index(anchor.names[0]) + (place.rel == "right")
    if len(anchor.names) != 1 or anchor.whole or not 0 < at < len(line.members):
        return False
    draft.aim("MODIFY")
    for offset, name in enumerate(names):
        insert(draft, _same(draft, line), at + offset, name, span)
    return True


def _continues_word(draft: Draft, names: Sequence[str], anchor: Found) -> bool:
    """Do symbols go beside a symbol of a word? They belong to the word then, for nothing else may adjoin it."""
    line = anchor.line or draft.view.line_of(anchor.names)
    traits = Traits(draft.view.world)
    return line is not None and isinstance(line.node, Spells) and all(traits.symbol(name) for name in names)


def _in_reading(draft: Draft, names: Sequence[str], place: m.Loc, anchor: Found | None, span: Span) -> None:
    """After a block, or before it, as a row is read; nothing else says which side that is."""
    line = anchor.line or draft.view.line_of(anchor.names) if anchor is not None else None
    if anchor is None or line is None or line.kind != "row" or not set(anchor.names) <= set(line.members):
        hint = "say on which side: to the right of it, on top of it"
        raise draft.refusal("edit-unclear", f"{place.rel!r} says no place here", span, hint)
    at = line.members.index(anchor.names[-1] if place.rel == "after" else anchor.names[0]) + (place.rel == "after")
    for offset, name in enumerate(names):
        insert(draft, _same(draft, line), at + offset, name, span)


def _operand(draft: Draft, anchor: Found) -> Operand:
    """A tower is stood beside by its foot; other structures by all of their blocks."""
    if anchor.line is not None and anchor.line.kind == "tower":
        return Lowest(lowest=anchor.line.members)
    return anchor.names


def _into_line(draft: Draft, names: Sequence[str], place: m.Loc, anchor: Found, span: Span) -> bool:
    """Whether the place is one in a line that the goal builds; the blocks are put there."""
    line = anchor.line or draft.view.line_of(anchor.names)
    if anchor.figure is not None and place.rel == "on":
        _at_spot(draft, names, "top", None, anchor, span)
        return True
    if line is None or not set(anchor.names) <= set(line.members):
        return False
    upright = line.kind == "tower"
    first = line.members.index(anchor.names[0])
    if place.rel in ("between", "sandwiched"):
        if len(anchor.names) != 2 or abs(first - line.members.index(anchor.names[1])) != 1:
            return False
        index = max(first, line.members.index(anchor.names[1]))
        draft.aim("MODIFY")
    elif upright and place.rel in ("on", "above"):
        index = len(line.members) if anchor.whole else first + 1
        if index < len(line.members):
            above = bare(line.members[index], draft.view.world)
            draft.assume(f"the {above} goes on top of what is added below it")
            draft.aim("MODIFY")
    elif upright and place.rel == "under":
        index = 0 if anchor.whole else first
        draft.aim("MODIFY")
    elif line.kind == "row" and place.rel in ("left", "right") and line.node is not None:
        index = (0 if place.rel == "left" else len(line.members)) if anchor.whole else first + (place.rel == "right")
    else:
        return False
    for offset, name in enumerate(names):
        insert(draft, _same(draft, line), index + offset, name, span)
    return True


def stand_on(draft: Draft, line: Line, patch: str, span: Span) -> None:
    """A line stands on a patch: a tower with its foot, a row with every block."""
    if line.kind == "tower":
        if isinstance(line.node, Stack):
            draft.do(SetField(at=line.path, field="patch", value=patch), span)
            return
        draft.do(AddCondition(goal=OnPatch(a=(line.members[0],), patch=patch)), span)
        return
    draft.do(AddCondition(goal=OnPatch(a=line.members, patch=patch)), span)
