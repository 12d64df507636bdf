"""Figures whose parts tell their size: "a checkerboard, black in the corners", "a wall: bottom layer four grays"."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.language.meaning import (
    Absolute,
    Amount,
    At,
    Coord,
    Meaning,
    Noun,
    Places,
    Size,
    Structure,
    Traits,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import refuse


def by_corners(shape: Structure, spec: Spec) -> Structure:
    """The board with so many blocks of each colour; with two odd sides its corners are all of one."""
    told = [x for detail in shape.details for x in getattr(detail, "items", (detail,))] + [*spec.absolutes]
    parts = [x for x in told if isinstance(x, Absolute)]
    dims = next((z.dims for z in (*shape.sizes, *spec.sizes) if z.dims), shape.dims)
    if shape.kind != "checkerboard" or not parts or len(parts) < len(told) or len(dims) != 2:
        return shape
    source = shape.members or (spec.usings[0].members if len(spec.usings) == 1 else None)
    among = _colours(source)
    if source is not None and len(among) != 2:
        return shape
    found = [_cell(part, dims) for part in parts]
    first = {color for color, even in (x for x in found if x) if even}
    second = {color for color, even in (x for x in found if x) if not even}
    if not first:
        first = {*shape.traits.colors, *among} - second
    second = second or {*shape.traits.colors, *among} - first
    others = {*shape.traits.colors, *among} - first - second
    if None in found or len(first) != 1 or len(second) != 1 or first == second or others:
        return shape
    if not dims[0] % 2 or not dims[1] % 2:
        raise refuse("contradiction", "the corners of such a board are of both colours", parts[0].span,
                     "leave the corners out, or name odd numbers of rows and columns")  # fmt: skip
    members = one_more(first.pop(), second.pop(), dims[0] * dims[1], parts[0].span)
    counts = {x.traits.colors: x.amount for x in members.items if isinstance(x, Noun)}
    if any(x.amount and counts.get(x.traits.colors) != x.amount for x in parts_of(source) if isinstance(x, Noun)):
        return shape
    spec.absolutes, spec.usings = [], []
    return replace(shape, members=members, details=(), traits=replace(shape.traits, colors=()))


def _cell(part: Absolute, dims: tuple[int, ...]) -> tuple[str, bool] | None:
    """The colour told of a part of the board, and whether it is that of the corners."""
    theme, place = part.theme, part.adjuncts[0]
    if not isinstance(theme, Noun) or theme.traits != Traits(colors=theme.traits.colors[:1]):
        return None
    if isinstance(place, Places) and place.side in _MANY and theme.amount in (None, _MANY[place.side]):
        return theme.traits.colors[0], place.side == "corners"
    middle = isinstance(place, At) and place.side == "middle" and place.index is None and all(n % 2 for n in dims)
    alone = middle and theme.amount in (None, Amount(1, 1))
    return (theme.traits.colors[0], sum(n // 2 for n in dims) % 2 == 0) if alone else None


_MANY = {"corners": Amount(4, 4), "rest": None}
"""How many blocks are at these parts of a board."""


def one_more(first: str, second: str, cells: int, span: Span) -> Coord:
    """The blocks of a checkerboard of an odd number of cells, whose corners have the first colour."""
    most = (cells + 1) // 2
    items = tuple(
        Noun(head="block", amount=Amount(n, n), plural=n > 1, traits=Traits(colors=(color,)), span=span)
        for color, n in ((first, most), (second, cells - most))
    )
    return Coord(op="and", items=items, span=span)


def _colours(source: Meaning | None) -> tuple[str, ...]:
    """ "black and white cubes", "five red and four white ones": the colours of blocks of which no more is said."""
    if isinstance(source, Coord):
        return tuple(color for item in source.items for color in _colours(item))
    plain = isinstance(source, Noun) and source.traits == Traits(colors=source.traits.colors)
    new = isinstance(source, Noun) and source.det in ("bare", "a")
    return source.traits.colors if isinstance(source, Noun) and plain and new else ()


_ALL_LAYERS = ({"bottom", "top"}, {"bottom", "middle", "top"})


def by_layers(shape: Structure, spec: Spec) -> Structure:
    """A wall of which each layer is told has as many layers, and is as long as each of them."""
    told = [*parts_of(shape.details), *spec.absolutes]
    parts = [x for x in told if isinstance(x, Absolute)]
    high = [*shape.sizes, *spec.sizes]
    high = [z for z in high if z.what not in ("layers", "high") or z.amount != Amount(len(parts), len(parts))]
    bare = not (shape.members or high or shape.dims or shape.plural) and shape.traits == Traits()
    if shape.kind != "wall" or not bare or len(parts) < max(2, len(told)):
        return shape
    places = [x.adjuncts[0] for x in parts]
    themes = [x.theme for x in parts]
    layers = [x for x in places if isinstance(x, Places) and x.unit in ("layer", "row")]
    amounts = {x.amount for x in themes if isinstance(x, Noun) and x.amount and x.amount.low == x.amount.high}
    if len(layers) < len(parts) or len(amounts) != 1 or any(getattr(x, "amount", None) is None for x in themes):
        return shape
    ordered = [x.index for x in layers] == [*range(1, len(layers) + 1)] and {x.side for x in layers} == {"first"}
    if not ordered and ({x.side for x in layers} not in _ALL_LAYERS or len(layers) != len({x.side for x in layers})):
        return shape
    many = Amount(len(layers), len(layers))
    long = Size(what="columns", amount=amounts.pop(), span=shape.span)
    sizes = (Size(what="layers", amount=many, span=shape.span), long)
    spec.sizes = []
    return replace(shape, sizes=sizes)
