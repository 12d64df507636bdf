"""Which cube an equation begins or ends with: "an equation with 2, 3, 5, + and =, with the 5 on the left"."""

from __future__ import annotations

from collections.abc import Callable
from itertools import permutations

from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.order import Order
from rpg.language.meaning import Absolute, At, Noun, Places
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import Scene, refuse

_SEARCHED = 8
"""Of more cubes not every order is tried."""
_SIDES = {"left": True, "first": True, "right": False, "last": False}


def ends_told(node: s.Equation, spec: Spec, scene: Scene, true: Callable[[str], bool]) -> list[g.Goal]:
    """Lines of the cubes of a row, with the ones that are told at its ends. `true`: tells whether symbols in this order
    are such an equation."""
    told: dict[bool, str] = {}
    for item in list(spec.absolutes) if node.along == "row" else ():
        begins, name = _begins(item), _cube(item, node.blocks, scene)
        if begins is not None and name is not None and told.setdefault(begins, name) == name:
            spec.absolutes.remove(item)
    labels = {name: scene.things[name].label or "" for name in node.blocks}
    if (
        told
        and len(labels) <= _SEARCHED
        and not any(
            all(way[0 if begins else -1] == labels[name] for begins, name in told.items()) and true("".join(way))
            for way in permutations(labels.values())
        )
    ):
        raise refuse("false-equation", "no true equation of these cubes has this one there", node.span, "leave it out")
    rest = tuple(name for name in node.blocks if name not in told.values())
    ranks = ((told[True],) if True in told else (), rest, (told[False],) if False in told else ())
    order = Order(by="given", ranks=tuple(filter(None, ranks)), first="left")
    return [s.Row(blocks=node.blocks, axis="y", order=order, span=node.span)] if told else []


def _begins(item: Absolute) -> bool | None:
    """Whether this place is where the equation begins, or ends."""
    at = item.adjuncts[0] if len(item.adjuncts) == 1 else None
    if isinstance(at, At) and at.index in (None, 1) and not at.whole:
        return _SIDES.get(at.side)
    return _SIDES.get(at.side) if isinstance(at, Places) and at.unit == "block" and not at.each else None


def _cube(item: Absolute, names: tuple[str, ...], scene: Scene) -> str | None:
    label = item.theme.traits.labels if isinstance(item.theme, Noun) else ()
    shown = [name for name in names if (scene.things[name].label,) == label]
    return shown[0] if len(shown) == 1 else None
