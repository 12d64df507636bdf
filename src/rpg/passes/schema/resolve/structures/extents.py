"""What the makers of structures share: their sizes and their record."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.language.meaning import Coord, Meaning, Noun, Size, Structure, replace
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.things.things import amount_of
from rpg.passes.schema.resolve.things.world import Built, Ref, Scene, refuse

Made = tuple[list[Built], list[g.Goal]]


_GRID = (("rows", "deep"), ("columns", "wide", "long"), ("layers", "high"))
_ONE_WAY = {
    "wall": (("wide", "long", "columns"), ("high", "layers", "rows")), "staircase": (("steps", "high", "layers"),),
    "pyramid": ((), (), ("high", "layers")), **dict.fromkeys(("grid", "cube", "square", "checkerboard"), _GRID),
}  # fmt: skip
"""Sizes of a structure that go the same way, so that there is only one of them, in the order of its dimensions."""


def plain(shape: Structure) -> None:
    """Refuse several at once, and two sizes for one direction ("three wide and two long"): one would be lost."""
    if shape.plural or (shape.amount and shape.amount.low > 1):
        raise refuse(
            "unsupported-structure",
            f"several {shape.kind}s at once are not understood",
            shape.span,
            f"name each {shape.kind} by itself: 'a {shape.kind} of ... and a {shape.kind} of ...'",
        )
    for index, way in enumerate(_ONE_WAY.get(shape.kind, ())):
        told = {size.amount.low: size.span for size in shape.sizes if size.what in way and size.amount is not None}
        if told and index < len(shape.dims):
            told.setdefault(shape.dims[index], shape.span)
        if len(told) > 1:
            raise refuse("contradiction", "two sizes are given for one direction", max(told.values()),
                         "keep one of them, or say which other way it goes")  # fmt: skip


def made(kind: str, node: g.Goal, names: tuple[str, ...], span: Span, scene: Scene) -> Made:
    return [scene.add_built(kind, names, False, span, form=node)], [node]


def dims_told(shape: Structure, further: Sequence[Size]) -> tuple[int, ...]:
    """The dimensions said behind the noun; a wall is measured by its width first, and named by its rows."""
    size = next((z for z in (*shape.sizes, *further) if z.what == "dims"), None)
    if size is None:
        return ()
    return size.dims[::-1] if size.named and shape.kind == "wall" else size.dims


_BOARDS = frozenset({"grid", "wall", "square", "rectangle", "cube"})
"""What has rows and columns of its own."""


def check_own_lines(lines: Structure, scene: Scene) -> None:
    """Refuse "a 2x4 grid, with alternating red and white rows", where these would be further rows, beside the grid."""
    unsaid = lines.amount is None and lines.kind in ("row", "column")
    if unsaid and any(one.kind in _BOARDS for one in scene.built):
        raise refuse("ambiguous", f"the {lines.kind}s of what was told before, or others?", lines.span,
                     f"say 'each {lines.kind}', or how many further {lines.kind}s there are")  # fmt: skip


def totals(shape: Structure) -> tuple[Size, ...]:
    """ "six in total": the size of a single structure; how several share them is not said."""
    several = shape.plural or (shape.amount is not None and shape.amount.low > 1)
    for size in shape.sizes:
        if size.what == "total" and several:
            raise refuse("ambiguous", "it is not said how many blocks each has", size.span, "say how many each has")
    return tuple(replace(z, what="size") if z.what == "total" else z for z in shape.sizes)


def check_total(total: Size | None, names: Collection[str]) -> None:
    """Refuse "three rows of four, ten blocks in total"."""
    told = total.amount if total is not None else None
    if total is None or told is None or told.low <= len(names) <= (told.high or len(names)):
        return
    raise refuse("contradiction", f"{told.low} in total are told, but this takes {len(names)} blocks", total.span,
                 f"say {len(names)}, or another size")  # fmt: skip


def _tally(members: Meaning | None) -> int | None:
    """How many blocks "two red and two white blocks" are, or "red block 1 and red block 2"."""
    if isinstance(members, Noun) and members.amount is None and (members.traits.rank or "").startswith("#"):
        return 1
    if not isinstance(members, Coord) or members.op != "and":
        return amount_of(members)
    counts = [_tally(item) for item in members.items]
    return sum(n for n in counts if n) if all(counts) else None


def used_count(spec: Spec) -> int | None:
    """ "with four red and four white blocks": how many are to be used."""
    return _tally(spec.usings[0].members) if len(spec.usings) == 1 else None


def said_count(shape: Structure, theme: Ref | None, scene: Scene) -> int | None:
    """The number of blocks, if it was said or is settled by the blocks named."""
    named = _tally(shape.members)
    if named is None and theme is not None and not all(scene.things[n].elastic for n in theme.names):
        named = len(theme.names)
    return named or shape.extent("size", "corners")
