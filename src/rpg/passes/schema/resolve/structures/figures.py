"""Grids, walls, pyramids, staircases and figures."""

from __future__ import annotations

import math
from typing import Any

from rpg.blocks.figures import FEWEST, NATURAL, takes
from rpg.ir import structures as s
from rpg.language.meaning import Absolute, At, Manner, Noun, Structure, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.agreeing import OPPOSITE
from rpg.passes.schema.resolve.orders.parts import place_of, widened
from rpg.passes.schema.resolve.structures.extents import Made, made, plain, said_count, used_count
from rpg.passes.schema.resolve.structures.grids import grid
from rpg.passes.schema.resolve.structures.hubs import hub_of, with_hub
from rpg.passes.schema.resolve.structures.limbs import limbs_of
from rpg.passes.schema.resolve.structures.measured import with_length
from rpg.passes.schema.resolve.structures.patterns import pattern_of
from rpg.passes.schema.resolve.things.members import members_of
from rpg.passes.schema.resolve.things.things import amount_of
from rpg.passes.schema.resolve.things.world import Ref, Scene, Scope, refuse


def check_built(shape: Structure) -> None:
    """Refuse a mere square, circle or rectangle that nothing says is built of blocks: it is a patch, if anything."""
    said = shape.members or shape.sizes or shape.dims or shape.details or shape.letter or shape.plural
    alone = shape.amount is None or shape.amount.low == 1
    if shape.kind in ("square", "circle", "rectangle") and alone and not said and shape.filled is None:
        hint = f"say of which blocks the {shape.kind} is built, or 'the {shape.kind} patch'"
        raise refuse("no-referent", f"nothing says that this {shape.kind} is built of blocks", shape.span, hint)


def _bare(shape: Structure) -> bool:
    """ "a black square": nothing but a look is said of it."""
    return not (shape.members or shape.sizes or shape.dims or shape.letter) and shape.filled is None


