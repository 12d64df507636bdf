"""Figures whose parts tell their size: "a checkerboard, black in the corners", "a wall: bottom layer four grays"."""

from __future__ import annotations

from dataclasses import replace

from rpg.core.diagnostics import Span
from rpg.language.meaning import Absolute, Amount, At, Coord, Meaning, Noun, Places, Size, Structure, Traits, parts_of
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import refuse


def by_corners(shape: Structure, spec: Spec) -> Structure:
    """The board with so many blocks of each colour; with two odd sides its corners are all of one."""
    told = [*parts_of(shape.details), *spec.absolutes]
    parts = [x for x in told if isinstance(x, Absolute)]
    first = _colour(parts, "corners") if shape.kind == "checkerboard" and len(parts) == len(told) <= 2 else None
    dims = next((z.dims for z in (*shape.sizes, *spec.sizes) if z.dims), shape.dims)
    source = shape.members or (spec.usings[0].members if len(spec.usings) == 1 else None)
    among = _colours(source)
    if first is None or (source is not None and len(among) != 2) or len(dims) != 2:
        return shape
    named = [c for c in (*shape.traits.colors, *among) if c != first]
    second = _colour(parts, "rest") or (named[0] if len(named) == 1 else None)
    if second is None or second == first or len(parts) > (1 if named else 2):
        return shape
    if not dims[0] % 2 or not dims[1] % 2:
        raise refuse("contradiction", "the corners of such a board are of both colours", parts[0].span,
                     "leave the corners out, or name odd numbers of rows and columns")  # fmt: skip
    spec.absolutes, spec.usings = [], []
    members = one_more(first, second, dims[0] * dims[1], parts[0].span)
    return replace(shape, members=members, details=(), traits=replace(shape.traits, colors=()))


def one_more(first: str, second: str, cells: int, span: Span) -> Coord:
    """The blocks of a checkerboard of an odd number of cells, whose corners have the first colour."""
    most = (cells + 1) // 2
    items = tuple(
        Noun(head="block", amount=Amount(n, n), plural=n > 1, traits=Traits(colors=(color,)), span=span)
        for color, n in ((first, most), (second, cells - most))
    )
    return Coord(op="and", items=items, span=span)


def _colours(source: Meaning | None) -> tuple[str, ...]:
    """ "black and white cubes": the colours of blocks of which no more is said."""
    if isinstance(source, Coord):
        return tuple(color for item in source.items for color in _colours(item))
    plain = isinstance(source, Noun) and source.traits == Traits(colors=source.traits.colors)
    counted = not isinstance(source, Noun) or source.amount is not None or source.det not in ("bare", "a")
    return source.traits.colors if isinstance(source, Noun) and plain and not counted else ()


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


def _colour(parts: list[Absolute], side: str) -> str | None:
    """The colour of what stands at that part of the board."""
    found: list[str] = []
    for part in parts:
        place: Meaning = part.adjuncts[0]
        plain = isinstance(part.theme, Noun) and part.theme.traits == Traits(colors=part.theme.traits.colors)
        if isinstance(place, At) or not isinstance(place, Places) or place.side != side or not plain:
            continue
        found += part.theme.traits.colors if isinstance(part.theme, Noun) else ()
    return found[0] if len(found) == 1 else None
