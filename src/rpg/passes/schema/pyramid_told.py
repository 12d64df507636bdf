"""What is told to lie on top in a pyramid must be as many blocks as it has there."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Pyramid
from rpg.ir.walk import atoms
from rpg.language import lexicon
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_ON_TOP = (["on", "top"], ["at", "top"])
_BASE = frozenset({"base", "bottom", "layer", "foundation", "ground", "level", "floor"})
_IT = frozenset({"it", "them", "these", "those", "that", "this"})


def check_pyramid(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "a pyramid with a base of three and two on top" as one of six blocks: its tip is one block. So is "with
    three at the bottom and one on top of them": on them are two; and "a pyramid of three blocks and one on top of it".
    """
    bases = [x.base for x in atoms(task.goal) if isinstance(x, Pyramid)]
    tips = [abs(a - b) + 1 if min(a, b) > 1 else 1 for a, b in bases]
    above = [max(a - 1, 1) * max(b - 1, 1) for a, b in bases]
    for index, number in enumerate(words if bases else ()):
        many = lexicon.NUMBER.get(number.word, 0) if number.kind == "word" else number.value
        if not isinstance(many, int | float) or not many:
            continue
        behind = [t.word for t in words[index + 1 : index + 6] if t.word not in ("the", *lexicon.BLOCK)]
        on_it = behind[:2] in _ON_TOP and behind[2:3] == ["of"] and not _IT.isdisjoint(behind[3:4])
        if on_it:
            based = not _BASE.isdisjoint(t.word for t in words[:index])
            wrong = not based or many not in above
        else:
            wrong = behind[:2] in _ON_TOP and behind[2:3] not in (["of"], ["them"]) and many > 1 and many not in tips
        if wrong:
            raise refuse("ambiguous", "are these the whole top of the pyramid, or is there one more above them?",
                         number.span, "say of how many blocks the pyramid is built")  # fmt: skip
