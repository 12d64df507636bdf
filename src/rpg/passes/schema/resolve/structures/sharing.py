"""Which blocks each of several structures is made of, where these are named or counted for all of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rpg.language.meaning import Coord, Noun, Structure
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.world import Ref, Scene, refuse

Look = Noun | Coord | Structure | None
"""What is said of one of several structures."""


def shared_out(shape: Structure, looks: Sequence[Look], spec: Spec) -> Structure:
    """ "two towers from five orange blocks: one has three, the other two": of the blocks that are counted for all."""
    told = [look.amount for look in looks if isinstance(look, Noun) and look.amount is not None]
    stock = shape.members or (spec.usings[0].members if len(spec.usings) == 1 else None)
    if len(told) < len(looks) or not isinstance(stock, Noun) or stock.amount is None or shape.sizes:
        return shape
    if any(x.low != x.high for x in (*told, stock.amount)) or sum(x.low for x in told) != stock.amount.low:
        raise refuse("count-mismatch", f"this takes {sum(x.low for x in told)} blocks", stock.span,
                     "use as many blocks as are told of each")  # fmt: skip
    spec.usings = [] if shape.members is None else spec.usings
    return replace(shape, members=replace(stock, amount=None), each_size=False)


def named_lots(theme: Ref | None, looks: Sequence[Look], scene: Scene) -> list[Ref | None]:
    """Which of the blocks that were named each line has, where it is told by their labels."""
    if theme is None or not all(isinstance(look, Noun) and look.traits.labels for look in looks):
        return []
    lots: list[Ref | None] = [
        Ref(names=tuple(n for n in theme.names if scene.things[n].label in look.traits.labels), span=theme.span)
        for look in looks
        if isinstance(look, Noun)
    ]
    shared = [n for lot in lots if lot is not None for n in lot.names]
    return lots if sorted(shared) == sorted(theme.names) else []


def lots_of(theme: Ref | None, count: int, shape: Structure, scene: Scene) -> list[Ref | None]:
    """The blocks of each, where they were named one lot after the other, or all look alike."""
    if theme is None:
        return [None] * count
    if len(theme.parts) == count and all(len(p.names) > 1 for p in theme.parts) and theme.op == "and":
        if shape.members is None:
            raise refuse("ambiguous", f"it is not said which blocks go into which {shape.kind}", shape.span,
                         f"say 'a {shape.kind} of ... and a {shape.kind} of ...'")  # fmt: skip
        return list(theme.parts)
    things = [scene.things[n] for n in theme.names]
    share, left = divmod(len(things), count)
    same = len({(t.color, t.label, t.kind, t.size) for t in things}) == 1 and theme.quant is None and not left
    if same and share > 1 and not any(t.elastic for t in things):
        for thing in things:
            thing.scheme = thing.scheme or "same"
        return [Ref(names=theme.names[k * share : (k + 1) * share], span=theme.span) for k in range(count)]
    raise refuse(
        "ambiguous", f"it is not said which blocks go into which {shape.kind}", shape.span,
        f"say how many blocks each {shape.kind} has",
    )  # fmt: skip
