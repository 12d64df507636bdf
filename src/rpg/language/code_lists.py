"""Lists as they stand in code: "sort [9, 5, 1, 7]", "row = [A, B, C]", "for each color in (red, green, blue): ..."."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import takewhile

from rpg.language import lexicon
from rpg.language.tokens import Token

_OPENING = {"(": ")", "[": "]"}
_LINES = frozenset({"row", "line", "column", "tower", "stack", "order", "rainbow"})
_BEFORE_ONE = frozenset({".", ";", "\n", ","})
_OUT = frozenset({"up", "out", "together"})
"""What a verb may have behind it, ahead of what it is done to."""
_EACH, _IN = frozenset({"each", "every", "all"}), frozenset({"in", "of", "from"})
_THAT = frozenset({"that", "this", "the", "its", "each"})
_MOST = 8
"""For more than so many nobody tells it once."""


def with_lists(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens with such lists as in a sentence; there is nothing to note."""
    words = {token.word for token in tokens}
    if not words.isdisjoint(("=", *_OPENING)):
        tokens = _bracketed(_equated(tokens))
    return (_for_each(tokens) if "for" in words else tokens), []


def _equated(tokens: list[Token]) -> list[Token]:
    """ "Tower = red, green, blue": what is made, and what of; no sign that a block shows."""
    out = list(tokens)
    for n in range(1, len(tokens) - 1):
        begins = n == 1 or tokens[n - 2].word in _BEFORE_ONE
        if tokens[n].word == "=" and tokens[n - 1].word in _LINES and begins:
            out[n] = Token("punct", ":", ":", tokens[n].span)
    return out


def _bracketed(tokens: list[Token]) -> list[Token]:
    """ "Place [red, blue] on the mat": the list without brackets, right behind a verb."""
    out: list[Token] = []
    at = 0
    while at < len(tokens):
        items, end = _list(tokens, at)
        before = next((token.word for token in reversed(out) if token.word not in _OUT), "")
        if items and before in lexicon.COMMANDS:
            comma = tokens[at].saying(",")
            out += [part for item in items for part in (comma, item)][1:]
            at = end
        else:
            out.append(tokens[at])
            at += 1
    return out


def _list(tokens: Sequence[Token], at: int) -> tuple[list[Token], int]:
    """The items of a list in brackets that begins there, and where it ends; none where it is no such list."""
    close = _OPENING.get(tokens[at].word)
    inside = [*takewhile(lambda token: token.word != close, tokens[at + 1 :])] if close else []
    items, commas = inside[::2], inside[1::2]
    plain = len(items) > 1 and len(inside) % 2 == 1 and all(token.word == "," for token in commas)
    if not plain or not all(map(_is_item, items)) or at + len(inside) + 1 >= len(tokens):
        return [], at
    return [_unquoted(item) for item in items], at + len(inside) + 2


def _is_item(token: Token) -> bool:
    """Whether it is what a block looks like, or shows."""
    return token.kind == "number" or len(token.word.strip("\"'")) == 1 or _unquoted(token).word in lexicon.COLOR


def _unquoted(token: Token) -> Token:
    """ "red" in quotation marks is the colour."""
    said = str(token.value).lower() if token.kind == "quote" else ""
    return token.saying(said) if said in lexicon.COLOR else token


def _for_each(tokens: list[Token]) -> list[Token]:
    """ "For each color in (red, green): put two blocks of that color on the mat": told of one after the other."""
    words = [token.word for token in tokens]
    each = words[0] == "for" and words[1:2] != [] and words[1] in _EACH
    at = 1 + each
    if words[0] != "for" or words[at + 1 : at + 2] == [] or words[at + 1] not in _IN:
        return tokens
    items, end = _list(tokens, at + 2)
    if not 1 < len(items) <= _MOST or words[end : end + 1] not in ([":"], [","], ["do"]):
        return tokens
    body = [*takewhile(lambda token: token.word != ".", tokens[end + 1 :])]
    rest = tokens[end + 1 + len(body) :]
    looks = [n for n, token in enumerate(body) if token.word in lexicon.COLOR]
    if not body or any(n + 1 == len(body) or body[n + 1].word not in lexicon.PATCH for n in looks):
        return tokens
    told = [_colored(body, item) if words[at] == "color" else _named(body, words[at], item) for item in items]
    if any(one is None for one in told):
        return tokens
    stop = tokens[end].saying(".")
    return [part for one in told if one for part in (stop, *one)][1:] + rest


def _colored(body: list[Token], color: Token) -> list[Token] | None:
    """What is said of blocks of "that color", and of others of which no color is told, of blocks of this one."""
    out: list[Token] = []
    at, told = 0, False
    while at < len(body):
        words = [token.word for token in body[at : at + 4]]
        if words[:1] in (["of"], ["in"]) and words[1] in _THAT and "color" in words[2:]:
            if out and out[-1].word not in lexicon.BLOCK:
                out.insert(-1, color)
            at, told = at + words.index("color") + 1, True
            continue
        out += [color, body[at]] if words[0] in lexicon.BLOCK else [body[at]]
        at += 1
    return out if told else None


def _named(body: list[Token], what: str, item: Token) -> list[Token] | None:
    """What is said of "it", or of "that letter", of this one."""
    out: list[Token] = []
    for token in body:
        if token.word == what and out and out[-1].word in _THAT:
            out[-1] = item
        elif token.word in ("it", what):
            out.append(item)
        else:
            out.append(token)
    return out if item in out else None
