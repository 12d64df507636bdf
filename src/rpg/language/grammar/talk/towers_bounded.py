"""How high towers may be, told behind them: "in towers, none of them higher than three" is of at most three each."""

from __future__ import annotations

from rpg.language.phrases import length_at
from rpg.language.tokens import Token

HIGHER = frozenset({"higher", "taller", "lower", "shorter"})
_TOWERS = frozenset({"towers", "stacks", "tower", "stack"})
_NONE = tuple(
    (*ahead, *none, *which, *be)
    for ahead in ((",", "and"), (",", "with"), (",",), ("with",), (".",), (";",), ("and",), (":",))
    for none in (("none",), ("neither",), ("no", "tower"), ("no", "stack"), ("no", "one"), ("not", "one"))
    for which in ((), ("of", "them"), ("of", "which"), ("of", "these"), ("of", "the", "towers"),
                  ("of", "the", "stacks"), ("tower",), ("stack",), ("of", "the", "two"))
    for be in ((), ("is",), ("are",), ("being",), ("may", "be"), ("should", "be"), ("must", "be"), ("can", "be"),
               ("shall", "be"), ("is", "allowed", "to", "be"))
)  # fmt: skip
_NO = ("no", "not")
_UNITS = frozenset({"blocks", "cubes", "block", "cube", "bricks", "boxes", "floors", "levels", "layers"})


def towers_bounded(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The towers with the bound as of each of them."""
    for at in (n for n, word in enumerate(words) if word in HIGHER and words[n + 1 : n + 2] == ["than"]):
        begin = next((n for n in range(at) if n + length_at(words, n, _NONE) == at), 0)
        begin = begin or (at - 1 if words[at - 1] in _NO else 0)
        number = at + 2
        if not begin or _TOWERS.isdisjoint(words[:begin]) or number >= len(words) or tokens[number].many < 1:
            continue
        end = number + 1
        end += end < len(words) and words[end] in _UNITS
        end += end < len(words) and words[end] in ("high", "tall", "each")
        most = "most" if words[at] in ("higher", "taller") else "least"
        each = [",", "each", "at", most]
        if words[begin - 1] in ("towers", "stacks") and words[begin] in _NO:
            each = ["of", "at", most]
        said = [tokens[begin].saying(word) for word in each]
        high = [tokens[number].saying("blocks"), tokens[number].saying("high" if each[0] == "," else "each")]
        return [*tokens[:begin], *said, tokens[number], *high, *tokens[end:]]
    return None
