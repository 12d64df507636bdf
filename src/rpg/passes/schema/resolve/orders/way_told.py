""" "By size, the largest on the left": what is compared is said first, and which way it goes behind it."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.meaning import OrderBy
from rpg.passes.schema.resolve.things.world import Scene

_WAYS = {
    "size": frozenset({"extreme", "ascending", "size", "size_up", "size_down"}),
    "label": frozenset({"extreme", "ascending", "number", "number_up", "number_down", "count_up", "countdown"}),
}
"""What tells the way of an order by size, and of one by the number that is shown."""


def way_told(orders: Sequence[OrderBy], names: Sequence[str], scene: Scene) -> list[OrderBy]:
    """The orders without one that names nothing but what is compared, where others say which way that goes."""
    shown = {scene.things[name].kind for name in names}
    compared = "label" if shown == {"digit"} else "size"
    named = {("attribute", compared), *([("size", "color")] if compared == "size" else [])}
    bare = [o for o in orders if (o.by, o.attribute) in named and not (o.first or o.descending)]
    ways = [o for o in orders if o.by in _WAYS[compared] and o not in bare]
    return [o for o in orders if not ways or o not in bare]
