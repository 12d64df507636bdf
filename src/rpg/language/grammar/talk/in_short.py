"""Words typed in short, which one letter may be as well: "red n blue", "can u", "there r two", "so its behind"."""

from __future__ import annotations

from dataclasses import replace

from rpg.language import lexicon
from rpg.language.tokens import Token

_STOPS = frozenset({".", "!", "?", ";"})
_STANDING = frozenset({"behind", "on", "in", "next", "under", "above", "between", "near", "touching", "at", "beside"})
"""After these "its" was meant as "it is"."""
_NAMED = frozenset({
    "a", "an", "not", "only", "just", "there", "on", "in", "under", "at", "above", "between", "beside", "behind",
    "done", "finished", "ready", "important", "easy", "ok", "okay", "fine", "supposed", "meant", "standing", "lying",
    "sitting", "already", "still", "also", "now", "placed", "really", "too",
})  # fmt: skip
"""Before these "its" was meant as "it is" wherever it stands."""
_BESIDE = (["to", "the"], ["right", "of"], ["left", "of"])
"""Before these "its" was meant so behind what it is to be."""
_POSED = {"sat": "sitting", "stood": "standing"}
"""In some places things "are sat" on each other."""
_ADDRESSED = frozenset({"can", "could", "would", "will", "if", "do", "want", "need", "when", "once", "should", "must"})
_THINGS = (lexicon.COLOR, lexicon.COLOR_PLURAL, lexicon.BLOCK, lexicon.PATCH, lexicon.NUMBER)
_DETERMINERS = frozenset({"the", "a", "an", "two", "both", "its", "one", "each", "every", "no"})
_PLURAL = frozenset({"there", "they", "these", "those"})
_PLACES = frozenset({"top", "bottom", "left", "right", "middle"})
_SHOWN = frozenset({"letter", "letters", "spell", "word", "and", "cube", "cubes", "block", "blocks", "symbol", "name"})
"""Before a "w" that is a letter."""


def meant(tokens: list[Token], at: int) -> list[Token]:
    """ "red n blue": "n" between two things is "and"; "can u": you; "so its behind": it is; "do me a row": make one."""
    token = tokens[at]
    after = tokens[at + 1].word if at + 1 < len(tokens) else ""
    if token.word == "either" and at and ((tokens[at + 1 :] and tokens[at + 1].kind == "literal") or after == "the"):
        named = [t.word for t in tokens[at + 1 : at + 3]] == ["the", "word"] or tokens[at + 1].kind == "literal"
        return [] if named else [token]
    beside = after in _STANDING or [t.word for t in tokens[at + 1 : at + 3]] in _BESIDE
    stands = at > 0 and tokens[at - 1].word in ("so", "that", "until") and beside
    if token.word == "its" and (stands or after in _NAMED):
        return [replace(token, word=word) for word in ("it", "is")]
    nice = [t.word for t in tokens[max(0, at - (token.word == "and")) :][:3]]
    if token.word in ("nice", "and") and nice in (["nice", "and", "close"], ["nice", "and", "tight"]):
        return []
    if token.word == "close" and at and tokens[at - 1].word in (",", "and") and after == "so":
        return []  # "next to it, close so that they touch"
    behind = [t.word for t in tokens[at + 1 : at + 3]]
    if token.word in ("is", "are") and behind[:1] == ["alternating"] and (len(behind) == 1 or behind[1] in _STOPS):
        return []  # "where black and white ones are alternating"
    if token.word == "alternating" and at and tokens[at - 1].word in ("is", "are") and (not after or after in _STOPS):
        return [token.saying("alternate")]
    if token.word in _POSED and at and tokens[at - 1].word in ("is", "are", "was", "were", "'s"):
        return [replace(token, word=_POSED[token.word])]
    if token.word == "…" and (at == 0 or tokens[at - 1].word in _STOPS):
        return []
    if token.raw == "u" and (at == 0 or tokens[at - 1].word in _ADDRESSED):
        return [replace(token, word="you")]
    if token.raw == "r" and at and tokens[at - 1].word in _PLURAL and after:
        return [replace(token, word="are")]
    if token.raw == "w" and 0 < at < len(tokens) - 1 and len(tokens[at - 1].word) > 2 and begins_thing(tokens[at + 1]):
        return [replace(token, word="with")] if tokens[at - 1].word not in _SHOWN else [token]
    if token.word == "do" and after in ("me", "us") and at + 2 < len(tokens) and begins_thing(tokens[at + 2]):
        return [replace(token, word="make")]
    if token.raw != "n" or not 0 < at < len(tokens) - 1:
        return [token]
    before = tokens[at - 1]
    thing = before.kind == "number" or any(before.word in table for table in _THINGS)
    letter = before.kind == "word" and len(before.raw) == 1 and before.raw.isupper()
    joins = after in ("the", "a", "an", "one", "two") and before.word not in (*_SHOWN, "the", "of", "on", "to")
    return [replace(token, word="and") if thing or letter or joins or before.word in _PLACES else token]


def begins_thing(token: Token) -> bool:
    """Whether a thing may begin with it."""
    letter = token.kind == "word" and len(token.raw) == 1 and token.raw.isupper()
    return letter or token.kind == "number" or any(token.word in table for table in (*_THINGS, _DETERMINERS))
