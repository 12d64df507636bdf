"""Figures whose layers the words behind them list: "a pyramid of six blocks, red, white, blue from bottom to top"."""

from __future__ import annotations

from rpg.language.meaning import Absolute, Clause, Coord, Meaning, Noun, Places, Structure, Toward, Traits, replace
from rpg.passes.schema.resolve.things.world import refuse

_LAYERED = ("pyramid", "wall", "cube")
_LINES = ("stack", "row", "line", "column", "word", "equation", "pile", "set", "gradient")
"""No figures, but what a list tells the blocks of one by one, or lies beside."""


def layers_listed(last: Clause, said: Clause) -> Clause | None:
    """The clause that builds the figure, with the look of each of its layers.

    Of a figure of which it is not said how its blocks look, such a list tells no further tower.
    """
    shape, ways = last.theme, said.adjuncts
    unlooked = isinstance(shape, Structure) and shape.traits == Traits() and not shape.plural and _unlooked(shape)
    looks = _looks(said.theme)
    if last.verb != "build" or not unlooked or not isinstance(shape, Structure) or len(looks) < 2:
        return None
    if said.verb != "be" or not ways or not all(isinstance(way, Toward) for way in ways):
        return None
    if shape.kind in _LINES:
        return None
    way = ways[0] if len(ways) == 1 else None
    if shape.kind not in _LAYERED or not isinstance(way, Toward) or way.first not in ("top", "bottom"):
        raise refuse("ambiguous", f"these could be blocks of the {shape.kind} or further ones", said.span,
                     "say of each row, column or layer how it looks")  # fmt: skip
    told = (_layer(look, k + 1, way.first, len(looks)) for k, look in enumerate(looks))
    return replace(last, adjuncts=(*last.adjuncts, Coord(op="absolutes", items=tuple(told), span=said.span)))


def _unlooked(shape: Structure) -> bool:
    """Whether at most the number of its blocks is said."""
    blocks = shape.members
    return blocks is None or (isinstance(blocks, Noun) and blocks.traits == Traits() and not blocks.conditions)


def _looks(theme: Meaning | None) -> tuple[Noun, ...]:
    """ "red, white, blue": one look for each colour."""
    items = theme.items if isinstance(theme, Coord) and theme.op == "and" else (theme,)
    nouns = [x for x in items if isinstance(x, Noun) and x.head == "any" and x.det == "bare" and x.amount is None]
    if len(nouns) < len(items) or any(x.traits != Traits(colors=x.traits.colors) or x.part_of for x in nouns):
        return ()
    return tuple(replace(x, plural=False, traits=Traits(colors=(c,)), cost=0) for x in nouns for c in x.traits.colors)


def _layer(look: Noun, index: int, first: str, count: int) -> Absolute:
    place = Places(side=first, unit="layer", index=index, of=count, span=look.span)
    return Absolute(theme=look, adjuncts=(place,), span=look.span)
