"""A word of letters told without saying that it is one, and the same word told again: "they start as TAR", "the blocks
spell POT; spell it backwards", "take the letters of the word TREE and write the word"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language.tokens import Token

_AS = frozenset({"as", "with"})
_ENDS = frozenset({"start", "starts", "begin", "begins", "end", "ends", "finish", "finishes", "out", "up", "off"})
_LIES = frozenset({"lies", "stands", "is", "lie", "stand"})
_SPELLS = frozenset({"spell", "spells", "read", "reads", "write", "say", "says", "spelt", "spelled"})
_IT = (("it",), ("that",), ("the", "word"), ("that", "word"), ("this", "word"), ("the", "same", "word"),
       ("the", "same"), ("this",))  # fmt: skip
_BACKWARDS = (("backwards",), ("backward",), ("in", "reverse"), ("reversed",), ("the", "other", "way", "round"),
              ("the", "other", "way", "around"), ("from", "back", "to", "front"))  # fmt: skip


def word_again(tokens: list[Token]) -> list[Token]:
    """The words with "the word" in front of one that they start or end as, and that word where "it" is spelt again."""
    words = [token.word for token in tokens]
    spelt = {token.word: token for token in tokens if token.kind in ("literal", "quote")}
    if not spelt:
        return tokens
    out: list[Token] = []
    for n, token in enumerate(tokens):
        told = token.kind == "literal" or (len(token.raw) > 1 and token.raw.isupper())
        if told and n > 1 and words[n - 1] in _AS and words[n - 2] in _ENDS:
            out += [token.saying("the"), token.saying("word")]
            token = replace(token, kind="literal", value=token.raw)
            spelt[token.word] = token
        if told and n == 0 and words[1:2] and words[1] in _LIES:
            out += [token.saying("the"), token.saying("word")]
        if token.word == "of" and n and tokens[n - 1].kind == "literal" and words[n + 1 : n + 2] in (["it"], ["them"]):
            out.append(token.saying("out"))  # "make NOT of it"
        out.append(token)
    return _again(out, *spelt.values()) if len(spelt) == 1 else out


def _again(tokens: list[Token], word: Token) -> list[Token]:
    """The words with the word itself where it is to be spelt backwards, or of the letters that are told as those of
    it."""
    words = [token.word for token in tokens]
    at = tokens.index(word)
    of_letters = words[at - 1] == "of" or words[at - 3 : at] == ["of", "the", "word"]
    for n in range(at + 1, len(words) - 1):
        if words[n] not in _SPELLS:
            continue
        it = next((it for it in _IT if tuple(words[n + 1 : n + 1 + len(it)]) == it), ())
        behind = n + 1 + len(it)
        named = "word" in it and of_letters and words[behind : behind + 1] != [word.word]
        if it and (named or any(tuple(words[behind : behind + len(way)]) == way for way in _BACKWARDS)):
            return [*tokens[: n + 1], word, *tokens[behind:]]
    return tokens
