"""Colours that are left open: "three cubes of one colour and three of another" are of two that are chosen here."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

CHOSEN = ("red", "blue", "green", "yellow", "purple", "orange", "cyan", "pink")
"""The colours that are taken, in this order, where they are not named in the text."""
_COLORS = ("color", "hue")
_FIRST = tuple(("of", one, color) for one in ("one", "a") for color in _COLORS)
_MORE = tuple(
    ("of", *which, *color)
    for which in (("another",), ("a", "second"), ("a", "different"), ("the", "other"), ("a", "third"))
    for color in (("color",), ("hue",), ())
)
"""What colours that are not named are told by, the first of them and each other one."""


def with_colors(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens with a colour for each number of blocks of which it is only said that they have one of their own."""
    words = [token.word for token in tokens]
    if words.count("of") < 2 or set(words).isdisjoint(_COLORS):
        return tokens, []
    found = [(n, k) for n in range(1, len(words)) if (k := length_at(words, n, _MORE if _begun(words, n) else _FIRST))]
    spots = [(_number(tokens, n), n, n + k) for n, k in found]
    if len(spots) < 2 or any(at < 0 for at, _, _ in spots):
        return tokens, []
    free = [hue for hue in CHOSEN if hue not in {lexicon.COLOR.get(word) for word in words}]
    out: list[Token] = []
    begin = 0
    for hue, (at, behind, end) in zip(free, spots, strict=False):
        noun = tokens[at + 1 : behind] or [tokens[at].saying("blocks")]
        out += [*tokens[begin : at + 1], tokens[at].saying(hue), *noun]
        begin = end
    chosen = " and ".join(free[: len(spots)])
    return [*out, *tokens[begin:]], [f"the colours are left open: {chosen}"]


def _begun(words: list[str], n: int) -> bool:
    return any(length_at(words, k, _FIRST) for k in range(1, n))


def _number(tokens: list[Token], n: int) -> int:
    """Where the number stands of the blocks behind which this is said; -1 if there is none."""
    at = n - 1
    while at > 0 and (tokens[at].word in lexicon.BLOCK or tokens[at].word in ("ones", "plain")):
        at -= 1
    return at if tokens[at].many > 0 else -1
