"""How the cells of a figure are coloured or labelled."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from rpg.blocks.figure_parts import has_own
from rpg.core.diagnostics import Span
from rpg.ir.order import Pattern
from rpg.ir.structures import Cells, Figure, Grid, Pyramid, Staircase
from rpg.language.lexicon import COLORS
from rpg.language.meaning import Structure
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.checkered import checkered, taking_turns
from rpg.passes.schema.resolve.orders.orders import order_of
from rpg.passes.schema.resolve.orders.parts import parted
from rpg.passes.schema.resolve.things.world import Scene, Scope, Thing, refuse

PALETTE = (*tuple(c for c in COLORS if c not in ("black", "white", "gray", "brown")), "brown", "white", "black", "gray")


def pattern_of(
    shape: Structure,
    spec: Spec,
    names: tuple[str, ...],
    dims: tuple[int, int, int] | None,
    scene: Scene,
    scope: Scope,
    form: Cells,
) -> tuple[Pattern | None, bool]:
    """How the cells of `form` are coloured or labelled; colours and labels left open are chosen to fit."""
    if dims is not None and not isinstance(form, Pyramid | Staircase):
        taking_turns(spec)
    by_parts = checkered(spec, form, names, scene) or parted(spec, form, names, scene, scope)
    if by_parts is not None:
        return by_parts, False
    things = [scene.things[n] for n in names]
    said = next(iter(spec.patterns), None)
    spec.patterns = spec.patterns[1:]
    if said is None:
        if any(t.kind for t in things) and not spec.orders:
            return None, False
        if not spec.orders:
            return None, False
        alternating = next((o for o in spec.orders if o.by == "alternating"), None)
        if alternating is not None and isinstance(form, Pyramid | Staircase):
            raise refuse("ambiguous", "how colours alternate where layers differ in length is not clear",
                         alternating.span, "say 'each layer a different colour'")  # fmt: skip
        if alternating is not None and dims is not None:
            raise refuse("misplaced", "in a grid colours alternate, two of them", alternating.span,
                         "say 'in a checkerboard pattern'")  # fmt: skip
        tall = getattr(form, "layers", 2) > 1 and not isinstance(form, Figure)
        begins = {**{t.first: t.span for t in spec.toward}, **{o.first: o.span for o in spec.orders}}
        upward = "bottom" in begins
        _check_begun(begins, form, tall)
        own = "drawn" in begins and has_own(form)
        passed = {*(("top", "bottom") if tall else ()), *(("drawn",) if own else ())}
        spec.toward = [t for t in spec.toward if t.first not in passed]
        order = order_of(spec, names, "row", scene, scope, shape.span).model_copy(update={"first": None})
        if order.by == "together":
            raise refuse(
                "ambiguous",
                "it is not said how the colours are to be laid out",
                shape.span,
                "say 'each row a different colour' or 'each layer a different colour'",
            )
        spec.orders = []
        return Pattern(kind="reading", order=order, upward=upward, own=own), order.by in ("label", "number")
    unit = {"pile": "row", "stack": "column"}.get(said.unit, said.unit)
    if dims is None:
        raise refuse("misplaced", f"a {shape.kind} has no {said.unit}s", said.span)
    return _painted(unit, things, dims, scene), False


def _check_begun(begins: Mapping[str | None, Span], form: Cells, tall: bool) -> None:
    """Refuse "a 2x2 grid from right to left: ...": where its second row begins is not said."""
    against = [side for side in ("right", *(() if tall else ("front", "bottom"))) if side in begins]
    if against and isinstance(form, Grid | Pyramid):
        raise refuse("misplaced", "a figure with several rows is read row by row, each from left to right",
                     begins[against[0]], "list its blocks in that order, or say each row by itself")  # fmt: skip


def _painted(unit: str, things: list[Thing], dims: tuple[int, int, int], scene: Scene) -> Pattern:
    """A pattern by lines, with colours where none were said."""
    colors = Counter(t.color for t in things if t.color and not t.label)
    if unit == "checkerboard" and len(colors) == 1 and colors.total() == len(things):
        raise refuse("contradiction", "a checkerboard has two colours", None, "name a second colour")
    if unit in ("row", "column", "layer") and colors.total() == len(things):
        lines = _lines(unit, len(things), dims)
        if sorted(colors.values()) != sorted(lines):
            raise refuse("count-mismatch", f"these blocks do not make {len(lines)} {unit}s of one colour each", None,
                         f"use {len(lines)} colours, as many of each as a {unit} has", lines=len(lines))  # fmt: skip
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
        return [layers] * (rows * columns) if layers > 1 else [rows] * columns  # upright where there are layers
    return [rows * columns] * layers
