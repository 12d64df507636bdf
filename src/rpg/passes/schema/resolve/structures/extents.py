"""What the makers of structures share: their sizes and their record."""

from __future__ import annotations

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.language.meaning import Coord, Meaning, Structure
from rpg.passes.schema.resolve.things.things import amount_of
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, refuse

Made = tuple[list[Built], list[g.Goal]]


def _size(shape: Structure) -> int | None:
    return shape.extent("size", "side", "steps", "high", "layers")


def plain(shape: Structure) -> None:
    if shape.plural or (shape.amount and shape.amount.low > 1):
        raise refuse(
            "unsupported-structure",
            f"several {shape.kind}s at once are not understood",
            shape.span,
            f"name each {shape.kind} by itself: 'a {shape.kind} of ... and a {shape.kind} of ...'",
        )


def made(kind: str, node: g.Goal, names: tuple[str, ...], span: Span, scene: Scene) -> Made:
    return [scene.add_built(kind, names, False, span)], [node]


def _tally(members: Meaning | None) -> int | None:
    """How many blocks "two red and two white blocks" are."""
    if not isinstance(members, Coord) or members.op != "and":
        return amount_of(members)
    counts = [_tally(item) for item in members.items]
    return sum(n for n in counts if n) if all(counts) else None


def said_count(shape: Structure, theme: Ref | None, scene: Scene) -> int | None:
    """The number of blocks, if it was said or is settled by the blocks named."""
    named = _tally(shape.members)
    if named is None and theme is not None and not all(scene.things[n].elastic for n in theme.names):
        named = len(theme.names)
    return named or shape.extent("size")
