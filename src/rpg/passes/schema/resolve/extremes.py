""" "The smallest number at the left": what is said of an end of a line sorts it, where no other order is given."""

from __future__ import annotations

from rpg.language.meaning import Absolute, At, Noun, OrderBy
from rpg.passes.schema.resolve.positions import SIDES
from rpg.passes.schema.resolve.spec import Spec
from rpg.passes.schema.resolve.world import Scene, refuse

_OPPOSITE = {"left": "right", "front": "back", "bottom": "top"}
_OPPOSITE |= {two: one for one, two in _OPPOSITE.items()}


def sorted_from(spec: Spec, names: tuple[str, ...], kind: str, scene: Scene) -> list[OrderBy]:
    """The order that an extreme at an end stands for; what said so is taken out of `spec`."""
    found: OrderBy | None = None
    for item in list(spec.absolutes):
        order = _order(item, names, kind, scene)
        if order is None:
            continue
        spec.absolutes.remove(item)
        if found is not None and not _agree(found, order):
            raise refuse("contradiction", "these ends do not fit one order", order.span, "keep one of them")
        found = found or order
    if found is None:
        return []
    scene.assume("what is said of one end is read as the order of all of them")
    return [found]


def _order(item: Absolute, names: tuple[str, ...], kind: str, scene: Scene) -> OrderBy | None:
    theme, place = item.theme, item.adjuncts[0] if len(item.adjuncts) == 1 else None
    if not isinstance(theme, Noun) or theme.traits.rank not in ("smallest", "largest") or theme.traits.colors:
        return None
    if not isinstance(place, At) or (place.side, place.index) not in [("first", 1), *((s, None) for s in SIDES[kind])]:
        return None
    kinds = {scene.things[n].kind for n in names}
    if theme.traits.kind == "letter" or "letter" in kinds:
        return None
    first = None if place.side == "first" else place.side
    by = "number" if theme.traits.kind == "digit" or kinds == {"digit"} else "size"
    return OrderBy(by=by, first=first, descending=theme.traits.rank == "largest", span=item.span)


def _agree(one: OrderBy, two: OrderBy) -> bool:
    """Whether the same order is said from both ends."""
    return one.by == two.by and one.descending != two.descending and two.first == _OPPOSITE.get(one.first or "")
