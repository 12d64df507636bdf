"""Grids, squares, cubes and walls."""

from __future__ import annotations

import math

from rpg.ir import structures as s
from rpg.language.meaning import Amount, Coord, Meaning, Noun, Places, Size, Structure, Traits, replace
from rpg.language.meaning import Pattern as Said
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.checkered import in_its_colors, taking_turns
from rpg.passes.schema.resolve.orders.parts import place_of, widened
from rpg.passes.schema.resolve.structures.boards import one_more
from rpg.passes.schema.resolve.structures.extents import Made, made, plain, said_count, used_count
from rpg.passes.schema.resolve.structures.patterns import pattern_of
from rpg.passes.schema.resolve.things.members import members_of
from rpg.passes.schema.resolve.things.things import bare_colors, plain_colors
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def grid(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "3x3 square", "2 by 4 grid", "3x3x3 cube", "4x4 checkerboard"."""
    plain(shape)
    shape = _of_lines(shape, spec)
    rows, columns, layers = _dims(shape, spec, theme, scene)
    need = rows * columns * layers
    for said in [p for p in spec.patterns if p.unit == "diagonal"]:
        if (rows, columns, layers) != (2, 2, 1):
            raise refuse("misplaced", "which cells are diagonal to each other is told of a 2x2 grid alone", said.span,
                         "say 'a checkerboard', or name the rows")  # fmt: skip
        spec.patterns[spec.patterns.index(said)] = replace(said, unit="checkerboard")
    taking_turns(spec)
    if shape.kind == "checkerboard":
        spec.patterns.append(Said(unit="checkerboard", span=shape.span))
    if any(p.unit == "checkerboard" for p in spec.patterns):
        bare = theme is None and not spec.usings
        shape = _colors_told(shape, spec) if bare else in_its_colors(shape, spec, theme)
        shape = _cornered(shape, spec, rows * columns if rows % 2 and columns % 2 else 0)
    elif any(p.values for p in spec.patterns) and theme is None:
        shape = _colors_told(shape, spec)
    form = s.Grid(blocks=("",), rows=rows, columns=columns, layers=layers)
    shape = widened(shape, spec, theme, form, need, scene)
    names = members_of(shape, spec, theme, need, need, scene, scope)
    pattern, readable = pattern_of(shape, spec, names, (rows, columns, layers), scene, scope, form)
    node = s.Grid(
        blocks=names, rows=rows, columns=columns, layers=layers, pattern=pattern, readable=readable, span=shape.span
    )
    return made("grid" if shape.kind == "checkerboard" else shape.kind, node, names, shape.span, scene)


def _of_lines(shape: Structure, spec: Spec) -> Structure:
    """ "a grid, one colour per row: red, white, blue" has three rows, where nothing else is said of them."""
    told = {place.unit: place.of for item in spec.absolutes if isinstance(place := place_of(item), Places) and place.of}
    told |= {pattern.unit: len(pattern.values) for pattern in spec.patterns if pattern.values}
    for unit, whats in (("row", ("rows", "deep")), ("column", ("columns", "wide", "long"))):
        if told.get(unit) and not shape.dims and shape.extent(*whats, "side") is None:
            amount = Amount(told[unit] or 0, told[unit])
            shape = replace(shape, sizes=(*shape.sizes, Size(what=whats[0], amount=amount, span=shape.span)))
    uncounted = shape.members is None or (isinstance(shape.members, Noun) and shape.members.amount is None)
    if uncounted and not shape.dims and not shape.sizes:
        shape = replace(shape, sizes=_sides_told(shape, spec))
    return shape


_ENDS = (("row", "columns", {"front", "back"}), ("column", "rows", {"left", "right"}))


def _sides_told(shape: Structure, spec: Spec) -> tuple[Size, ...]:
    """ "A B C in the far row, D E F in the near row": two rows of three, for every line is told with its blocks."""
    places = [(item.theme, place) for item in spec.absolutes if isinstance(place := place_of(item), Places)]
    for unit, across, ends in _ENDS:
        told = {place.side: _many(theme) for theme, place in places if place.unit == unit and not place.several}
        if len(told) == len(places) and set(told) in (ends, ends | {"middle"}) and len(set(told.values())) == 1:
            sides = {f"{unit}s": len(told), across: max(told.values())}
            if min(sides.values()) < 2:
                continue
            return tuple(Size(what=what, amount=Amount(n, n), span=shape.span) for what, n in sides.items())
    return ()


def _many(told: Meaning) -> int:
    """How many blocks a description or a list of them is of."""
    if isinstance(told, Coord):
        return sum(_many(item) for item in told.items)
    if not isinstance(told, Noun):
        return 1
    return told.amount.low if told.amount else max(1, len(told.traits.colors), len(told.traits.labels))


def _colors_told(shape: Structure, spec: Spec) -> Structure:
    """ "a checkerboard, red and white", "each row in one colour: red, white, in any order": colours, and no order."""
    said = next((pattern.values for pattern in spec.patterns if pattern.values), ())
    if said and shape.members is None:
        items = tuple(Noun(head="any", traits=Traits(colors=(color,)), span=shape.span) for color in said)
        return replace(shape, members=Coord(op="and", items=items, span=shape.span))
    for order in [o for o in spec.orders if len(o.items) == 2 and o.by in _PAIRED and not o.first]:
        if shape.members is None and all(len(plain_colors(item)) == 1 for item in order.items):
            spec.orders.remove(order)
            return replace(shape, members=Coord(op="and", items=order.items, span=order.span))
    return shape


_PAIRED = ("named", "given", "alternating")
"""How two colours may be told of a board."""


def _cornered(shape: Structure, spec: Spec, odd: int) -> Structure:
    """ "a 3x3 checkerboard of black and white, black in the corners": there is one more black one than white ones."""
    corners = [x for x in spec.absolutes if (place := place_of(x)) is not None and place.side == "corners"]
    colors = bare_colors(shape.members) if shape.members is not None else shape.traits.colors
    theme = corners[0].theme if len(corners) == 1 else None
    first = theme.traits.colors if isinstance(theme, Noun) else ()
    if not odd or len(colors) != 2 or len(first) != 1 or first[0] not in colors:
        return shape
    spec.absolutes.remove(corners[0])
    other = colors[1 - colors.index(first[0])]
    return replace(shape, members=one_more(first[0], other, odd, shape.span), traits=replace(shape.traits, colors=()))


def _dims(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene) -> tuple[int, int, int]:
    """Rows, columns and layers of a grid."""
    _said_once(shape)
    if len(shape.dims) == 3:
        return shape.dims[0], shape.dims[1], shape.dims[2]
    layers = shape.extent("layers", "high") or 1
    if len(shape.dims) == 2:
        return shape.dims[0], shape.dims[1], layers
    rows, columns = shape.extent("rows", "deep"), shape.extent("columns", "wide", "long")
    total = said_count(shape, theme, scene) or used_count(spec)
    if not (rows and columns) and total in _counted_lines(spec):
        raise refuse("ambiguous", f"only one side of the {shape.kind} is said", shape.span,
                     "say how many rows and how many columns")  # fmt: skip
    side = shape.extent("side") or (_only_side(shape) if shape.kind == "square" else None)
    if side is not None:
        return side, side, side if shape.kind == "cube" else layers
    _one_side_each(shape, rows, columns, total)
    if rows and columns:
        return rows, columns, layers
    if total is not None and (rows or columns) and total % (rows or columns or 1) == 0:
        other = total // (rows or columns or 1)
        return (rows, other, layers) if rows else (other, columns or 1, layers)
    if total is not None and (rows or columns):
        lines = f"{rows} rows" if rows else f"{columns} columns"
        raise refuse("count-mismatch", f"{total} blocks do not fill {lines}", shape.span,
                     "say how many blocks each of them has", blocks=total)  # fmt: skip
    if total is None:
        if shape.kind == "cube":
            raise refuse(
                "ambiguous", "the size of the cube is not said", shape.span, "say '2x2x2 cube' or '3x3x3 cube'"
            )
        scene.assume("the size of the grid is not said: 3 by 3")
        return 3, 3, 1
    return _fill(shape, total, scene)


def _counted_lines(spec: Spec) -> set[int | None]:
    """ "A grid with three rows: red, blue and green": three are its rows, and not its blocks."""
    told = [place for item in spec.absolutes for place in item.adjuncts if isinstance(place, Places)]
    return {place.of for place in told if place.unit in ("row", "column")} - {None}


def _said_once(shape: Structure) -> None:
    """Refuse a second size that is another one: "a 2x2x2 cube, three layers of 2x2"."""
    for size in shape.sizes:
        again = size.dims if size.what == "dims" else None
        if size.what in ("layers", "high") and len(shape.dims) == 3:
            again = (*shape.dims[:2], size.amount.low if size.amount else 0)
        if again is not None and again[: len(shape.dims)] != shape.dims[: len(again)]:
            raise refuse("contradiction", "two sizes are given", size.span, "keep one of them")


def _only_side(shape: Structure) -> int | None:
    """ "a square three blocks wide": all its sides."""
    said = {shape.extent(what) for what in (*_ACROSS, *_ALONG)} - {None}
    return said.pop() if len(said) == 1 else None


_ACROSS, _ALONG = ("columns", "wide", "long"), ("rows", "deep")


def _one_side_each(shape: Structure, rows: int | None, columns: int | None, total: int | None) -> None:
    """Refuse a side that is said twice ("4 wide and 2 long"), and one side where the other is open ("2 rows")."""
    across = [size for size in shape.sizes if size.what in _ACROSS]
    along = [size for size in shape.sizes if size.what in _ALONG]
    for twice in (across, along):
        if len(twice) > 1:
            raise refuse("ambiguous", "it is not clear which of these are rows", twice[1].span,
                         "say how many rows and how many columns")  # fmt: skip
    if shape.kind == "square" and rows and columns and rows != columns:
        raise refuse("contradiction", "the sides of a square are equal", shape.span, "say 'a rectangle'")
    sizes = [size for size in shape.sizes if size.what not in ("size", "dims")]
    if sizes and not (rows and columns) and (total is None or not (rows or columns)):
        raise refuse("ambiguous", f"only one side of the {shape.kind} is said", sizes[0].span,
                     "say how many rows and how many columns")  # fmt: skip


def _fill(shape: Structure, total: int, scene: Scene) -> tuple[int, int, int]:
    """The squarest grid of `total` blocks."""
    if shape.kind == "cube":
        edge = round(total ** (1 / 3))
        if edge**3 != total:
            raise refuse(
                "count-mismatch", f"{total} blocks do not fill a cube", shape.span, "use 8 or 27", blocks=total
            )
        return edge, edge, edge
    side = math.isqrt(total)
    if shape.kind == "square" and side * side != total:
        raise refuse(
            "count-mismatch",
            f"{total} blocks do not fill a square",
            shape.span,
            f"use {side * side} or {(side + 1) ** 2}",
            blocks=total,
        )
    rows = next(r for r in range(side, 0, -1) if total % r == 0)
    if rows == 1 and (total > 3 or shape.kind == "checkerboard"):
        raise refuse(
            "count-mismatch",
            f"{total} blocks do not fill a grid of several rows",
            shape.span,
            f"use {total + 1}",
            blocks=total,
        )
    scene.assume(f"the shape of the grid is not said: {rows} by {total // rows}")
    return rows, total // rows, 1


def _one_thick(shape: Structure) -> tuple[int, int]:
    """How wide and how high "a 4x1x3 wall" is.

    Raises:
        Refusal: it would be thicker than one block.
    """
    wide, *others = shape.dims
    others = [side for side in others if side > 1] if len(others) > 1 else others
    if len(others) != 1:
        raise refuse("misplaced", "a wall is one block thick here", shape.span, "say 'a cuboid', or two of its sides")
    return wide, others[0]


def wall(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "a wall of six blocks", "a wall three wide and two high": one row, several layers."""
    plain(shape)
    columns, layers = shape.extent("wide", "long", "columns"), shape.extent("high", "layers", "rows")
    if len(shape.dims) >= 2:
        columns, layers = _one_thick(shape)
        ends = {getattr(x.adjuncts[0], "side", "") for x in spec.absolutes if len(x.adjuncts) == 1}
        if len(spec.absolutes) == columns == 2 < layers and ends == {"bottom", "top"}:
            raise refuse("ambiguous", f"{columns} layers are told of, but the wall would be {layers} high", shape.span,
                         f"say '{layers} blocks wide and {columns} high', or tell of all layers")  # fmt: skip
        scene.assume(f"the wall is {columns} blocks wide and {layers} high")
    if not columns or not layers:
        total = said_count(shape, theme, scene) or (2 * columns if columns else 3 * layers if layers else 6)
        layers = layers or (total // columns if columns else next((n for n in (2, 3) if total % n == 0), 1))
        columns = columns or total // layers
        if layers < 2 or columns * layers != total:
            raise refuse(
                "count-mismatch",
                f"{total} blocks do not fill a wall of several layers",
                shape.span,
                f"use {total + 1}",
                blocks=total,
            )
        scene.assume(f"the wall is {columns} blocks wide and {layers} high")
    need = columns * layers
    if any(p.unit == "checkerboard" or p.values for p in spec.patterns):
        shape = _colors_told(shape, spec)
    form = s.Grid(blocks=("",), rows=1, columns=columns, layers=layers)
    shape = widened(shape, spec, theme, form, need, scene)
    names = members_of(shape, spec, theme, need, need, scene, scope)
    pattern, readable = pattern_of(shape, spec, names, (1, columns, layers), scene, scope, form)
    node = s.Grid(
        blocks=names, rows=1, columns=columns, layers=layers, pattern=pattern, readable=readable, span=shape.span
    )
    return made("wall", node, names, shape.span, scene)
