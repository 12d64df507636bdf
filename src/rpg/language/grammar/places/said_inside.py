"""What a sentence says of the blocks of a structure, and what of the structure that is told by them."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.meaning import Absolute, Loc


def said_inside(p: Parser, j: int, found: Results[Absolute]) -> Results[Absolute]:
    """Without "(the row with) A and B is behind it": the row is, and nothing is built in which A and B are."""
    whole = p.words[j - 1] == "with" and p.stands(0, ("the",))
    for told, end in found:
        words = p.words[j:end]
        stated = not {"is", "are", "stands"}.isdisjoint(words) and {"that", "which", "where"}.isdisjoint(words)
        if not (whole and stated and isinstance(told.adjuncts[0], Loc)):
            yield told, end
