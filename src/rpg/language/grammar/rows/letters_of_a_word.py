"""The letters of a word, and those of a kind among them: "the vowels of TABLE", as letters that there are, in rows that
say so."""

from __future__ import annotations

from rpg.language.grammar.rows.turned import Turn
from rpg.language.tokens import Token

_LETTERS = frozenset({"vowels", "consonants", "letters"})
_SHORTEST = 3
_SORT = "(?:vowels|consonants)"
_BOTH = f"((?:all )?(?:the )?{_SORT}(?: (?:and|from)(?: the)? {_SORT})?)"

LETTERS_OF_A_WORD: tuple[Turn, ...] = (
    (f"^(.*?)\\b{_BOTH} (?:of|in|from) the word (\\w+)\\b(?! and )(.*)$",
     "there are the letters of the word {3} . {1} {2} {4}"),
    (f"^(?:take|use|with) the letters (?:of|in|from) the word (\\w+) [:,.] (?=.*\\b{_SORT}\\b)(.+)$",
     "there are the letters of the word {1} . {2}"),
)  # fmt: skip
"""What is looked for, and what is said instead."""


def word_of_letters(tokens: list[Token]) -> list[Token]:
    """The tokens with "the vowels of the word TABLE" for "the vowels of TABLE"."""
    if not any(token.raw.islower() for token in tokens):
        return tokens
    for at in range(len(tokens) - 2):
        letters, of, word = tokens[at : at + 3]
        told = letters.word in _LETTERS and of.word in ("of", "in", "from")
        if told and word.kind == "word" and word.raw.isupper() and len(word.raw) >= _SHORTEST:
            the = [word.saying("the"), word.saying("word")]
            return [*tokens[: at + 2], *the, *tokens[at + 2 :]]
    return tokens
