"""Grids, walls, pyramids, staircases and figures."""

from __future__ import annotations

import math

from rpg.blocks.figures import FEWEST, pyramid_size, takes
from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.order import Order, Pattern
from rpg.passes.schema.lexicon import COLORS
from rpg.passes.schema.meaning import Absolute, At, Noun, Size, Structure
from rpg.passes.schema.meaning import Pattern as Said
from rpg.passes.schema.resolve.members import amount_of, members_of
from rpg.passes.schema.resolve.orders import order_of
from rpg.passes.schema.resolve.refer import refer
from rpg.passes.schema.resolve.spec import Spec
from rpg.passes.schema.resolve.world import Built, Ref, Scene, Scope, Thing, refuse

PALETTE = (*tuple(c for c in COLORS if c not in ("black", "white", "gray", "brown")), "brown", "white", "black", "gray")

Made = tuple[list[Built], list[g.Goal]]


def _size(shape: Structure) -> int | None:
    return shape.extent("size", "side", "steps", "high", "layers")


def _plain(shape: Structure) -> None:
    if shape.plural or (shape.amount and shape.amount.low > 1):
        raise refuse(
            "unsupported-structure",
            f"several {shape.kind}s at once are not understood",
            shape.span,
            f"name each {shape.kind} by itself: 'a {shape.kind} of ... and a {shape.kind} of ...'",
        )


def _made(kind: str, node: g.Goal, names: tuple[str, ...], span: Span, scene: Scene) -> Made:
    return [scene.add_built(kind, names, False, span)], [node]


def _count(shape: Structure, theme: Ref | None, scene: Scene) -> int | None:
    """The number of blocks, if it was said or is settled by the blocks named."""
    named = amount_of(shape.members)
    if named is None and theme is not None and not all(scene.things[n].elastic for n in theme.names):
        named = len(theme.names)
    return named or shape.extent("size")


