"""Signs of notes in words: "black -> far corner" goes there, "A -> B -> C" follow each other, "red + blue" are both."""

from __future__ import annotations

from rpg.language import lexicon
from rpg.language.tokens import ARROW, Token

_SIDES = frozenset({"left", "right", "top", "bottom", "front", "back", "near", "far", "low", "high", "rear"})
_PLACES = frozenset({*_SIDES, "middle", "center", "mid"})
_TOWARD = frozenset({"on", "onto", "next", "behind", "in", "into", "under", "at", "above", "below", "beside", "between",
                     "to", "atop", "over", "beneath", "inside"})  # fmt: skip
_REGIONS = frozenset({"corner", "corners", "half", "edge", "middle", "center", "side", "table", "centre"})
_MOVING = frozenset({"move", "put", "place", "bring", "take", "push", "send", "set", "carry"})
_CLOSING = frozenset({",", ";", ".", "!", "?", ":", "and", ARROW})
_MATHS = frozenset({"=", "equation", "sum", "equals", "plus", "expression", "calculation", "solve"})


def in_words(tokens: list[Token]) -> list[Token]:
    """The tokens with such signs replaced; a sign of which it is not clear what it means stays."""
    words = [token.word for token in tokens]
    if ARROW not in words and "+" not in words and "=" not in words:
        return tokens
    out: list[Token] = []
    for at, token in enumerate(tokens):
        if not 0 < at < len(tokens) - 1:
            out.append(token)
        elif token.word == ARROW:
            _arrow(tokens, words, at, out)
        elif token.word == "+" and _things(tokens, at) and _MATHS.isdisjoint(words):
            out.append(_word("and", token))
        elif token.word == "=" and words[at - 1] in _PLACES and words[at + 1] in lexicon.COLOR:
            out.append(Token("punct", ":", token.raw, token.span))
        else:
            out.append(token)
    return out


def _arrow(tokens: list[Token], words: list[str], at: int, out: list[Token]) -> None:
    token, before, after = tokens[at], words[at - 1], words[at + 1]
    end = next((k for k in range(at + 1, len(words)) if words[k] in _CLOSING), len(words))
    ahead = words[at + 1 : end]
    if before in _SIDES and after in _SIDES and len(ahead) == 1:
        if at < 2 or words[at - 2] != "from":
            out.insert(len(out) - 1, _word("from", tokens[at - 1]))
        out.append(_word("to", token))
    elif not _thing(tokens, at - 1):
        out.append(token)
    elif after in _TOWARD or (after in ("left", "right") and "of" in ahead):
        out.append(_word("goes", token))
    elif any(word in lexicon.PATCH for word in ahead) or not _REGIONS.isdisjoint(ahead):
        to = "to" if _REGIONS & {*ahead} else "on"
        begun = max((k for k in range(at) if words[k] in _CLOSING), default=-1) + 1
        goes = () if words[begun] in _MOVING or words[begun + 1] in _MOVING else ("goes",)
        out += [_word(word, token) for word in (*goes, to, *(() if after in ("the", "a", "its") else ("the",)))]
    elif _thing(tokens, at + 1) and (">" not in token.raw[:1] or not _SIDES.isdisjoint(words)):
        out += [Token("punct", ",", token.raw, token.span), _word("then", token)]
    else:
        out.append(token)


def _word(word: str, token: Token) -> Token:
    return Token("word", word, word, token.span)


def _things(tokens: list[Token], at: int) -> bool:
    """Whether blocks are named on both sides of a sign, and not numbers to be added."""
    after = at + 2 if _number(tokens[at + 1]) or tokens[at + 1].word in ("a", "an", "one") else at + 1
    return _thing(tokens, at - 1) and after < len(tokens) and _thing(tokens, after)


def _thing(tokens: list[Token], at: int) -> bool:
    token = tokens[at]
    tables = (lexicon.COLOR, lexicon.COLOR_PLURAL, lexicon.BLOCK)
    letter = token.kind == "word" and len(token.raw) == 1 and token.raw.isupper()
    return letter or any(token.word in table for table in tables) or token.word in ("one", "ones")


def _number(token: Token) -> bool:
    return token.kind == "number" or (token.kind == "word" and token.word in lexicon.NUMBER)
