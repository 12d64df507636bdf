"""Patches of the colours of the blocks, told short, "match the colors", "put each block on its color"; and how many
there are, told last, "one block on each patch, two patches total"."""

from __future__ import annotations

from itertools import pairwise

from rpg.language import lexicon
from rpg.language.phrases import length_at
from rpg.language.tokens import Token

_STOPS = frozenset({".", "!", ";"})
_MATCH = (("match", "colors"), ("match", "the", "colors"), ("match", "up", "the", "colors"), ("match", "by", "color"),
          ("match", "the", "blocks", "to", "the", "colors"), ("match", "up", "colors"))  # fmt: skip
_OWN = (("where", "its", "color", "is"), ("on", "its", "color"), ("on", "its", "own", "color"),
        ("on", "its", "own", "color", "patch"), ("on", "its", "color", "patch"), ("on", "the", "color", "it", "has"),
        ("on", "a", "patch", "of", "the", "same", "color"), ("on", "a", "patch", "with", "the", "same", "color"),
        ("on", "a", "patch", "of", "its", "color"), ("onto", "its", "color"))  # fmt: skip
_EACH = frozenset({"each", "every"})
_PATCH = ("on", "the", "patch", "of", "its", "color")
_PARTS = frozenset({"side", "sides", "arm", "row", "column", "layer", "level", "edge"})
"""Of these a single figure has several; "each" of anything else may be told of several figures."""
_LETTERS = frozenset("LTUV")
_TOTAL = (("total",), ("in", "total"), ("altogether",), ("in", "all"))


def own_color(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens with the patch of its colour for each block."""
    begin = 0
    for end in [*(n for n, word in enumerate(words) if word in _STOPS), len(words)]:
        if tuple(words[begin:end]) in _MATCH:
            said = [tokens[begin].saying(word) for word in ("put", "each", "block", *_PATCH)]
            return [*tokens[:begin], *said, *tokens[end:]]
        begin = end + 1
    for at in range(2, len(words)):
        size = length_at(words, at, _OWN)
        closed = at + size == len(words) or words[at + size : at + size + 1] == ["."]
        if size and closed and words[at - 2] in _EACH and words[at - 1] in lexicon.BLOCK:
            return [*tokens[:at], *(tokens[at].saying(word) for word in _PATCH), *tokens[at + size :]]
    return None


def told_in_total(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """ "..., two patches total": there are two patches; "a grid, ten blocks in total" is a grid of so many."""
    end = len(words) - (words[-1:] == ["."])
    size = max((len(x) for x in _TOTAL if tuple(words[end - len(x) : end]) == x), default=0)
    noun = end - size - 1
    counted = size and noun > 2 and (words[noun - 1] in lexicon.NUMBER or tokens[noun - 1].kind == "number")
    if not counted or not (lexicon.PATCH.get(words[noun]) or lexicon.BLOCK.get(words[noun])) or words[noun - 2] != ",":
        return None
    if words[noun] in lexicon.BLOCK and _one_figure(tokens[:noun]):
        return None
    there = [tokens[noun - 2].saying(word) for word in (".", "there", "are")]
    return [*tokens[: noun - 2], *there, *tokens[noun - 1 : noun + 1], *tokens[end:]]


def _one_figure(tokens: list[Token]) -> bool:
    """Whether a single figure is told of, or several that are listed one by one."""
    many = [lexicon.STRUCTURE[token.word][1] for token in tokens if token.word in lexicon.STRUCTURE]
    shaped = many or any(token.kind == "dims" or token.raw in _LETTERS for token in tokens)
    told_of = {after.word for each, after in pairwise(tokens) if each.word in _EACH or each.word == "per"}
    return bool(shaped) and not any(many) and told_of <= _PARTS
