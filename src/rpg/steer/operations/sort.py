"""What sorting compares, and patterns of colours in figures."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.blocks.predicates.order import sort_key
from rpg.blocks.traits import Traits
from rpg.core.diagnostics import Span
from rpg.ir.assets import Asset, ColoredCube
from rpg.ir.edits import SetField
from rpg.ir.order import Order, Pattern
from rpg.ir.structures import Cells, Grid, Pyramid
from rpg.steer.draft import Draft
from rpg.steer.operations.exchange import exchange
from rpg.steer.operations.make import PALETTE
from rpg.steer.view import Shape

BY = {
    "label": "label",
    "number": "number",
    "rainbow": "rainbow",
    "size": "size",
    "alternating": "alternating",
    "mirrored": "mirrored",
}
_CLASSES = {
    "even_first": ("parity", "even"),
    "odd_first": ("parity", "odd"),
    "vowel_first": ("vowel", "vowel"),
    "consonant_first": ("vowel", "consonant"),
}


def sorted_members(draft: Draft, members: Sequence[str], by: str, descending: bool) -> list[str]:
    """`members` in the order that `by` gives; equal ones stay as they are."""
    order = Order.model_validate({"by": by})
    traits = Traits(draft.view.world)
    keys = {name: sort_key(order, name, traits) for name in members}
    known = [name for name in members if keys[name] is not None]
    known.sort(key=lambda name: keys[name], reverse=descending)  # type: ignore[arg-type, return-value]
    return [*known, *(name for name in members if keys[name] is None)]


def ranks_by_class(draft: Draft, members: Sequence[str], how: str) -> tuple[tuple[str, ...], ...]:
    """Two ranks: the members of the class that comes first, then the others."""
    attribute, value = _CLASSES[how]
    traits = Traits(draft.view.world)
    first = tuple(name for name in members if traits.of(name, attribute) == value)  # type: ignore[arg-type]
    return first, tuple(name for name in members if name not in first)


def layers_of(node: Cells) -> list[int]:
    """How many cells each layer (or, flat, each row) has, from the bottom (from the back)."""
    if isinstance(node, Pyramid):
        n, depth = node.base
        return [(n - k) * max(depth - k, 1) if depth > 1 else n - k for k in range(n if depth == 1 else min(n, depth))]
    if isinstance(node, Grid):
        return [node.rows * node.columns] * node.layers if node.layers > 1 else [node.columns] * node.rows
    return []


def color_pattern(draft: Draft, figure: Shape, span: Span) -> None:
    """Sorted by colour, a figure of layers has one colour in each layer, a flat one in each row."""
    node = figure.node
    assert isinstance(node, Cells)
    layers = layers_of(node)
    if not layers:
        pattern = Pattern(kind="reading", order=Order(by="together"))
        draft.do(SetField(at=figure.path, field="pattern", value=pattern.model_dump()), span)
        return
    flat = isinstance(node, Grid) and node.layers == 1
    world = draft.view.world
    colors = [world.blocks[name].color for name in figure.members]
    counts = sorted(colors.count(color) for color in set(colors))
    if counts != sorted(layers):
        wanted = [color for k, size in enumerate(layers) for color in [PALETTE[k % len(PALETTE)]] * size]
        new: dict[str, Asset] = {
            name: ColoredCube.model_validate({"name": name, "color": color, "size": world.edge[name]})
            for name, color in zip(figure.members, wanted, strict=True)
        }
        exchange(draft, new, span)
        draft.assume(f"one colour for each {'row' if flat else 'layer'}, as none were named")
    pattern = Pattern(kind="row" if flat else "layer", attribute="color")
    draft.do(SetField(at=figure.path, field="pattern", value=pattern.model_dump()), span)
