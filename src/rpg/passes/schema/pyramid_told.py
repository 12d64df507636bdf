"""What is told to lie on top in a pyramid must be as many blocks as it has there."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import prod

from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Pyramid
from rpg.ir.walk import atoms
from rpg.language import lexicon
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_ON_TOP = (["on", "top"], ["at", "top"])
_LOWEST = (["at", "bottom"], ["at", "base"], ["in", "base"], ["at", "foot"])
_IT = frozenset({"it", "them", "these", "those", "that", "this"})


def check_pyramid(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a pyramid with a base of three and two on top" as one of six blocks: its tip is one block. So is "with
    three at the bottom and one on top of them": on them are two; and "a pyramid of three blocks and one on top of it".
    "Three blocks wide at the bottom" is none of three blocks.
    """
    pyramids = [_layers(*x.base) for x in atoms(task.goal) if isinstance(x, Pyramid)]
    below = 0
    for index, number in enumerate(words if pyramids else ()):
        many = prod(number.value) if isinstance(number.value, tuple) else number.many
        if not many:
            continue
        behind = [t.word for t in words[index + 1 : index + 6] if t.word not in ("the", *lexicon.BLOCK)]
        behind = behind[1:] if behind[:1] == ["wide"] else behind
        on_top = behind[:2] in _ON_TOP
        if on_top and behind[2:3] == ["of"] and not _IT.isdisjoint(behind[3:4]):
            wrong = all((below, many) not in pairwise(told) for told in pyramids)
        else:
            wrong = on_top and behind[2:3] not in (["of"], ["them"]) and 1 < many not in {x[-1] for x in pyramids}
            wrong |= behind[:2] in _LOWEST and many > 1 and many not in {x[0] for x in pyramids}
        if wrong:
            raise refuse("ambiguous", "are these a whole layer of the pyramid, or are there others in it?",
                         number.span, "say of how many blocks the pyramid is built")  # fmt: skip
        below = many


def _layers(rows: int, columns: int) -> list[int]:
    """How many blocks each layer of a pyramid has, from the lowest one up."""
    if min(rows, columns) == 1:
        return [*range(max(rows, columns), 0, -1)]
    return [(rows - k) * (columns - k) for k in range(min(rows, columns))]
