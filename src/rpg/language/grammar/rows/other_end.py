"""The other end of a line that is there: "there is a row: red, green, blue. Put the red one at the other end."; and
both ends of one that is not named: "on the left end a red block, on the right end a blue one"."""

from __future__ import annotations

import re
from itertools import pairwise

from rpg.language import lexicon
from rpg.language.grammar.rows.parting import STOPS, sentences
from rpg.language.grammar.rows.row_places import word_of
from rpg.language.tokens import Token

_OTHER = re.compile(r"(?:at|to|on|onto) (?:the|its) (?:other|opposite) (?:end|side)(?: of (?:it|the \w+))?(?= |$)")
_ENDS = {
    "row": ("at the left end", "at the right end"),
    "line": ("at the left end", "at the right end"),
    "column": ("at the front end", "at the back end"),
    "tower": ("at the bottom", "at the top"),
    "stack": ("at the bottom", "at the top"),
}
"""Where the first block of a line that is listed is, and where the last one is."""
_TURNED = frozenset({"right", "left", "back", "front", "top", "bottom", "far", "near", "not", "no"})
"""With these an order is not the one in which a line is listed, or the end is told."""


def other_end_named(tokens: list[Token]) -> list[Token]:
    """The tokens with the side of the other end, where an earlier sentence lists a line and the block that goes there
    is at an end of it."""
    out: list[Token] = []
    line: tuple[str, list[str]] | None = None
    for sentence in sentences(tokens):
        out += _told(sentence, line) if line is not None else sentence
        line = _listed(sentence) or line
    return out


_TWO_ENDS = (("left", "right"), ("right", "left"))
_PUT = frozenset({"put", "place", "lay", "set"})
_BEGUN = frozenset({"on", "at", "a", "an", "one", "the"})
_OF_WHAT = (lexicon.STRUCTURE.keys() - lexicon.BLOCK.keys()) | lexicon.PATCH.keys() | {
    "table", "desk", "word", "sum", "equation", "of", "is", "are", "must", "should", "it", *STOPS,
}  # fmt: skip
"""With these it is another line that has the ends, or more is told than what the line is made of."""


def row_with_ends(tokens: list[Token]) -> list[Token]:
    """The tokens with the row ahead whose two ends are all that is told of it."""
    said = [token.word for token in tokens if token is not tokens[-1] or token.word not in STOPS]
    sides = tuple(side for side, end in pairwise(said) if end == "end" and side in ("left", "right"))
    if sides not in _TWO_ENDS or not _OF_WHAT.isdisjoint(said):
        return tokens
    if said[0] in _PUT:
        return [*(tokens[0].saying(word) for word in ("a", "row", "with")), *tokens[1:]]
    begun = said[0] in _BEGUN or said[0] in lexicon.COLOR
    return [*(tokens[0].saying(word) for word in ("a", "row", ":")), *tokens] if begun else tokens


def _listed(sentence: list[Token]) -> tuple[str, list[str]] | None:
    """The line that a sentence tells of, and what its blocks look like from one end to the other."""
    words = [word_of(sentence, n) for n in range(len(sentence))]
    lines = [word for word in words if word in _ENDS]
    looks = [look for look in map(_look, words) if look]
    sure = len(lines) == 1 and _TURNED.isdisjoint(words) and len({*looks}) == len(looks) > 1
    return (lines[0], looks) if sure else None


def _look(word: str) -> str:
    return word if word[0] == "@" or word.isdigit() else lexicon.COLOR.get(word, "")


def _told(sentence: list[Token], line: tuple[str, list[str]]) -> list[Token]:
    """A later sentence, with the end named that the one block it speaks of is not at."""
    words = [word_of(sentence, n) for n in range(len(sentence))]
    other = _OTHER.search(" ".join(words))
    kind, looks = line
    moved = [look for look in map(_look, words) if look]
    if other is None or len(moved) != 1 or moved[0] not in (looks[0], looks[-1]) or not _TURNED.isdisjoint(words):
        return sentence
    begin = other.string[: other.start()].count(" ")
    end = begin + other.group().count(" ") + 1
    if end < len(words) and words[end] not in STOPS:
        return sentence
    there = _ENDS[kind][moved[0] == looks[0]]
    return [*sentence[:begin], *(sentence[begin].saying(word) for word in there.split()), *sentence[end:]]
