"""What stands there, told ahead of what is to be done: "A, B and C stand in a row. ... Straighten it." """

from __future__ import annotations

from collections.abc import Sequence

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import sentences
from rpg.language.tokens import Token

_STAND = frozenset({"stand", "stands", "lie", "lies", "sit", "sits"})
_WISHED = frozenset({"must", "should", "shall", "will", "want", "goal", "end", "finally", "has", "have", "needs", "to"})


def begun_first(words: Sequence[Token]) -> bool:
    """Whether a text begins with how blocks stand in a figure, as a fact, and goes on with an order: what is told first
    is there at the start, and is not what is to be built."""
    first, *rest = sentences([*words])
    said = {token.word for token in first}
    fact = not said.isdisjoint(_STAND) and said.isdisjoint(_WISHED) and first[0].word not in lexicon.COMMANDS
    built = any(token.word in lexicon.STRUCTURE for token in first)
    return fact and built and any(part[0].word in lexicon.COMMANDS for part in rest)
