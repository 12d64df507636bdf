"""A left and a right that two lines share: "a row of three and a row of four, left red, right white"."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.grammar.rows.parting import sentences
from rpg.language.grammar.rows.vocabulary import COLOR, MANY
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_LINE = f"(?:row|line|column) of {MANY}"
_ONE = f"(?:the )?(?:left|right|leftmost|rightmost)(?: one)? {COLOR}"
_SHARED = on_demand(f"\\b{_LINE}\\b.*\\b{_LINE}\\b[^,]*? , {_ONE}(?: ,| and| , and) {_ONE}\\b")


def check_ends_of_which(tokens: Sequence[Token]) -> None:
    """Refuse a reading of the last line alone: the two lines may be to the left and right as well.

    Raises:
        Refusal: "ambiguous".
    """
    if not {"left", "right"} <= {token.word for token in tokens}:
        return
    for sentence in sentences(list(tokens)):
        if _SHARED.search(" ".join(token.word for token in sentence)):
            raise refuse("ambiguous", "the ends of the last line, or the two lines?",
                         (sentence[0].span[0], sentence[-1].span[1]),
                         "say the colours with each line, as in 'a row of three red blocks'")  # fmt: skip
