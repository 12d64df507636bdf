"""A word along a column of the table: "spell STAR in a column on the table", read from the back as on a page where
nothing is said of the way, "..., with the S nearest to me". A bare column may as well be a tower that is read down."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.language.meaning import Absolute, At, Noun, Structure, TableTop, Traits
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import Built, Scene, refuse

_OTHER = {"front": "back", "back": "front"}
_OUTER = ("first", "last")


def in_column(spec: Spec) -> bool:
    """Whether the word lies along one column, and does not stand: "in a column, read downwards" is no such thing."""
    shapes = [into.structure for into in spec.intos]
    return (
        len(shapes) == 1
        and isinstance(shapes[0], Structure)
        and shapes[0].kind == "column"
        and not (shapes[0].upright or shapes[0].plural or shapes[0].traits.rank or shapes[0].sizes)
        and not any(way.axis in ("y", "z") for way in spec.toward)
    )


def along_column(
    text: str, names: tuple[str, ...], spec: Spec, shape: Structure, scene: Scene
) -> tuple[list[Built], list[g.Goal]]:
    """Its letters in a line that is read from the end at which the word begins."""
    if spec.ats or any(order.by not in ("any", "in_order") for order in spec.orders) or spec.manner("backwards"):
        raise refuse("misplaced", "this does not fit a word", shape.span, "leave it out")
    into = spec.intos.pop()
    details = into.structure.details if isinstance(into.structure, Structure) else ()
    begins = {way.first for way in spec.toward if way.first is not None}
    for told in [*details, *spec.absolutes]:
        at = told.adjuncts[0] if isinstance(told, Absolute) and len(told.adjuncts) == 1 else None
        if isinstance(told, Absolute) and isinstance(at, At) and at.side in _OTHER and at.index is None:
            begins |= _begins(told, at, text)
            spec.absolutes = [x for x in spec.absolutes if x is not told]
        elif told in details:
            raise refuse("misplaced", "this does not fit a word", told.span, "leave it out")
    if len(begins) > 1:
        raise refuse("contradiction", f"{text} cannot begin at both ends", shape.span, "keep one of them")
    spec.toward, spec.orders = [], []
    if not begins:
        if not any(isinstance(getattr(place, "landmark", None), TableTop) for place in spec.places):
            message = "a word in a column could be read down a tower, or away along the table"
            raise refuse("ambiguous", message, into.span, "say 'in a tower', or 'in a column on the table'")
        scene.assume("the word is read from back to front")
    ranks = tuple((name,) for name in names)
    order = Order(by="given", ranks=ranks, first="front" if "front" in begins else "back")
    row = s.Row(blocks=names, axis="x", order=order, readable=True, span=shape.span)
    return [scene.add_built("column", names, True, shape.span, order.first)], [row]


def _begins(told: Absolute, at: At, text: str) -> set[str]:
    """Where the word begins, if this letter of it is at this end; nothing for one that it has at both ends."""
    traits = told.theme.traits if isinstance(told.theme, Noun) else Traits()
    if traits.rank in _OUTER:
        return {at.side if traits.rank == "first" else _OTHER[at.side]}
    label = traits.labels
    if len(label) != 1 or label[0] not in (text[0], text[-1]):
        raise refuse("contradiction", f"{text} neither begins nor ends with this", told.span, "leave it out")
    if text[0] == text[-1]:
        return set()
    return {at.side if label[0] == text[0] else _OTHER[at.side]}
