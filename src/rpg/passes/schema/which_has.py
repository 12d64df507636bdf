"""A clause that may be told of what stands with something, or of that: "with a blue block to its left that has ..."."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_HAS = frozenset({"has", "have", "carries", "bears", "holds", "supports"})


def check_which_has(words: Sequence[Token]) -> None:
    """Refuse "a red block with a blue block to its left that has a green block behind it" as green behind red."""
    said = [token for token in words if token.word not in (",", "and")]
    told = [token.word for token in said]
    for at, word in enumerate(told):
        beside = told[at - 1] == "it" or "its" in told[max(0, at - 2) : at]
        if word in ("that", "which") and beside and _HAS & {*told[at + 1 : at + 2]}:
            raise refuse("ambiguous", "which of the two is this told of?", said[at].span,
                         "name it in a sentence of its own")  # fmt: skip
