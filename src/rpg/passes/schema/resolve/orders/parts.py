"""Parts of structures: which places a phrase speaks of, and which blocks stand there."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.blocks.figure_parts import has_own
from rpg.blocks.figures import Cell, ideals, upright
from rpg.blocks.predicates.pattern import reading_order
from rpg.ir import structures as s
from rpg.ir.order import Order, Pattern
from rpg.language.meaning import Absolute, Amount, At, Coord, Meaning, Noun, Places, Pronoun, Structure, Traits, replace
from rpg.language.meaning import Pattern as Said
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.cells_in_order import in_one_run, runs
from rpg.passes.schema.resolve.orders.columns import columns_of
from rpg.passes.schema.resolve.orders.left_over import all_left, all_like_base, lines_left
from rpg.passes.schema.resolve.orders.of_figures import as_lines, half, of_figure
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import amount_of, matching
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse

Groups = list[list[int]]
"""Places by index, those of one unit together: a row, a corner, a layer."""
FIRST = {"row": ("back", "front"), "column": ("left", "right"), "layer": ("bottom", "top")}
SAME = {"top": "back", "bottom": "front"}
"""A grid on the table is seen like a page: its top row is the far one."""


def cells_of(node: s.Cells, count: int) -> tuple[Cell, ...]:
    """The places of a figure in the order in which it is read; in which it is drawn where its parts turn with it."""
    found = ideals(node, count)
    cells = found[0].cells if found else ()
    return cells if has_own(node) else tuple(cells[k] for k in reading_order(cells, False))


def laid(node: s.Cells, ranks: tuple[tuple[str, ...], ...]) -> Pattern:
    """The pattern in which blocks fill the places of a figure in the order of `cells_of`."""
    return Pattern(kind="reading", order=Order(by="given", ranks=ranks), own=has_own(node))


def place_of(item: Meaning) -> At | Places | None:
    """The part of which an absolute phrase speaks, if it speaks of one; "(two) at opposite ends": one at each."""
    place = item.adjuncts[0] if isinstance(item, Absolute) and len(item.adjuncts) == 1 else None
    if isinstance(place, At) and place.side == "ends":
        return Places(side="ends", unit="block", span=place.span)
    return place if isinstance(place, At | Places) else None


def groups_in(place: At | Places, node: s.Cells, cells: Sequence[Cell], scene: Scene) -> Groups:
    """The places of a figure that a part names, unit by unit; none where the figure has no such part."""
    part = place if isinstance(place, Places) else Places(side=place.side, unit="", index=place.index, span=place.span)
    height = 1 + max(cell.level for cell in cells)
    unit, side = part.unit or _line_at(part.side, node), part.side
    if has_own(node) and (own := of_figure(place, node, len(cells))):
        return own
    if unit == "row" and upright(node):
        unit = "layer"
        if side in ("first", "last"):
            raise refuse("ambiguous", "the rows of a wall are counted from the top or from below", place.span,
                         "say 'the top row' or 'the bottom row'")  # fmt: skip
    if (
        unit in ("", "block")
        and height > 1
        and side in ("top", "bottom", "middle")
        and not isinstance(node, s.Staircase)
    ):
        inner = side == "middle" and isinstance(place, At) and place.own and isinstance(node, s.Grid)
        if inner and not upright(node):
            raise refuse("ambiguous", "the middle layer, or the block in the middle?", place.span,
                         "say 'the middle row', or name the rows")  # fmt: skip
        unit = "block" if inner else "layer"
    if unit in FIRST:
        return _lines(part, unit, side, node, cells, height, scene)
    if side == "top" and isinstance(node, s.Staircase):
        return [[k for k, cell in enumerate(cells) if cell.level == height - 1]]
    if isinstance(node, s.Grid) and upright(node):
        cells = [cell._replace(row=height - 1 - cell.level, level=0) for cell in cells]
        height = 1
    if unit == "half" and isinstance(node, s.Grid):
        return half(side, cells)
    if height > 1 or not _square(node):
        return []
    rows, columns = 1 + max(c.row for c in cells), 1 + max(c.column for c in cells)
    if unit == "cell" and " " in side and isinstance(node, s.Grid):
        along, across = side.split()
        row = 0 if along in ("top", "back") else rows - 1
        column = 0 if across == "left" else columns - 1
        return [[k] for k, cell in enumerate(cells) if (cell.row, cell.column) == (row, column)]
    match side:
        case "corners":
            found = [k for k, c in enumerate(cells) if c.row in (0, rows - 1) and c.column in (0, columns - 1)]
        case "edge" | "outer":
            found = [k for k, c in enumerate(cells) if c.row in (0, rows - 1) or c.column in (0, columns - 1)]
        case "inner":
            found = [k for k, c in enumerate(cells) if 0 < c.row < rows - 1 and 0 < c.column < columns - 1]
        case "middle":
            found = [k for k, c in enumerate(cells) if (2 * c.row, 2 * c.column) == (rows - 1, columns - 1)]
        case _:
            return []
    if len(found) == len(cells) or part.several not in (None, len(found)):
        return []
    return [[k] for k in found]


def _line_at(side: str, node: s.Cells) -> str:
    """ "Red in front", "blue on the left": of a grid this is a row, or a column."""
    if not isinstance(node, s.Grid):
        return ""
    return "column" if side in ("left", "right") else "row" if side in ("front", "back") and not upright(node) else ""


def _square(node: s.Cells) -> bool:
    """Whether the corners and the middle of a flat figure are the same in every direction in which it may lie."""
    return isinstance(node, s.Grid) or (isinstance(node, s.Figure) and node.shape in ("square", "plus", "X"))


def _lines(
    part: Places, unit: str, side: str, node: s.Cells, cells: Sequence[Cell], height: int, scene: Scene
) -> Groups:
    """Rows, columns or layers."""
    if isinstance(node, s.Staircase) and unit == "column":
        return columns_of(part, node, cells)
    stepped = isinstance(node, s.Staircase | s.Figure)
    tapered = isinstance(node, s.Pyramid) and unit != "layer"
    if stepped or tapered or (unit == "layer" and height < 2) or (unit == "row" and height > 1):
        return []
    lines: dict[int, list[int]] = {}
    for k, cell in enumerate(cells):
        lines.setdefault({"row": cell.row, "column": cell.column, "layer": cell.level}[unit], []).append(k)
    ordered = [lines[n] for n in sorted(lines)]
    if part.of is not None and part.of != len(ordered):
        raise refuse("count-mismatch", f"there are {len(ordered)} {unit}s, but {part.of} are told", part.span,
                     f"say something of each {unit}", there=len(ordered), told=part.of)  # fmt: skip
    first, last = FIRST[unit]
    side = SAME.get(side, side) if unit == "row" else side
    if side in ("first", "last"):
        begin = {"row": "the far one", "column": "the left one", "layer": "the lowest one"}[unit]
        scene.assume(f"the first {unit} is {begin}")
    if part.several is not None and part.several > len(ordered):
        return []
    found = chosen(side, part.index, part.several, len(ordered), (first, last))
    return [ordered[k] for k in found]


def chosen(side: str, index: int | None, several: int | None, total: int, sides: tuple[str, str]) -> list[int]:
    """Which of `total` units in a row from the first of `sides` to the second are meant; none if there are none."""
    count = several or 1
    if side == sides[0]:
        side, index = "first", index or 1
    if side == "first":
        start = (index or 1) - 1
        return list(range(start, start + count)) if start + count <= total else []
    if side in ("last", sides[1]):
        start = total - (index or 1) + 1 - count
        return list(range(start, start + count)) if start >= 0 else []
    if side == "middle":
        start, odd = divmod(total - count, 2)
        return list(range(start, start + count)) if not odd and start > 0 else []
    if side in ("odd", "even") and index is None and several is None:
        return list(range(side == "even", total, 2))
    if side in ("ends", "outer"):
        return [0, total - 1] if several in (None, 2) and total > 2 else []
    if side == "inner":
        return list(range(1, total - 1)) if several in (None, total - 2) and total > 2 else []
    return []


def counted(theme: Meaning, groups: Groups, place: At | Places) -> Meaning:
    """What stands in a part, with as many blocks as it has places."""
    places = sum(map(len, groups))
    if isinstance(theme, Noun) and theme.det == "the" and theme.plural and place.side in ("odd", "even"):
        theme = replace(theme, det="bare")  # "the red ones at odd positions"
    if not isinstance(theme, Noun) or theme.det not in ("bare", "a", "all", "some"):
        return theme
    amount = amount_of(theme)
    each = getattr(place, "each", False) or getattr(place, "side", "") in ("ends", "outer", "corners")
    if theme.det == "a" or (amount == 1 and each):
        amount = len(groups) if each else 1
    elif amount is not None and each and (amount != places or getattr(place, "each", False)):
        amount *= len(groups)
    if amount is not None and amount != places:
        raise refuse(
            "count-mismatch", f"this part has {places} places, but {amount} blocks are named for it", theme.span,
            f"say {places}",
            places=places, named=amount,
        )  # fmt: skip
    return replace(theme, det="bare", amount=Amount(places, places), plural=places > 1)


def _counted(item: Absolute) -> bool:
    """ "a base of three blue blocks": a number is said with the looks."""
    return isinstance(item.theme, Noun) and item.theme.amount is not None


def _told(theme: Meaning) -> bool:
    """Whether it is said how the blocks of a part look, and not only how many there are."""
    if isinstance(theme, Noun):
        return replace(theme.traits, kind=None) != Traits() or theme.det not in ("bare", "a")
    return not (isinstance(theme, Pronoun) and theme.word == "one")


Claim = tuple[Absolute, At | Places, Groups]


def claims(spec: Spec, node: s.Cells, count: int, scene: Scene) -> list[Claim]:
    """The parts of a figure that its description speaks of, "the rest" last; they are not taken out of `spec`."""
    cells = cells_of(node, count)
    found: list[Claim] = []
    rest: list[tuple[Absolute, Places]] = []
    from_below = _counted_from(spec, node)
    for item in spec.absolutes:
        place = place_of(item)
        if place is None or not cells:
            continue
        place = as_lines(place, spec.absolutes, node)
        if from_below and isinstance(place, Places) and (place.unit, place.side) == ("row", "first"):
            place = replace(place, unit="layer", side="first" if from_below == "bottom" else "last")
        if isinstance(place, Places) and place.side == "rest":
            rest.append((item, place))
            continue
        if isinstance(place, At) and place.side == "middle" and isinstance(item.theme, Noun) and _one(item.theme):
            place = replace(place, own=True)
        groups = groups_in(place, node, cells, scene)
        single = isinstance(place, At) and isinstance(item.theme, Noun) and _one(item.theme)
        if isinstance(place, At) and (not groups or (single and len(groups[0]) > 1)):
            if _line_at(place.side, node):
                raise refuse("ambiguous", "several blocks are at this side", item.span, "say in which corner, or row")
            continue
        if not groups:
            raise refuse("misplaced", "the structure has no such part", place.span, "name one of its rows or layers")
        found += [(item, place, groups)] if not in_turn(item) else _cell_by_cell(item, place, groups)
    _which_way(found, node)
    for item, place in rest:
        taken = {k for _, _, groups in found for group in groups for k in group}
        left = [k for k in range(count) if k not in taken]
        if not left or len(rest) > 1:
            raise refuse("misplaced", "nothing is left for this", place.span, "leave it out")
        if not taken:
            raise refuse("misplaced", "it is not said of which other part this is the rest", place.span, "say it")
        all_left(place, [cells[k].level for k in left], [cells[k].level for k in taken])
        lines_left(place, [cells[k] for k in left], [cells[k] for k in taken], upright(node))
        found.append((item, place, [left]))
    return found


def _one(theme: Noun) -> bool:
    """ "a red one", "A": one block."""
    return theme.det == "a" or (len(theme.traits.labels) == 1 and theme.amount is None and not theme.plural)


def _counted_from(spec: Spec, node: s.Cells) -> str:
    """ "the bottom row red, the second row white": from which end the rows of a wall are counted, where one is told."""
    first = place_of(spec.absolutes[0]) if spec.absolutes else None
    ends = first is not None and first.side in ("top", "bottom") and getattr(first, "unit", "row") == "row"
    return first.side if ends and first is not None and upright(node) else ""


def in_turn(item: Absolute) -> bool:
    """ "far row: red, white, red": its blocks one by one."""
    return isinstance(item.theme, Coord) and item.theme.op == "then" and place_of(item) is not None


def _cell_by_cell(item: Absolute, place: At | Places, groups: Groups) -> list[Claim]:
    """Each block of a row at its place, from left to right."""
    items = item.theme.items if isinstance(item.theme, Coord) else ()
    if len(groups) != 1 or getattr(place, "unit", "") not in ("row", "layer"):
        raise refuse("ambiguous", "it is not clear which block is where in this part", item.span, "tell it by rows")
    if len(groups[0]) != len(items):
        raise refuse("count-mismatch", f"this part has {len(groups[0])} places, but {len(items)} blocks are named",
                     item.span, f"name {len(groups[0])}", places=len(groups[0]), named=len(items))  # fmt: skip
    return [(replace(item, theme=one), place, [[k]]) for one, k in zip(items, groups[0], strict=True)]


def _which_way(found: list[Claim], node: s.Cells) -> None:
    """ "a 3x2 grid, the top row red and the bottom row blue" could have two rows as well as three."""
    if not isinstance(node, s.Grid) or node.rows == node.columns or node.layers > 1 or node.rows == 1:
        return
    for unit, there, other in (("row", node.rows, node.columns), ("column", node.columns, node.rows)):
        said = sum({id(p): len(groups) for _, p, groups in found if getattr(p, "unit", "") == unit}.values())
        if said == other != there:
            place = found[0][1]
            raise refuse("ambiguous", f"it is not clear whether there are {there} {unit}s or {other}", place.span,
                         f"say 'with {other} {unit}s and {there} in each'")  # fmt: skip


def widened(shape: Structure, spec: Spec, theme: Ref | None, node: s.Cells, count: int, scene: Scene) -> Structure:
    """ "a grid of red blocks with blue corners": so many red ones as the corners leave, and the blue ones."""
    found = claims(spec, node, count, scene)
    source = shape.members
    if not found or theme is not None or (source is not None and not isinstance(source, Noun)):
        return shape
    colors = source.traits.colors if source is not None else shape.traits.colors
    own = replace(source.traits if source is not None else shape.traits, colors=())
    more = [
        (counted(item.theme, groups, place), sum(map(len, groups)))
        for item, place, groups in found
        if _told(item.theme)
    ]
    other = [t for t, _ in more if isinstance(t, Noun) and not set(t.traits.colors) <= set(colors)]
    if not colors or not other:
        return shape
    left = count - sum(n for t, n in more if t in other)
    amount = amount_of(source)
    if left < 1:
        raise refuse("misplaced", f"its parts leave no place for blocks that are {colors[0]}", shape.span,
                     "say of each part which blocks stand there")  # fmt: skip
    if len(colors) > 1 or (amount is not None and amount != left):
        raise refuse(
            "count-mismatch", f"{count} blocks make this, of which {left} are {colors[0]}", shape.span,
            f"say {left} {colors[0]} blocks",
            blocks=count, left=left,
        )  # fmt: skip
    rest = Noun(head="block", amount=Amount(left, left), plural=left > 1, traits=replace(own, colors=colors),
                span=shape.span)  # fmt: skip
    members = Coord(op="and", items=(rest, *other), span=shape.span)
    return replace(shape, members=members, traits=replace(shape.traits, colors=()))


def parted(spec: Spec, node: s.Cells, names: tuple[str, ...], scene: Scene, scope: Scope) -> Pattern | None:
    """The pattern that the parts of a figure make together, if any are spoken of."""
    found = claims(spec, node, len(names), scene)
    if not found:
        return None
    held: dict[int, str] = {}
    mixed: dict[int, int] = {}
    spec.absolutes = [item for item in spec.absolutes if not in_turn(item)]
    for item, place, groups in found:
        if item in spec.absolutes:
            spec.absolutes.remove(item)
        if not _told(item.theme):
            counted(item.theme, groups, place)
            kind = getattr(getattr(item.theme, "traits", None), "kind", None)
            if kind and any(scene.things[n].kind not in (kind, "symbol") for n in names):
                raise refuse("ambiguous", "it is not said what these blocks look like", item.span, "name the blocks")
            continue
        places = [k for group in groups for k in group]
        blocks = standing(item, place, groups, tuple(n for n in names if n not in held.values()), scene)
        if len(blocks) != len(places) or set(blocks) & set(held.values()) or set(places) & set(held):
            raise refuse("contradiction", "two different blocks are given the same place", item.span,
                         "give each part one colour")  # fmt: skip
        for thing in (scene.things[n] for n in blocks if len(places) > 1):  # else their colours would tell an order
            thing.scheme = thing.scheme or (None if thing.color or thing.label or thing.kind else "same")
        held.update(zip(places, blocks, strict=True))
        mixed.update(dict.fromkeys(places, len(held)) if len({scene.things[n].color for n in blocks}) > 1 else {})
    if not held:
        return None
    if isinstance(node, s.Pyramid) and len(found) == 1 and len(held) > 1 and _counted(found[0][0]):
        all_like_base(found[0][0], found[0][1], held.values(), names, scene)
        return None
    if len(held) == len(names):
        spec.patterns = [p for p in spec.patterns if not _said_twice(p, found, held, node, scene)]
    if spec.orders or spec.patterns:
        raise refuse("order-conflict", "the blocks are laid out in two ways", found[0][0].span, "keep one of them")
    ranks = runs(held, mixed, names, scene, found[0][0])
    if len(ranks) == 1:
        return None
    return laid(node, ranks)


def _said_twice(pattern: Said, found: list[Claim], held: dict[int, str], node: s.Cells, scene: Scene) -> bool:
    """ "each row of one colour: the first red, the second blue": the parts say what the pattern says, and more."""
    units = {getattr(place, "unit", "") or _line_at(place.side, node) or "layer" for _, place, _ in found}
    colors = [scene.things[held[groups[0][0]]].color for _, _, groups in found]
    apart = not pattern.different or len(set(colors)) == len(colors)
    return units <= {pattern.unit, "layer" if pattern.unit == "row" else pattern.unit} and apart


def standing(
    item: Absolute, place: At | Places, groups: Groups, names: tuple[str, ...], scene: Scene
) -> tuple[str, ...]:
    """The blocks among `names` that are said to stand in a part."""
    theme = counted(item.theme, groups, place)
    if inside := so_many(theme, names, scene):
        return inside
    ref = refer(theme, scene, Scope(pool=names))
    scene.mentions.pop()
    several = len({scene.things[n].color for n in ref.names}) > 1
    if ref.op != "and" or ref.quant is not None or (several and not in_one_run(groups)):
        raise refuse("ambiguous", "it is not clear which block is where in this part", item.span, "use one colour")
    if several and len(ref.names) != len(groups[0]):
        raise refuse("count-mismatch", f"this part has {len(groups[0])} places, but {len(ref.names)} blocks are named",
                     item.span, f"name {len(groups[0])}", places=len(groups[0]), named=len(ref.names))  # fmt: skip
    if not set(ref.names) <= set(names):
        raise refuse("misplaced", "these are none of the structure's blocks", item.span, "name them among its blocks")
    return ref.names


def so_many(theme: Meaning, names: tuple[str, ...], scene: Scene) -> tuple[str, ...]:
    """ "two red ones", "a red one": as many of `names` as look like this; none where there are not so many."""
    count = amount_of(theme)
    if not isinstance(theme, Noun) or theme.det not in ("bare", "a") or count is None or len(theme.traits.colors) > 1:
        return ()
    alike = {t.name for t in matching(theme.traits, scene, False)}
    inside = tuple(n for n in names if n in alike)
    looks = {(t.color, t.label, t.size) for t in (scene.things[n] for n in inside)}
    if len(inside) > count and len(looks) > 1 and theme.traits != Traits():
        raise refuse("ambiguous", f"{len(inside)} of these blocks are such", theme.span, "name the block")
    return inside[:count] if len(inside) >= count and theme.traits != Traits() else ()