def figure(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """Outlines, filled figures and letter shapes on the table."""
    plain(shape)
    shape = with_length(_wide_and_long(shape), spec)
    if shape.kind == "square" and theme is None and _bare(shape) and any(b.kind == "grid" for b in scene.built):
        raise refuse("ambiguous", "this could be a place of the grid, or a figure of its own", shape.span,
                     "say 'the block', or of how many blocks the square is built")  # fmt: skip
    count = _with_centre(shape, spec, said_count(shape, theme, scene))
    hub = hub_of(shape, spec, theme, scene) if not shape.filled else None
    if hub is not None:
        spec.absolutes.remove(hub)
    turned = not spec.patterns and not spec.orders and not any(map(_of_lines, spec.absolutes))
    if shape.kind == "rectangle" and shape.dims and shape.filled is not False and turned:
        return _rectangle(shape, spec, theme, scene, scope)
    if shape.kind in ("square", "rectangle") and shape.filled is not False and hub is None:
        turns = any(p.unit in ("checkerboard", "diagonal") for p in spec.patterns)
        even = count is not None and count > 1 and math.isqrt(count) ** 2 == count
        square = shape.kind == "square" and even and (turns or (count or 0) % 4)
        if shape.dims or shape.filled or square or shape.extent("rows", "columns", "wide", "long", "deep"):
            return grid(shape, spec, theme, scene, scope)
    if count is None and spec.usings and shape.kind in ("T", "L", "U", "plus"):
        count = amount_of(spec.usings[0].members) or used_count(spec)
    sides, need = _outline(shape, count)
    pointing = _pointing(shape, spec)
    if shape.kind == "U" and pointing in ("left", "right") and sides is not None and sides[0] != sides[1]:
        raise refuse("ambiguous", "it is not clear what of it is wide and what is deep", shape.span,
                     "say of how many blocks it is")  # fmt: skip
    filled = bool(shape.filled) and shape.kind in ("triangle", "circle")
    said: dict[str, Any] = {"shape": shape.kind, "pointing": pointing}
    form = s.Figure(blocks=("",), filled=filled, sides=sides, **said)
    size = need or count or FEWEST[shape.kind]
    if need is None and count is None and hub is None and any(place_of(a) is not None for a in spec.absolutes):
        need = size
    shape = widened(shape, spec, theme, form, size, scene)
    names = members_of(shape, spec, theme, need, FEWEST[shape.kind], scene, scope)
    if hub is not None:
        return with_hub(names, hub, shape, spec, scene)
    least = 4 if shape.kind in ("square", "circle", "rectangle") else 3
    if len(names) < least:
        raise refuse(
            "too-few",
            f"{len(names)} blocks do not show a {shape.kind}",
            shape.span,
            f"use {FEWEST[shape.kind]}",
            blocks=len(names),
        )
    if (corners := shape.extent("corners")) is not None and corners != len(names):
        raise refuse("count-mismatch", f"{len(names)} blocks, and {corners} corners", shape.span, f"use {corners}")
    pattern, readable = pattern_of(shape, spec, names, None, scene, scope, form)
    node = s.Figure(
        blocks=names, filled=filled, sides=sides, pattern=pattern, readable=readable, span=shape.span, **said
    )
    return made(shape.kind, _fitting(node, shape, scene), names, shape.span, scene)


def _with_centre(shape: Structure, spec: Spec, count: int | None) -> int | None:
    """ "a plus of four white blocks with a red one at its centre": of five, for four have no centre."""
    source = shape.members
    if shape.kind not in ("plus", "X") or not count or count % 4 or not isinstance(source, Noun):
        return count
    parts = [(x.theme, place_of(x)) for x in spec.absolutes]
    told = [theme for theme, at in parts if isinstance(at, At) and (at.side, at.index) == ("middle", None)]
    further = [x for x in told if isinstance(x, Noun) and x.det == "a" and x.traits.colors]
    own = source.traits.colors
    return count + 1 if own and len(further) == len(told) == 1 and further[0].traits.colors != own else count


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


def _wide_and_long(shape: Structure) -> Structure:
    """ "A rectangle two wide and three long" has these two sides; which way its length goes is not said."""
    wide, long_ = shape.extent("wide"), shape.extent("long")
    sides = [size for size in shape.sizes if size.what in ("wide", "long", "deep", "rows", "columns")]
    if shape.kind != "rectangle" or shape.dims or not wide or not long_ or len(sides) != 2:
        return shape
    rest = tuple(size for size in shape.sizes if size not in sides)
    return replace(shape, dims=(wide, long_), sizes=rest)


def _of_lines(item: Absolute) -> bool:
    """ "The front row yellow": what has rows lies as a grid does."""
    return getattr(place_of(item), "unit", "") in ("row", "column")


def _rectangle(shape: Structure, spec: Spec, theme: Ref | None, scene: Scene, scope: Scope) -> Made:
    """ "a 2x3 rectangle": filled, and turned in any way, for it has no rows that would lie along y."""
    sides = (shape.dims[0], shape.dims[1])
    need = sides[0] * sides[1]
    names = members_of(shape, spec, theme, need, need, scene, scope)
    node = s.Figure(blocks=names, shape="rectangle", filled=True, sides=sides, span=shape.span)
    return made(shape.kind, node, names, shape.span, scene)


def _outline(shape: Structure, count: int | None) -> tuple[tuple[int, int] | None, int | None]:
    """The sides of an outline and the number of blocks on it, where they were said."""
    if shape.kind in ("T", "L", "U", "plus"):
        return limbs_of(shape, count)
    if shape.kind == "triangle":
        return _of_triangle(shape, count)
    side = shape.extent("side")
    deep, wide, long = (shape.extent(*said) for said in (("rows", "deep"), ("wide", "columns"), ("long",)))
    dims = shape.dims or tuple(n for n in (deep, wide, long) if n is not None)
    if len(dims) == 1 and count is not None and count > 2 * dims[0] and not count % 2:
        dims = (dims[0], count // 2 + 2 - dims[0])
    if len(dims) == 1 and shape.kind == "rectangle":
        raise refuse("ambiguous", "a rectangle has two sides", shape.span, "say for example '4 wide and 3 deep'")
    if shape.kind == "square" and len(set(dims)) == 2:
        raise refuse("contradiction", "the sides of a square are of one length", shape.span, "say 'rectangle'")
    dims = dims * 2 if len(dims) == 1 and shape.kind == "square" else dims
    if len(dims) == 2:
        return (dims[0], dims[1]), 2 * (dims[0] + dims[1]) - 4
    if side is not None and shape.kind == "square":
        return (side, side), 4 * side - 4
    if shape.kind == "square" and count is not None and count % 4:
        raise refuse(
            "count-mismatch",
            f"{count} blocks do not make the outline of a square",
            shape.span,
            f"use {count - count % 4} or {count + 4 - count % 4}",
            blocks=count,
        )
    return None, count if count is not None else None


def _of_triangle(shape: Structure, count: int | None) -> tuple[tuple[int, int] | None, int | None]:
    """A triangle by its sides or its base; by its rows, of which every one is told of where it is filled."""
    rows = shape.extent("rows")
    side = shape.extent("side", "base") or rows
    if rows is not None and rows > 3 and not shape.filled:
        raise refuse("ambiguous", "this triangle could be filled, or an outline", shape.span, "say 'a filled triangle'")
    if side is None:
        return None, count
    return (side, side), side * (side + 1) // 2 if shape.filled else 3 * side - 3


_POINTERS = {
    "V": {"tip", "point", "apex", "corner", "base"}, "triangle": {"tip", "point", "apex", "top"}, "L": {"foot", "base"},
    "U": {"opening", "mouth", "side", "end", "top"}, "T": {"stem", "tail", "base", "foot", "leg"},
}  # fmt: skip
_LETTERS = frozenset({"T", "L", "U", "V"})
"""What stands upright for who looks at it."""
_AWAY_FROM_THEM = {"T": {"bar", "top"}, "V": {"opening", "mouth", "ends", "side", "end"}, "U": {"base"}}
"""What lies at the other end of the figure."""


def _pointing(shape: Structure, spec: Spec) -> str | None:
    """Where the figure points, as each of its parts that are told of has it."""
    kind = shape.kind
    told = [m for m in spec.manners if m.kind.startswith("pointing:") or m.kind == "facing"]
    upright = kind in _POINTERS and any((m.kind, m.value) == ("turn", 0.0) for m in spec.manners)
    over = kind in _POINTERS and kind != "L" and any((m.kind, m.value) == ("turn", 180.0) for m in spec.manners)
    upright = upright or (kind in _LETTERS and spec.viewed and not over)
    turns = (*((("turn", 0.0),) if upright else ()), *((("turn", 180.0),) if over else ()))
    used = [*told, *(m for m in spec.manners if (m.kind, m.value) in turns)]
    spec.manners = [m for m in spec.manners if m not in used]
    sides = {_side(kind, m) for m in told if m.kind != "pointing:long"}
    sides |= {NATURAL.get(kind, "front")} if upright and not told else set()
    sides |= {OPPOSITE[NATURAL.get(kind, "front")]} if over else set()
    for long in (m for m in told if m.kind == "pointing:long"):
        if kind != "L" or not sides or sides - {"left", "right"}:
            raise refuse("misplaced", "this does not tell how the figure lies", long.span,
                         "say for example 'with its foot to the right'")  # fmt: skip
    if len(sides) > 1:
        raise refuse("contradiction", "its parts cannot point so at once", told[-1].span, "say where one of them is")
    return next(iter(sides), None)


def _side(kind: str, told: Manner) -> str:
    """Where a figure points one of whose parts points or lies so."""
    word = told.kind.partition(":")[2]
    turned = word in _AWAY_FROM_THEM.get(kind, ())
    if not turned and word not in _POINTERS.get(kind, ()) and (word or kind not in ("V", "triangle", "U")):
        raise refuse("misplaced", f"this direction does not fit the shape {kind}", told.span,
                     "say for example 'with its foot to the right'")  # fmt: skip
    side = {"up": "back", "down": "front", "viewer": "front"}.get(str(told.value), str(told.value))
    if side not in OPPOSITE:
        raise refuse("misplaced", "a figure on the table points left, right, front or back", told.span)
    return OPPOSITE[side] if turned else side
