"""What the second reader says to a guess: "Let us make a rainbow! One red, one orange, ... in a row" are not two rows.

Where it had to be assumed how many blocks there are, or of what colours, and the text tells of colours, the two readers
must find the same blocks and patches; else both readings are told.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from rpg.ir.schema import COLORS_UNSAID, TaskSchema
from rpg.language import lexicon
from rpg.language.tokens import Token
from rpg.passes.schema.ambiguity import TwoReadings

_GUESSED = ("the number of", "the colours are not said", COLORS_UNSAID)


def check_guess(task: TaskSchema, words: Sequence[Token], retold: Callable[[], TaskSchema | None], text: str) -> None:
    """Compare a task that had to be guessed with what the second reader makes of the text, if that reads it.

    Raises:
        TwoReadings: if they differ in what there is.
    """
    guessed = any(note.startswith(_GUESSED) for note in task.assumptions)
    if not guessed or not any(token.word in lexicon.COLOR for token in words):
        return
    other = retold()
    if other is not None and _there(other) != _there(task):
        raise TwoReadings(task, other, text)


def _there(task: TaskSchema) -> list[str]:
    """What there is, whatever it is called."""
    return sorted(f"{asset.model_dump(mode='json', exclude={'name', 'span'})}" for asset in task.assets)