def figure(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """Outlines, filled figures and letter shapes on the table."""
    _plain(shape)
    count = _count(shape, theme, scene)
    if shape.kind == "rectangle" and shape.dims and shape.filled is not False and not spec.patterns and not spec.orders:
        return _rectangle(shape, spec, theme, scene, scope)
    if shape.kind in ("square", "rectangle") and shape.filled is not False:
        square = (
            shape.kind == "square" and count is not None and count % 4 and math.isqrt(count) ** 2 == count and count > 1
        )
        if shape.dims or shape.filled or square or shape.extent("rows", "columns", "wide", "long", "deep"):
            return grid(shape, spec, theme, scene, scope)
    sides, need = _outline(shape, count)
    names = members_of(shape, spec, theme, need, FEWEST[shape.kind], scene, scope)
    least = 4 if shape.kind in ("square", "circle", "rectangle") else 3
    if len(names) < least:
        raise refuse(
            "too-few",
            f"{len(names)} blocks do not show a {shape.kind}",
            shape.span,
            f"use {FEWEST[shape.kind]}",
            blocks=len(names),
        )
    pointing = _pointing(shape.kind, spec)
    filled = bool(shape.filled) and shape.kind in ("triangle", "circle")
    pattern, readable = pattern_of(shape, spec, names, None, scene, scope)
    node = s.Figure(
        blocks=names, shape=shape.kind, filled=filled, sides=sides, pointing=pointing, pattern=pattern,
        readable=readable, span=shape.span  # type: ignore[arg-type]
    )  # fmt: skip
    return _made(shape.kind, _fitting(node, shape, scene), names, shape.span, scene)


def _fitting(node: s.Figure, shape: Structure, scene: Scene) -> s.Figure:
    """The figure, if its number of blocks makes one: filled, where they make no outline and nothing was said."""
    count = len(node.blocks)
    if takes(node, count):
        return node
    full = node.model_copy(update={"filled": True})
    if shape.kind == "triangle" and shape.filled is None and node.sides is None and takes(full, count):
        scene.assume(f"a triangle of {count} blocks is filled")
        return full
    near = sorted((n for n in range(3, 31) if takes(node, n)), key=lambda n: (abs(n - count), n))[:2]
    use = " or ".join(str(n) for n in sorted(near)) or "another number of blocks"
    raise refuse("count-mismatch", f"{count} blocks do not make a {shape.kind}", shape.span, f"use {use}", blocks=count)


def _rectangle(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "a 2x3 rectangle": filled, and turned in any way, for it has no rows that would lie along y."""
    sides = (shape.dims[0], shape.dims[1])
    need = sides[0] * sides[1]
    names = members_of(shape, spec, theme, need, need, scene, scope)
    node = s.Figure(blocks=names, shape="rectangle", filled=True, sides=sides, span=shape.span)
    return _made(shape.kind, node, names, shape.span, scene)


def _outline(shape: Structure, count: int | None) -> tuple[tuple[int, int] | None, int | None]:
    """The sides of an outline and the number of blocks on it, where they were said."""
    side = shape.extent("side")
    if shape.dims:
        return (shape.dims[0], shape.dims[1]), 2 * (shape.dims[0] + shape.dims[1]) - 4
    if side is not None and shape.kind == "square":
        return (side, side), 4 * side - 4
    if side is not None and shape.kind == "triangle":
        return (side, side), side * (side + 1) // 2 if shape.filled else 3 * side - 3
    if shape.kind == "square" and count is not None and count % 4:
        raise refuse(
            "count-mismatch",
            f"{count} blocks do not make the outline of a square",
            shape.span,
            f"use {count - count % 4} or {count + 4 - count % 4}",
            blocks=count,
        )
    return None, count if count is not None else None


_POINTERS = {"V": ("tip", "point", "apex", "corner", "base"), "triangle": ("tip", "point", "apex", "top"),
    "L": ("foot", "base"), "U": ("opening", "side", "end", "top"),
             "T": ("stem", "tail", "base")}  # fmt: skip


def _pointing(kind: str, spec: Spec) -> str | None:
    found = next((m for m in spec.manners if m.kind.startswith("pointing:") or m.kind == "facing"), None)
    if found is None:
        return None
    spec.manners.remove(found)
    word = found.kind.partition(":")[2]
    if (
        kind not in _POINTERS
        or (word and word not in _POINTERS[kind])
        or (not word and kind not in ("V", "triangle", "U"))
    ):
        raise refuse(
            "misplaced",
            f"this direction does not fit the shape {kind}",
            found.span,
            "say for example 'with its foot to the right'",
        )
    side = {"up": "back", "down": "front"}.get(str(found.value), str(found.value))
    if side not in ("left", "right", "front", "back"):
        raise refuse("misplaced", "a figure on the table points left, right, front or back", found.span)
    return side


def grid(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "3x3 square", "2 by 4 grid", "3x3x3 cube", "4x4 checkerboard"."""
    _plain(shape)
    rows, columns, layers = _dims(shape, spec, theme, scene)
    need = rows * columns * layers
    if shape.kind == "checkerboard":
        spec.patterns.append(Said(unit="checkerboard", span=shape.span))
    centre = next((a for a in spec.absolutes if isinstance(a.adjuncts[0], At) and a.adjuncts[0].side == "middle"), None)
    if centre is not None and layers == 1 and not spec.patterns and not spec.orders:
        return _centred(centre, shape, spec, theme, (rows, columns), scene, scope)
    names = members_of(shape, spec, theme, need, need, scene, scope)
    pattern, readable = pattern_of(shape, spec, names, (rows, columns, layers), scene, scope)
    node = s.Grid(
        blocks=names, rows=rows, columns=columns, layers=layers, pattern=pattern, readable=readable, span=shape.span
    )
    return _made("grid" if shape.kind == "checkerboard" else shape.kind, node, names, shape.span, scene)


def _centred(
    centre: Absolute, shape: Structure, spec: Spec, theme: Ref | None, dims: tuple[int, int], scene: Scene, scope: Scope
) -> Made:
    """ "a 3x3 square of red blocks with a blue one in the center"."""
    spec.absolutes.remove(centre)
    rows, columns = dims
    total = rows * columns
    if total % 2 == 0 or rows % 2 == 0:
        raise refuse(
            "misplaced",
            f"a {rows} by {columns} grid has no single middle cell",
            centre.span,
            "use odd numbers of rows and columns",
        )
    others = members_of(shape, spec, theme, total - 1, total - 1, scene, scope)
    if len({(t.color, t.label) for t in (scene.things[n] for n in others)}) > 1:
        raise refuse(
            "ambiguous",
            "it is not said how the other blocks are laid out",
            shape.span,
            "use blocks of one colour around it",
        )
    for name in others:
        scene.things[name].scheme = scene.things[name].scheme or "same"
    middle = refer(centre.theme, scene, Scope()).names
    if len(middle) != 1 or middle[0] in others:
        raise refuse(
            "misplaced", "one further block goes in the middle", centre.span, "name one block of another colour"
        )
    half = len(others) // 2
    order = Order(by="given", ranks=(others[:half], middle, others[half:]))
    node = s.Grid(
        blocks=(*others, *middle),
        rows=rows,
        columns=columns,
        pattern=Pattern(kind="reading", order=order),
        span=shape.span,
    )
    return _made(shape.kind, node, node.blocks, shape.span, scene)


def _dims(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene) -> tuple[int, int, int]:
    """Rows, columns and layers of a grid."""
    if len(shape.dims) == 3:
        return shape.dims[0], shape.dims[1], shape.dims[2]
    layers = shape.extent("layers", "high") or 1
    if len(shape.dims) == 2:
        return shape.dims[0], shape.dims[1], layers
    rows, columns = shape.extent("rows", "deep"), shape.extent("columns", "wide", "long")
    total = _count(shape, theme, scene)
    side = shape.extent("side")
    if side is not None:
        return side, side, side if shape.kind == "cube" else layers
    if rows and columns:
        return rows, columns, layers
    if total is not None and (rows or columns) and total % (rows or columns or 1) == 0:
        other = total // (rows or columns or 1)
        return (rows, other, layers) if rows else (other, columns or 1, layers)
    if total is None:
        if shape.kind == "cube":
            raise refuse(
                "ambiguous", "the size of the cube is not said", shape.span, "say '2x2x2 cube' or '3x3x3 cube'"
            )
        scene.assume("the size of the grid is not said: 3 by 3")
        return 3, 3, 1
    return _fill(shape, total, scene)


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
    if shape.kind in ("square", "checkerboard") and side * side != total:
        raise refuse(
            "count-mismatch",
            f"{total} blocks do not fill a square",
            shape.span,
            f"use {side * side} or {(side + 1) ** 2}",
            blocks=total,
        )
    rows = next(r for r in range(side, 0, -1) if total % r == 0)
    if rows == 1 and total > 3:
        raise refuse(
            "count-mismatch",
            f"{total} blocks do not fill a grid of several rows",
            shape.span,
            f"use {total + 1}",
            blocks=total,
        )
    scene.assume(f"the shape of the grid is not said: {rows} by {total // rows}")
    return rows, total // rows, 1


def wall(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "a wall of six blocks", "a wall three wide and two high": one row, several layers."""
    _plain(shape)
    columns, layers = shape.extent("wide", "long", "columns"), shape.extent("high", "layers", "rows")
    if len(shape.dims) >= 2:
        columns, layers = shape.dims[0], shape.dims[1]
        scene.assume(f"the wall is {columns} blocks wide and {layers} high")
    if not columns or not layers:
        total = _count(shape, theme, scene) or (2 * columns if columns else 3 * layers if layers else 6)
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
    names = members_of(shape, spec, theme, need, need, scene, scope)
    pattern, readable = pattern_of(shape, spec, names, (1, columns, layers), scene, scope)
    node = s.Grid(
        blocks=names, rows=1, columns=columns, layers=layers, pattern=pattern, readable=readable, span=shape.span
    )
    return _made("wall", node, names, shape.span, scene)


def pyramid(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "a pyramid with a 3x3 base", "a pyramid of six blocks"."""
    _plain(shape)
    base = _base(shape, spec, theme, scene)
    need = pyramid_size(base)
    names = members_of(shape, spec, theme, need, need, scene, scope)
    layers = min(base) if base[1] > 1 else base[0]
    pattern, readable = pattern_of(shape, spec, names, (base[1], base[0], layers), scene, scope)
    node = s.Pyramid(blocks=names, base=base, pattern=pattern, readable=readable, span=shape.span)
    return _made("pyramid", node, names, shape.span, scene)


def _base(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene) -> tuple[int, int]:
    """Blocks along the base, and its depth."""
    base = next((z for z in shape.sizes if z.what == "base" and z.dims), None)
    dims = shape.dims or (base.dims if base else ())
    if len(dims) >= 2:
        return dims[0], dims[1]
    layers = _layers(spec)
    total = _count(shape, theme, scene)
    size = shape.extent("base", "layers", "high") or (max(layers) if layers else None)
    if layers:
        total = sum(layers) if len(layers) > 1 else total
        square = sorted(layers, reverse=True) == [(n + 1) ** 2 for n in range(math.isqrt(max(layers)))][::-1]
        size = math.isqrt(max(layers)) if square and len(layers) > 1 else max(layers)
    options = [(n, 1) for n in range(2, 8)] + [(n, n) for n in range(2, 5)]
    if total is not None:
        fits = [
            b
            for b in options
            if pyramid_size(b) == total and (size is None or b[0] == size or (b[1] > 1 and b[0] * b[1] == size))
        ]
        if not fits:
            counts = sorted(pyramid_size(b) for b in options)
            near = sorted(counts, key=lambda c: (abs(c - total), c))[:2]
            raise refuse(
                "count-mismatch",
                f"{total} blocks do not make a pyramid",
                shape.span,
                f"use {near[0]} or {near[1]}",
                blocks=total,
            )
        scene.assume(f"the base of the pyramid is {fits[0][0]} by {fits[0][1]} blocks")
        return fits[0]
    if size is not None:
        if shape.traits.shape == "square":
            return size, size
        scene.assume(f"the pyramid is flat: {size} blocks in its base, one deep")
        return size, 1
    if shape.traits.shape == "square":
        scene.assume("the size of the pyramid is not said: a base of 3 by 3 blocks")
        return 3, 3
    scene.assume("the size of the pyramid is not said: a base of 3 blocks, one deep")
    return 3, 1


def _layers(spec: Spec) -> list[int]:
    """ "four blocks at the bottom and one on top": how many blocks each layer has."""
    found: list[int] = []
    for item in list(spec.absolutes):
        at_ = item.adjuncts[0]
        count = amount_of(item.theme)
        plain = isinstance(item.theme, Noun) and not item.theme.traits.colors and not item.theme.traits.labels
        if isinstance(at_, At) and at_.side in ("top", "bottom", "middle", "next") and count is not None and plain:
            found.append(count)
            spec.absolutes.remove(item)
    return found


def staircase(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "a staircase with four steps, going up to the left"."""
    if shape.plural and shape.amount and shape.amount.low > 1:
        shape = _steps(shape)
    steps = shape.extent("steps", "high", "layers")
    total = _count(shape, theme, scene)
    if steps is None and total is not None:
        steps = next((n for n in range(2, 8) if n * (n + 1) // 2 == total), None)
        if steps is None:
            raise refuse(
                "count-mismatch", f"{total} blocks do not make a staircase", shape.span, "use 3, 6 or 10", blocks=total
            )
    if steps is None:
        steps = 3
        scene.assume("the number of steps is not said: 3")
    up = None
    rising = spec.manner("rising")
    if rising is not None:
        up = str(rising.value)
    side = spec.first("left", "right", "front", "back")
    if side and up is None:
        up = {"left": "right", "right": "left", "front": "back", "back": "front"}[side]
        spec.toward = []
    need = steps * (steps + 1) // 2
    names = members_of(shape, spec, theme, need, need, scene, scope)
    pattern, readable = pattern_of(shape, spec, names, None, scene, scope)
    node = s.Staircase(blocks=names, steps=steps, up=up, pattern=pattern, readable=readable, span=shape.span)  # type: ignore[arg-type]
    return _made("staircase", node, names, shape.span, scene)


def _steps(shape: Structure) -> Structure:
    from dataclasses import replace

    steps = Size(what="steps", amount=shape.amount, span=shape.span)
    return replace(shape, sizes=(steps,), amount=None, plural=False)


def pattern_of(
    shape: Structure, spec: Spec, names: tuple[str, ...], dims: tuple[int, int, int] | None, scene: Scene, scope: Scope
) -> tuple[Pattern | None, bool]:
    """How the cells are coloured or labelled; colours and labels left open are chosen to fit."""
    things = [scene.things[n] for n in names]
    said = next(iter(spec.patterns), None)
    spec.patterns = spec.patterns[1:]
    if said is None:
        if any(t.kind for t in things) and not spec.orders:
            return None, False
        if not spec.orders:
            return None, False
        alternating = next((o for o in spec.orders if o.by == "alternating"), None)
        if alternating is not None and dims is not None:
            spec.orders.remove(alternating)
            return _painted("checkerboard", things, dims, scene), False
        order = order_of(spec, names, "row", scene, scope, shape.span).model_copy(update={"first": None})
        if order.by == "together":
            raise refuse(
                "ambiguous",
                "it is not said how the colours are to be laid out",
                shape.span,
                "say 'each row a different colour' or 'each layer a different colour'",
            )
        spec.orders = []
        return Pattern(
            kind="reading", order=Order(**{**order.model_dump()}), upward=spec.first("bottom") is not None
        ), order.by in ("label", "number")
    unit = {"pile": "row", "stack": "column"}.get(said.unit, said.unit)
    if dims is None:
        raise refuse("misplaced", f"a {shape.kind} has no {said.unit}s", said.span)
    return _painted(unit, things, dims, scene), False


def _painted(unit: str, things: list[Thing], dims: tuple[int, int, int], scene: Scene) -> Pattern:
    """Colours for a pattern where none were said."""
    if not any(t.color or t.label for t in things):
        lines = _lines(unit, len(things), dims)
        if len(lines) > len(PALETTE):
            raise refuse(
                "too-many-colors",
                f"this takes {len(lines)} colours, but there are {len(PALETTE)}",
                None,
                "use fewer rows",
                needed=len(lines),
                there=len(PALETTE),
            )
        at = 0
        for index, length in enumerate(lines):
            for thing in things[at : at + length]:
                thing.color = PALETTE[index]
            at += length
        scene.assume("the colours are not said: one for each " + ("of the two" if unit == "checkerboard" else unit))
    return Pattern(kind=unit)  # type: ignore[arg-type]


def _lines(unit: str, total: int, dims: tuple[int, int, int]) -> list[int]:
    """How many blocks each colour of a pattern has."""
    rows, columns, layers = dims
    if unit == "checkerboard":
        return [(total + 1) // 2, total // 2]
    if total != rows * columns * layers:
        sizes = [(max(1, rows - k), columns - k) for k in range(layers)]
        if unit == "layer":
            return [a * b for a, b in sizes]
        raise refuse("misplaced", "a pyramid is coloured by layer here", None, "say 'each layer a different colour'")
    if unit == "row":
        return [columns] * (rows * layers) if rows > 1 else [columns] * layers
    if unit == "column":
        return [rows] * (columns * layers) if rows > 1 else [layers] * columns
    return [rows * columns] * layers
