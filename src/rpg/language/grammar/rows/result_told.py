"""Sums told by their result: "the sum must give 9: use the cubes 4, 5, +, = and 9"."""

from __future__ import annotations

from rpg.language.grammar.rows.parting import sentences
from rpg.language.tokens import Token

_SUM = frozenset({"sum", "addition", "equation", "calculation", "total", "result"})
_GIVES = frozenset({"give", "gives", "giving", "is", "be", "equals", "equal", "equalling", "makes", "make", "making"})
_FILLING = frozenset({
    "the", "their", "a", "an", "and", ",", ":", ";", ".", "must", "should", "shall", "has", "to", "that", "which",
    "whose", "with", "from", "using", "use", "of", "out", "take", "make", "build", "form", "lay", "write", "cube",
    "cubes", "block", "blocks", "digit", "digits", "number", "numbers", "symbol", "symbols", "sign", "signs",
    "these", "please", "i", "want", "need",
})  # fmt: skip
"""What may be said around it; with other words it may ask for more."""


def result_told(tokens: list[Token]) -> list[Token]:
    """The tokens with a true equation of what is listed, where it cannot but have the result that is told: the sum of
    all the other numbers."""
    if _SUM.isdisjoint(token.word for token in tokens):
        return tokens
    out: list[Token] = []
    for sentence in sentences(tokens, frozenset({".", "!", "?"})):
        out += _of_its_cubes(sentence) or sentence
    return out


def _of_its_cubes(tokens: list[Token]) -> list[Token] | None:
    words = [token.word for token in tokens]
    told = next((n for n in range(1, len(words)) if words[n - 1] in _GIVES and tokens[n].many), 0)
    cubes = [n for n, token in enumerate(tokens) if n != told and (token.many or token.kind == "sign")]
    besides = {word for n, word in enumerate(words) if n not in (told, *cubes)}
    if not told or not besides <= _SUM | _GIVES | _FILLING or _SUM.isdisjoint(besides):
        return None
    numbers = [tokens[n].many for n in cubes if tokens[n].many]
    signs = sorted(words[n] for n in cubes if not tokens[n].many)
    if signs != sorted([*"+" * (len(numbers) - 2), "="]) or sum(numbers) != 2 * tokens[told].many:
        return None
    if tokens[told].many not in numbers:
        return None
    say = tokens[0].saying
    listed = [part for n in cubes for part in (tokens[n], say(","))][:-1]
    return [*map(say, ("make", "a", "true", "equation", "from")), *listed, say(".")]
