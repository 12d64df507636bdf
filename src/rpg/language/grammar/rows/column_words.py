"""A word that is laid along a column of the table in other words: "the letters of STAR in a column", "lay STAR out in a
column" spell it there."""

from __future__ import annotations

import re

from rpg.language.grammar.rows.parting import STOPS, sentences
from rpg.language.tokens import Token

_WORD = "word_to_be_spelled"
_LED = "(?:(?:please|can|could|would|we|you|i|want|would like|like|wish|have|see|that|to) )*"
_DO = "(?:(?:spell|write|lay|put|read|show|arrange|set|line up) )?(?:out )?"
_OF = "(?:the (?:word )?|(?:the )?(?:\\w+ )?letters of (?:the word )?)?"
_IS = "(?: out)?(?: is| are| must be| should be| lies| stands)?(?: spelled| written| laid out)?"
_TOLD = re.compile(f"{_LED}{_DO}{_OF}{_WORD}{_IS}(?: ,)?(?: in| as| into) a(?: straight| single)? column(?= |$)")


def column_words(tokens: list[Token]) -> list[Token]:
    """The tokens with such a word spelled."""
    if not any(token.word == "column" for token in tokens):
        return tokens
    out: list[Token] = []
    for sentence in sentences(tokens):
        stop = len(sentence) - (sentence[-1].word in STOPS)
        out += [*_told(sentence[:stop]), *sentence[stop:]]
    return out


def _told(said: list[Token]) -> list[Token]:
    spelt = [n for n, token in enumerate(said) if token.kind in ("literal", "quote")]
    if len(spelt) != 1:
        return said
    word = said[spelt[0]]
    met = _TOLD.match(" ".join(_WORD if n == spelt[0] else token.word for n, token in enumerate(said)))
    letters = str(word.value or word.raw)
    if met is None or not letters.isalpha() or len(letters) < 2:
        return said
    rest = said[met[0].count(" ") + 1 :]
    return [word.saying("spell"), word, *(word.saying(x) for x in ("in", "a", "column")), *rest]
