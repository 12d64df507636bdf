"""Words that are told before it is said that they are to be spelt, or letter by letter: "my grandson's name is TOM, so
please write it", "today's word is CAT", "stack c a t so it reads cat"."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from rpg.language.grammar.rows.figures_asked import OF_DAY, WRITE
from rpg.language.grammar.rows.parting import STOPS
from rpg.language.patterns import on_demand
from rpg.language.tokens import Token

SPELT = frozenset({"name", "word", "nickname", "so"})
_WORD = "(?P<word>[a-z]{2,})"
_SO = "(?:(?: ,| :|;| and| so| then| now| please| kindly)+ "
_WRITE = f"{WRITE}(?: (?:out|down|up))?"
_IT = "(?:it|this|that|(?:this|that|the|his|her) (?:word|name))"
_CUBES = "(?: (?:with|in|from|using|out of) (?:the |our |my |your )?(?:letter )?(?:cubes|blocks))?"
_WHOSE = "(?:the|our|my|your|his|her|this|(?:\\w+ ){0,2}\\w+ 's)"
_READ = "(?:it|they|you|one|we|i|the (?:tower|row|stack))(?: can)? (?:reads?|spells?|says?)"
_WAY = "(?: (?:from )?(?:the )?(?:left|right|top|bottom) to (?:the )?(?:left|right|top|bottom)| downwards?| upwards?)?"
_TOLD = tuple((on_demand(f"{pattern}$"), said) for pattern, said in (
    (f"{_WHOSE} (?:new |next )?word{OF_DAY} (?:is|:) {_WORD}", "spell"),
    (f"{_WHOSE} (?:name|nickname|new word|word){OF_DAY} (?:is|:) {_WORD}{_SO}{_WRITE} (?:{_IT}|(?:the (?:word|name) )?"
     f"(?P=word))(?: (?:out|down|up))?(?P<rest>{_CUBES}{_WAY}))", "spell"),
    (f"(?P<lead>.*?)\\b(?:spell|write) {_WHOSE} (?:name|word)(?: ,)? (?:which|that) is {_WORD}(?P<rest>{_CUBES}{_WAY})",
     "spell"),
    (f"(?:(?:stack|pile)(?: up)?) (?:the )?(?:letters? )?(?P<letters>(?:\\w (?:, and |, |and )?)+\\w) (?:so|so that) "
     f"{_READ} {_WORD}(?P<rest>{_WAY})", "stacked"),
    (f"(?:put|place|lay|line up|arrange) (?:the )?(?:letters? )?(?P<letters>(?:\\w (?:, and |, |and )?)+\\w)(?: in a "
     f"row| side by side)? (?:so|so that) {_READ} {_WORD}(?P<rest>{_WAY})", "spell"),
))  # fmt: skip
"""Sentences, and how they are told again."""


def words_told(tokens: list[Token], words: list[str]) -> list[Token] | None:
    """The tokens with the word that is to be spelt."""
    begin = 0
    for end in [*(n for n, word in enumerate(words) if word in STOPS), len(words)]:
        text = " ".join(word.replace(" ", "_") or "_" for word in words[begin:end])
        for pattern, said in _TOLD:
            match = pattern.match(text)
            if match is not None and (told := _told(tokens[begin:end], text, match, said)) is not None:
                return [*tokens[:begin], *told, *tokens[end:]]
        begin = end + 1
    return None


def _told(tokens: Sequence[Token], text: str, match: re.Match[str], said: str) -> list[Token] | None:
    """The sentence told again; None where this may be no word to be spelt, or has other letters."""

    def part(name: str) -> list[Token]:
        begin, end = match.span(name) if match.groupdict().get(name) else (0, 0)
        inside = text[begin:end]
        first = text[: begin + len(inside) - len(inside.lstrip())].count(" ")
        return [*tokens[first : first + len(inside.split())]]

    word = part("word")[0]
    letters = [token.word for token in part("letters") if len(token.word) == 1 and token.word.isalpha()]
    if sorted(letters) != sorted(word.word) if letters else not word.raw.strip("\"'").isupper():
        return None  # "the word is short"
    way = part("rest")
    down = [word.saying(x) for x in ("in", "a", "tower")] if said == "stacked" else []
    return [*part("lead"), word.saying("spell"), replace(word, kind="literal", value=word.word), *down, *way]
