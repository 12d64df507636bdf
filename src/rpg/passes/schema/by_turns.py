"""Lines in which looks take turns: what is told so must alternate."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from rpg.blocks.traits import VOWELS
from rpg.ir.assets import FACES, Block, SemanticCube
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Row, Stack
from rpg.ir.walk import atoms
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse


def in_turn(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "put red and blue on the mat in turn" as a line in which colours alternate: no two are alike, or all."""
    turn = next((t for before, t in pairwise(words) if t.word in ("turn", "turns") and before.word in _TURNS), None)
    colors = {asset.name: asset.color for asset in task.blocks}
    for line in (x for x in atoms(task.goal) if isinstance(x, Row | Stack) and x.order.by == "alternating"):
        if turn is not None and len({colors[n] for n in line.blocks}) in (1, len(line.blocks)):
            raise refuse("ambiguous", "in a line of alternating colours, or one after the other?", turn.span,
                         "say 'first ..., then ...'")  # fmt: skip


_TURNS = frozenset({"in", "take", "takes", "by"})


def alternating(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "letters and digits alternate in a row: A, B, 1, 2" as a row in the order of the list."""
    looks = {asset.name: _looks(asset) for asset in task.blocks}
    for line in (x for x in atoms(task.goal) if isinstance(x, Row | Stack) and x.order.by == "given"):
        names_ = [rank[0] for rank in line.order.ranks if len(rank) == 1]
        if len(names_) < len(line.blocks) or len(names_) < 3:
            continue
        shown = [[looks[name][k] for name in names_] for k in range(len(looks[names_[0]]))]
        if not any(_alternates(values) for values in shown):
            told = next(t for t in words if t.word in ALTERNATE)
            raise refuse("ambiguous", "the blocks are listed in an order that does not alternate", told.span,
                         "list them in the order that is meant, or name their kinds alone")  # fmt: skip


def _looks(asset: Block) -> tuple[object, ...]:
    """What a block may take turns by: its colour, of what kind its symbol is, and its size."""
    symbol = asset.symbol(FACES[0]) if isinstance(asset, SemanticCube) else ""
    kind = "letter" if symbol.isalpha() else "digit" if symbol.isdigit() else symbol
    sort = symbol in VOWELS if symbol.isalpha() else int(symbol) % 2 if symbol.isdigit() else symbol
    return asset.color, kind, (kind, sort), asset.size


def _alternates(values: Sequence[object]) -> bool:
    """Whether the same few come again and again in one order."""
    few = len(set(values))
    again = all(value == values[n - few] for n, value in enumerate(values) if n >= few)
    return 1 < few < len(values) and again and len(set(values[:few])) == few


ALTERNATE = frozenset({"alternate", "alternates", "alternating", "alternately"})
