"""Rainbows of which both ends are told: "in rainbow order from purple to red"."""

from __future__ import annotations

from rpg.language.grammar.structures.gradients import between
from rpg.language.lexicon import RAINBOW
from rpg.language.meaning import Noun, OrderBy, Structure, Traits
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import Scene, Thing, refuse


def run_length(spec: Spec) -> int | None:
    """How many colours there are from one end to the other, where both are told."""
    told = next((o.values for o in spec.orders if o.by == "rainbow" and o.values), None)
    return len(between(*told)) if told else None


def painted(order: OrderBy, things: list[Thing], scene: Scene) -> bool:
    """Blocks of no colour get all those from one end to the other; others must begin and end so. Whether it runs
    against the order of the rainbow."""
    run = between(*order.values)
    open_ = [t for t in things if t.color is None and t.kind is None]
    if open_ and len(open_) == len(things) == len(run):
        for thing, color in zip(things, run, strict=True):
            thing.color = color
        scene.assume("the colours are not said: all of the rainbow from one end to the other")
    shown = sorted((t.color for t in things if t.color in RAINBOW), key=RAINBOW.index)
    if not shown or {shown[0], shown[-1]} != {*order.values} or len(shown) < len(things):
        raise refuse("count-mismatch", f"a rainbow from {run[0]} to {run[-1]} has {len(run)} colors: {', '.join(run)}",
                     order.span, f"use {len(run)} blocks, or name those to be used")  # fmt: skip
    return RAINBOW.index(run[0]) > RAINBOW.index(run[-1])


def rainbow_of(shape: Structure, spec: Spec) -> OrderBy:
    """The order of a gradient; "rainbow order from purple to red" names its ends, and not all of its blocks."""
    listed = next((o for o in spec.orders if o.by == "given" and len(o.items) == len(_ends(o)) == 2), None)
    if listed is None or shape.members is not None:
        return OrderBy(by="rainbow", span=shape.span)
    spec.orders.remove(listed)
    return OrderBy(by="rainbow", values=_ends(listed), span=listed.span)


def _ends(order: OrderBy) -> tuple[str, ...]:
    items = [x for x in order.items if isinstance(x, Noun) and x.traits == Traits(colors=x.traits.colors[:1])]
    return tuple(x.traits.colors[0] for x in items if x.traits.colors and x.traits.colors[0] in RAINBOW)
