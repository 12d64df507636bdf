""" "A tower with the white cube third from the bottom": of which no more is said than the place of one block."""

from __future__ import annotations

from rpg.language.meaning import Absolute, Amount, At, Chain, Clause, Noun, Size, Structure, Traits, replace
from rpg.passes.schema.resolve.things.counted import put
from rpg.passes.schema.resolve.things.world import Scene

_LINES = {"stack": "tower", "row": "row", "line": "line", "column": "column"}
_FEW = 3
"""So many blocks such a line has at least."""


def one_place_told(chains: tuple[Chain, ...], scene: Scene) -> tuple[Chain, ...]:
    """The sentences with a number of blocks for such a line, one more than the place that is told; where there is more
    than one clause, the blocks may be told of in another."""
    clause = chains[0].clauses[0] if len(chains) == 1 and len(chains[0].clauses) == 1 else None
    shape = clause.theme if isinstance(clause, Clause) and clause.verb == "build" else None
    if not isinstance(clause, Clause) or not isinstance(shape, Structure) or clause.adjuncts or clause.negated:
        return chains
    index = _place(shape)
    if not index or shape.kind not in _LINES:
        return chains
    many = max(_FEW, index + 1)
    scene.assume(f"the number of blocks in the {_LINES[shape.kind]} is not said: {many}")
    size = Size(what="size", amount=Amount(many, many), span=shape.span)
    return tuple(put(chain, shape, replace(shape, sizes=(size,))) for chain in chains)


def _place(shape: Structure) -> int:
    """Which block of a line is told of, where nothing else is said of it; 0 where it is otherwise."""
    bare = not (shape.sizes or shape.dims or shape.members or shape.plural or shape.letter)
    part = shape.details[0] if len(shape.details) == 1 else None
    if not bare or shape.traits != Traits() or shape.det != "a" or not isinstance(part, Absolute):
        return 0
    place = part.adjuncts[0] if len(part.adjuncts) == 1 else None
    one = isinstance(part.theme, Noun) and part.theme.amount in (None, Amount(1, 1)) and not part.theme.plural
    return place.index or 0 if one and isinstance(place, At) and (place.index or 0) > 1 else 0
