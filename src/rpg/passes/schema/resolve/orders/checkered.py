"""Checkerboards whose two colours take turns, and those of which a cell is told, "black in the corners", "the far left
one white": it settles all the others."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from rpg.blocks.figures import Cell
from rpg.ir import structures as s
from rpg.ir.order import Pattern
from rpg.language.meaning import Meaning, Noun, Structure, Traits, replace
from rpg.language.meaning import Pattern as Said
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.parts import Claim, cells_of, claims, counted, laid
from rpg.passes.schema.resolve.things.things import bare_colors
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse


def taking_turns(spec: Spec) -> None:
    """ "A grid in which red and blue alternate": a checkerboard of these."""
    order = next((o for o in spec.orders if o.by == "alternating"), None)
    colors = tuple(color for item in order.items if (color := _color(item))) if order is not None else ()
    if order is not None and len(colors) == len(order.items) and len(colors) in (0, 2):
        spec.orders.remove(order)
        if not any(pattern.unit == "checkerboard" for pattern in spec.patterns):
            spec.patterns.append(Said(unit="checkerboard", span=order.span))
        if colors:
            spec.patterns = [replace(x, values=colors) if x.unit == "checkerboard" else x for x in spec.patterns]


def in_its_colors(shape: Structure, spec: Spec, theme: Ref | None) -> Structure:
    """ "Nine cubes as a checkerboard of black and white": the blocks are counted, and its cells take turns in these."""
    colors = bare_colors(shape.members) if shape.members is not None else shape.traits.colors
    if theme is None or len(colors) != 2 or len({*colors}) != 2 or any(pattern.values for pattern in spec.patterns):
        return shape
    spec.patterns = [replace(x, values=colors) if x.unit == "checkerboard" else x for x in spec.patterns]
    return replace(shape, members=None, traits=replace(shape.traits, colors=()))


def checkered(spec: Spec, node: s.Cells, names: tuple[str, ...], scene: Scene) -> Pattern | None:
    """The board whose cells have the colours that are told of some of them; None where that is no plain board."""
    if not any(pattern.unit == "checkerboard" for pattern in spec.patterns) or len(spec.patterns) > 1 or spec.orders:
        return None
    _painted(spec, node, names, scene)
    colors = Counter(scene.things[name].color for name in names if not scene.things[name].label)
    found = claims(spec, node, len(names), scene) if len(colors) == 2 and colors.total() == len(names) else []
    told = [_color(item.theme) for item, _, _ in found]
    if not found or None in told or not {*told} <= {*colors}:
        return None
    cells = cells_of(node, len(names))
    first = _first(found, told, cells, [color for color in colors if color])
    board = [color if _even(cell) else other for cell in cells for color, other in [first]]
    if Counter(board) != colors:
        counts = " and ".join(f"{board.count(color)} {color}" for color in first)
        raise refuse("contradiction", "of which colour there are more is told in two ways", found[0][0].span,
                     f"say {counts} blocks")  # fmt: skip
    spec.patterns = []
    spec.absolutes = [item for item in spec.absolutes if all(item is not told for told, _, _ in found)]
    if len({*colors.values()}) > 1:
        return Pattern(kind="checkerboard")
    stock = {color: [name for name in names if scene.things[name].color == color] for color in colors}
    return laid(node, tuple((stock[color].pop(0),) for color in board))


def _painted(spec: Spec, node: s.Cells, names: tuple[str, ...], scene: Scene) -> None:
    """Give blocks that were merely counted the two colours that are told with the pattern."""
    colors = spec.patterns[0].values
    things = [scene.things[name] for name in names]
    if len(colors) != 2:
        return
    if all(thing.color is None and thing.kind is None for thing in things):
        found = claims(spec, node, len(names), scene)
        told = [_color(item.theme) for item, _, _ in found]
        if told and {*told} <= {*colors}:
            colors = _first(found, told, cells_of(node, len(names)), [*colors])
        for index, thing in enumerate(things):
            thing.color = colors[index % 2]
    if {thing.color for thing in things} != {*colors}:
        raise refuse("contradiction", "the blocks have other colours", spec.patterns[0].span,
                     "name two colours that they have")  # fmt: skip


def _first(found: list[Claim], told: Sequence[str | None], cells: Sequence[Cell], colors: list[str]) -> tuple[str, str]:
    """The colour of the cells of the first parity, and that of the others."""
    first: set[str] = set()
    for (item, place, groups), color in zip(found, told, strict=True):
        counted(item.theme, groups, place)
        parities = {_even(cells[k]) for group in groups for k in group}
        if len(parities) > 1:
            raise refuse("contradiction", "on a checkerboard these places are of both colours", item.span,
                         "leave this out, or tell of one place")  # fmt: skip
        other = colors[1 - colors.index(color or "")]
        first.add((color or "") if parities == {True} else other)
    if len(first) > 1:
        raise refuse("contradiction", "on a checkerboard these places cannot have these colours",
                     found[-1][0].span, "tell of one place alone")  # fmt: skip
    (begin,) = first
    return begin, colors[1 - colors.index(begin)]


def _even(cell: Cell) -> bool:
    return (cell.row + cell.column + cell.level) % 2 == 0


def _color(theme: Meaning) -> str | None:
    """The colour of which no more is said."""
    plain = isinstance(theme, Noun) and len(theme.traits.colors) == 1
    bare = isinstance(theme, Noun) and theme.traits == Traits(colors=theme.traits.colors)
    return theme.traits.colors[0] if isinstance(theme, Noun) and plain and bare else None
