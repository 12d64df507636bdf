"""Lines that are to read something: where reading begins, and whether their symbols have to be readable."""

from __future__ import annotations

from rpg.ir.order import Order
from rpg.language.meaning import Noun, OrderBy
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import Scene, refuse

_BEGIN = {"row": "left", "line": "left", "stack": "top"}


def reading_begins(order: OrderBy, names: tuple[str, ...], kind: str, scene: Scene) -> str:
    """Symbols are read from the left, or from the top down; colours have no such custom, but in a row."""
    begin = _BEGIN.get(kind)
    if begin is None or (kind == "stack" and not (_symbols(names, scene) or _labels(order))):
        raise refuse("ambiguous", f"it is not said from which end the {kind} is read", order.span,
                     "say 'from top to bottom', or 'from front to back'")  # fmt: skip
    return begin


def legible(order: Order, names: tuple[str, ...], spec: Spec, scene: Scene) -> bool:
    """Whether the symbols of a line have to be readable, not only in order."""
    return order.by in ("label", "number") or (any(o.by == "read" for o in spec.orders) and _symbols(names, scene))


def _symbols(names: tuple[str, ...], scene: Scene) -> bool:
    return all(scene.things[n].label for n in names)


def _labels(order: OrderBy) -> bool:
    return all(isinstance(item, Noun) and item.traits.labels for item in order.items)
