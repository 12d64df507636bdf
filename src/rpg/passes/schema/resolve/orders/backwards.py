"""Orders turned round: "in the opposite order, the highest first", "the last letter first"."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir.order import Order
from rpg.language.meaning import Absolute, Noun, OrderBy
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.orders.parts import place_of
from rpg.passes.schema.resolve.orders.reordered import FIRST, lines_of_the_start
from rpg.passes.schema.resolve.things.world import Built, Scene, refuse


def last_first(spec: Spec, names: tuple[str, ...], scene: Scene) -> list[OrderBy]:
    """ "the last letter first", "the first one last": the blocks the other way round than they are named; what said so
    is taken out of `spec`."""
    looks = [(scene.things[n].color, scene.things[n].label) for n in names]
    if len({*looks}) < len(names):
        return []
    found: list[OrderBy] = []
    for item in [item for item in spec.absolutes if _of_the_other_end(item)]:
        labels = [scene.things[n].label or "" for n in names]
        if _traits_kind(item) is not None and labels != sorted(labels):
            raise refuse("ambiguous", "the last as they are named, or the last in the order of all of them?", item.span,
                         "name the block that comes first")  # fmt: skip
        spec.absolutes.remove(item)
        sorted_ = any(o.by in _SORTED for o in spec.orders)
        found = [OrderBy(by="reverse" if sorted_ else "backwards", span=item.span)]
    return found


_SORTED = ("label", "number", "ascending", "rainbow", "size")
"""Orders that "the last one first" turns round."""
_FROM_BELOW = ("size_up", "size_down", "number_up", "number_down")


def _of_the_other_end(item: Absolute) -> bool:
    theme, place = item.theme, place_of(item)
    if not isinstance(theme, Noun) or theme.plural or place is None:
        return False
    bare = theme.traits.colors == theme.traits.labels == ()
    return bare and (theme.traits.rank, place.side) in (("last", "first"), ("first", "last"))


def _traits_kind(item: Absolute) -> str | None:
    return item.theme.traits.kind if isinstance(item.theme, Noun) else None


def turned_round(
    found: Order, spec: Spec, told: list[OrderBy], scene: Scene, names: tuple[str, ...], begin: str, span: Span
) -> Order:
    """ "in the opposite order": of the order that is named, or as the blocks are named where it is said which one of
    them comes first. `told`: what was said of an end, by which it is said which order that is."""
    if any(o in told or _of_an_end(o) for o in spec.orders if o.by != "reverse"):
        return found
    ends = [item for item in spec.absolutes if (at := place_of(item)) is not None and at.side in ("first", "last")]
    if found.by == "any" and ends:
        scene.assume("the opposite order is that in which the blocks are named, from the last to the first")
        return Order(by="given", ranks=tuple((n,) for n in reversed(names)), first=begin)  # type: ignore[arg-type]
    if found.by == "any" and (there := _as_they_stood(names, begin, scene)) is not None:
        return Order(by="given", ranks=tuple((n,) for n in reversed(there.members)), first=there.side or begin)  # type: ignore[arg-type]
    if found.by in ("any", "given"):
        which = "it is not said which order is to be reversed" if found.by == "any" else (
            "it is not clear whether the order that is named is the reversed one"
        )  # fmt: skip
        raise refuse("ambiguous", which, span, "name the order, such as 'in reverse alphabetical order'")
    return found.model_copy(update={"descending": not found.descending})


def _as_they_stood(names: tuple[str, ...], begin: str, scene: Scene) -> Built | None:
    """The one tower or line in which these blocks were so far, if it began where this one does."""
    wholes = [
        b for b in lines_of_the_start(scene) if b.ordered and {*b.members} == {*names} and FIRST.get(b.kind) == begin
    ]
    return wholes[0] if len(wholes) == 1 else None


def _of_an_end(order: OrderBy) -> bool:
    return (
        order.values == ("end",)
        or order.by in ("extreme", *_FROM_BELOW)
        or (order.by == "number" and bool(order.first))
    )
