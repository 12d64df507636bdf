"""Blocks of which one part and the other are counted: "two of the blocks go on the red mat and the other three on the
blue one" is told of five."""

from __future__ import annotations

from rpg.language.grammar.rows.parting import text_of
from rpg.language.grammar.rows.vocabulary import COLOR, MANY, NO_NUMBER, number
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

_BLOCKS = f"(?:{COLOR} )?(?:blocks|cubes|bricks|boxes)"
_PARTED = on_demand(
    f"\\b({MANY}) of the (?={_BLOCKS}\\b){NO_NUMBER}\\b(?:the|those) (?:other|remaining) ({MANY})\\b(?! (?:{COLOR} )?"
    "(?:patches|mats|zones|targets|areas|spots|halves|corners))"
)
_COUNTED = on_demand(f"\\b{MANY} {_BLOCKS}\\b")
_OTHER = frozenset({"other", "remaining"})


def others_counted(tokens: list[Token]) -> list[Token]:
    """The tokens with the number of all of them, where it is told of no blocks."""
    if _OTHER.isdisjoint(token.word for token in tokens):
        return tokens
    text = text_of(tokens)
    parted = _PARTED.search(text)
    if parted is None or _COUNTED.search(text) or len(_PARTED.findall(text)) > 1:
        return tokens
    at = text[: parted.end(1)].count(" ") + len(("of", "the")) + 1
    total = number(parted[1]) + number(parted[2])
    many = Token("number", str(total), str(total), tokens[at].span, float(total))
    return [*tokens[:at], many, *tokens[at:]]
