"""A word that is spelled along a column of the table: its letters in that order, "spell STAR in a column from back to
front", as on a page where nothing is said of the way."""

from __future__ import annotations

import re

from rpg.language.grammar.rows.parting import STOPS, sentences
from rpg.language.tokens import Token

_WORD = "word_to_be_spelled"
_LED = "(?:(?:please|can|could|would|we|you|i|want|would like|like|have|see|that|to) )*"
_DO = "(?:(?:spell|write|lay|put|read|show|arrange|set|line up) )?(?:out )?"
_OF = "(?:the (?:word )?|(?:the )?(?:\\w+ )?letters of (?:the word )?)?"
_IS = "(?: out)?(?: is| are| must be| should be| lies| stands)?(?: spelled| written| laid out)?"
_COLUMN = "(?: ,)?(?: in| as) a(?: straight| single)? column(?: on the table)?(?: ,)?"
_WAY = (
    "(?P<way>(?: reading| read| going| running)? ?from (?:the )?(?P<from>back|front|far end|near end) to (?:the )?\\w+"
    "(?: end)?)"
)
_FIRST = (
    "(?P<first>(?:with )?the first letter (?:is )?(?P<at>nearest(?: to (?:me|us|you))?|closest(?: to "
    "(?:me|us|you))?|at the "
    "front|farthest(?: away)?(?: from (?:me|us|you))?|at the back))"
)
_TOLD = re.compile(f"{_LED}{_DO}{_OF}{_WORD}{_IS}{_COLUMN} ?(?:{_WAY}|{_FIRST})?")


def column_words(tokens: list[Token]) -> list[Token]:
    """The tokens with the letters of such a word told one by one, and which way."""
    if not any(token.word == "column" for token in tokens):
        return tokens
    out: list[Token] = []
    for sentence in sentences(tokens):
        stop = len(sentence) - (sentence[-1].word in STOPS)
        out += [*(_told(sentence[:stop]) or sentence[:stop]), *sentence[stop:]]
    return out


def _told(said: list[Token]) -> list[Token] | None:
    spelt = [n for n, token in enumerate(said) if token.kind in ("literal", "quote")]
    if len(spelt) != 1:
        return None
    word = said[spelt[0]]
    text = " ".join(_WORD if n == spelt[0] else token.word for n, token in enumerate(said))
    met = _TOLD.fullmatch(text)
    letters = str(word.value or word.raw).upper()
    if met is None or not letters.isalpha() or len(letters) < 2:
        return None
    told = met["from"] or met["at"] or "back"
    front = told.startswith(("front", "near", "closest")) or told == "at the front"
    if met["at"] and told.startswith("farthest"):
        front = False
    way = ("from", "front", "to", "back") if front else ("from", "back", "to", "front")
    listed: list[Token] = []
    for n, letter in enumerate(letters):
        listed += [word.saying("and" if n == len(letters) - 1 else ",")] if n else []
        listed.append(Token("word", letter.lower(), letter, word.span))
    column = [word.saying(x) for x in ("in", "a", "column", *way)]
    return [*(word.saying(x) for x in ("put", "the", "letters")), *listed, *column]
