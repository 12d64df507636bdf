"""How the blocks at a place of a figure look: its layers, rows and columns, its corners, its edge, its middle; and
those at a place of a line: its ends, its middle, the second from the left."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby

from rpg.blocks.figures import Cell, ideals, upright
from rpg.blocks.predicates.pattern import reading_order
from rpg.core.diagnostics import Refusal
from rpg.ir.assets import Asset, Block, SemanticCube
from rpg.ir.edits import RemoveAsset, SetField
from rpg.ir.order import Order, Pattern
from rpg.ir.structures import Cells, Figure, Grid, Pyramid, Staircase
from rpg.steer.draft import Draft
from rpg.steer.operations.exchange import exchange
from rpg.steer.operations.guard import check_new
from rpg.steer.operations.lines import pin
from rpg.steer.operations.make import describe
from rpg.steer.requests.language import m
from rpg.steer.requests.parts import PLACE, DropPart, Part
from rpg.steer.view import BEGINS, ENDS, Shape

_FIRST = {"row": ("back", "front"), "column": ("left", "right"), "layer": ("bottom", "top")}
_ALIAS = {"top": "back", "bottom": "front"}
"""A grid on the table is seen like a page: its top row is the far one."""


def part(draft: Draft, request: Part) -> None:
    """Blocks at a place get another look; what stands elsewhere stays where it is."""
    check_new(request.look)
    figure = _figure(draft)
    if figure is None:
        _restyled(draft, _in_line(draft, request), request)
        return
    node = figure.node
    assert isinstance(node, Cells)
    places = _places(node, request.place, len(figure.members))
    if not places:
        told, hint = "the structure has no such part", "name one of its layers, rows or corners, or its middle"
        raise draft.refusal("no-such-object", told, request.place.span, hint)
    standing = _standing(draft, figure, node, request)
    names = _restyled(draft, [standing[k] for k in places], request)
    members = [names.get(name, name) for name in standing]
    looks = draft.view.world.look
    ranks = tuple(tuple(run) for _, run in groupby(members, key=lambda name: looks[name]))
    pattern = Pattern(kind="reading", order=Order(by="given", ranks=ranks)) if len(ranks) > 1 else None
    draft.do(SetField(at=figure.path, field="pattern", value=pattern and pattern.model_dump()), request.span)


def _restyled(draft: Draft, chosen: Sequence[str], request: Part) -> dict[str, str]:
    """Give blocks the look that the request names. Old name -> new name."""
    amount = request.look.amount
    if amount is not None and amount.low != len(chosen) and not (amount.low == 1 and request.look.det == "a"):
        told = f"this part has {len(chosen)} places, not {amount.low}"
        raise draft.refusal("count-mismatch", told, request.look.span, f"say {len(chosen)}")
    new: dict[str, Asset] = {}
    for name, block in zip(chosen, describe(draft, request.look.traits, len(chosen)), strict=True):
        new[name] = block.model_copy(update={"name": name, "size": draft.view.world.edge[name]})
    if not request.look.traits.labels:
        labels = {name: draft.view.world.blocks[name] for name in chosen}
        new = {n: _coloured(labels[n], block) for n, block in new.items()}
    draft.aim("MODIFY" if request.look.traits.labels else "TWEAK")
    draft.note("part", {"blocks": list(chosen)})
    names = exchange(draft, new, request.span)
    draft.look_at(tuple(names.values()))
    return names


def _coloured(old: Block, new: Asset) -> Asset:
    """A cube with a symbol keeps it where only a colour was said."""
    return old.model_copy(update={"color": new.color}) if isinstance(old, SemanticCube) else new


def drop_part(draft: Draft, request: DropPart) -> None:
    """Blocks at a place of a line leave the task; the line closes up."""
    names = _in_line(draft, request)
    if (line := draft.view.line_of(names)) is not None and len(line.members) - len(names) < 2:
        raise draft.refusal("breaks-structure", f"a {line.kind} needs at least two blocks", request.span, "leave two")
    draft.aim("MODIFY")
    draft.note("remove", names)
    for name in names:
        draft.do(RemoveAsset(name=name), request.span)
    draft.look_at(tuple(name for name in draft.focus if name not in names))


def _in_line(draft: Draft, request: Part | DropPart) -> list[str]:
    """The blocks at a place of the tower or the row that was spoken of last."""
    line, place = draft.view.main_line(), request.place
    if line is None or not line.ordered:
        raise draft.refusal(
            "edit-unclear", "it is not settled which block this is", place.span, "name its colour or letter"
        )
    total = len(line.members)
    several = place.several if isinstance(place, m.Places) else None
    if isinstance(place, m.Places) and place.unit not in ("block", "layer", "cell", ""):
        raise draft.refusal("no-such-object", f"a {line.kind} has no {place.unit}s", place.span, "name its ends")
    begin = BEGINS[line.kind]
    number, index = several or 1, (place.index or 1) - 1
    inside = {
        begin: range(index, index + number), "first": range(index, index + number),
        ENDS[begin]: range(total - index - number, total - index),
        "last": range(total - index - number, total - index),
        "ends": (0, total - 1), "outer": (0, total - 1), "inner": range(1, total - 1),
        "middle": range((total - number) // 2, (total + number) // 2) if (total - number) % 2 == 0 else (),
    }.get(place.side, ())  # fmt: skip
    found = [line.members[k] for k in inside if 0 <= k < total]
    if not found or len(found) != len(inside):
        told, hint = f"a {line.kind} of {total} has no such place", f"say {begin}, {ENDS[begin]}, or a number"
        raise draft.refusal("no-such-object", told, place.span, hint)
    pin(draft, found, request.span)
    return found


def _figure(draft: Draft) -> Shape | None:
    """The figure that was spoken of last; none where that was a line, or where there is none."""
    shapes = [shape for shape in draft.view.figures if isinstance(shape.node, Cells)]
    recent = [shape for shape in shapes if set(shape.members) & set(draft.view.focus)]
    line = draft.view.main_line()
    if not shapes or (not recent and line is not None and set(line.members) & set(draft.view.focus)):
        return None
    return (recent or shapes)[-1]


def _standing(draft: Draft, figure: Shape, node: Cells, request: Part) -> list[str]:
    """The block of each place as the figure is read; look-alikes stand anywhere among themselves."""
    looks = {draft.view.world.look[name] for name in figure.members}
    pattern = node.pattern
    if len(looks) == 1:
        return list(figure.members)
    if pattern is not None and pattern.kind == "reading" and not pattern.upward and pattern.order.by == "given":
        ranks = pattern.order.ranks
        alike = all(len({draft.view.world.look[name] for name in rank}) == 1 for rank in ranks)
        if alike and sum(map(len, ranks)) == len(figure.members):
            told = [name for rank in ranks for name in rank]
            return [told[k] for k in _as_read(node, len(told))] if pattern.own else told
    free = "the places of these blocks in the structure are free, so that it is not settled which one this is"
    raise _unsettled(draft, free, request)


def _as_read(node: Cells, count: int) -> list[int]:
    """The places of a figure by index, in the order in which it is read."""
    found = ideals(node, count)
    return reading_order(found[0].cells, False) if found else []


def _unsettled(draft: Draft, told: str, request: Part) -> Refusal:
    return draft.refusal("edit-unclear", told, request.span, "say the whole structure with the colours of its parts")


def _places(node: Cells, place: PLACE, count: int) -> list[int]:
    """The places that a part names, by their index as the figure is read; none where the figure has no such part."""
    found = ideals(node, count)
    if not found:
        return []
    cells = [found[0].cells[k] for k in _as_read(node, count)]
    height = 1 + max(cell.level for cell in cells)
    unit, side = (place.unit, place.side) if isinstance(place, m.Places) else ("block", place.side)
    index, several = place.index, place.several if isinstance(place, m.Places) else None
    if unit == "row" and upright(node):
        unit = "layer"
    if unit == "block" and height > 1 and side in ("top", "bottom") and not isinstance(node, Staircase):
        unit = "layer"
    if unit in _FIRST:
        return _line(node, cells, height, (unit, side, index, several))
    if height > 1 and not (isinstance(node, Grid) and upright(node)):
        return []
    if height > 1:
        cells = [cell._replace(row=height - 1 - cell.level, level=0) for cell in cells]
    if unit == "cell" and isinstance(node, Grid):
        return _cell(cells, side)
    return _spots(node, cells, side, several) if unit == "block" else []


def _cell(cells: Sequence[Cell], side: str) -> list[int]:
    """The corner that two sides name: "top left"."""
    along, across = side.split()
    rows, columns = 1 + max(c.row for c in cells), 1 + max(c.column for c in cells)
    corner = (0 if along in ("top", "back") else rows - 1, 0 if across == "left" else columns - 1)
    return [k for k, cell in enumerate(cells) if (cell.row, cell.column) == corner]


def _spots(node: Cells, cells: Sequence[Cell], side: str, several: int | None) -> list[int]:
    """Corners, edge, inside and middle of a flat figure that has them in whichever direction it lies."""
    if not (isinstance(node, Grid) or (isinstance(node, Figure) and node.shape in ("square", "plus", "X"))):
        return []
    rows, columns = 1 + max(c.row for c in cells), 1 + max(c.column for c in cells)
    found = [k for k, cell in enumerate(cells) if _is_at(cell, {"outer": "edge"}.get(side, side), rows, columns)]
    return found if len(found) < len(cells) and several in (None, len(found)) else []


def _is_at(cell: Cell, side: str, rows: int, columns: int) -> bool:
    ends = cell.row in (0, rows - 1), cell.column in (0, columns - 1)
    match side:
        case "corners":
            return all(ends)
        case "edge":
            return any(ends)
        case "inner":
            return not any(ends)
        case "middle":
            return (2 * cell.row, 2 * cell.column) == (rows - 1, columns - 1)
    return False


def _line(node: Cells, cells: Sequence[Cell], height: int, part: tuple[str, str, int | None, int | None]) -> list[int]:
    """The places of a row, a column or a layer, or of several."""
    unit, side, index, several = part
    if isinstance(node, Figure) or (isinstance(node, Pyramid | Staircase) and unit != "layer"):
        return []
    if (unit == "layer" and height < 2) or (unit == "row" and height > 1):
        return []
    lines: dict[int, list[int]] = {}
    for k, cell in enumerate(cells):
        lines.setdefault({"row": cell.row, "column": cell.column, "layer": cell.level}[unit], []).append(k)
    ordered = [lines[n] for n in sorted(lines)]
    first, last = _FIRST[unit]
    side = _ALIAS.get(side, side) if unit == "row" else side
    total, number = len(ordered), several or 1
    ranges = {
        first: range(number), "first": range((index or 1) - 1, (index or 1) - 1 + number),
        last: range(total - number, total), "last": range(total - number, total),
        "ends": (0, total - 1), "outer": (0, total - 1), "inner": range(1, total - 1),
        "middle": range((total - number) // 2, (total + number) // 2) if (total - number) % 2 == 0 < total - number
        else range(0),
    }  # fmt: skip
    wanted = list(ranges.get(side, ()))
    if unit == "layer" and side in ("first", "last") and isinstance(node, Pyramid | Grid):
        wanted = wanted if side == "last" or index is not None else []
    inside = bool(wanted) and min(wanted) >= 0 and max(wanted) < total
    return sorted(k for n in wanted for k in ordered[n]) if inside else []
