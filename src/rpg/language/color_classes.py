"""Classes of colors that are told: "warm colours (red, orange, yellow) go on the left", "the dark ones are black and
brown". The blocks of these colors stand in their place, there and wherever the class is named again."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from rpg.language import lexicon
from rpg.language.called import unheard
from rpg.language.tokens import Token

_TONES = frozenset({"warm", "cool", "cold", "hot", "bright", "dark", "light", "pale", "deep", "pastel", "vivid"})
"""What is said of colors that are not named."""
_NOUNS = {**lexicon.BLOCK, "ones": True, "one": False, "colors": True, "color": False, "tones": True}
"""What has such a color, and whether it is of several."""
_MEANS = frozenset({"are", "is", ":", "=", "means", "mean"})
_STOPS = frozenset({".", ";", "!"})
_OPENED = {"(": ")", ",": ","}


@dataclass(frozen=True)
class _Class:
    """A class, and where it is told: words that stay as blocks of these colors, if `noun` is one, or are left out."""

    name: tuple[str, ...]
    colors: tuple[Token, ...]
    begin: int
    end: int
    noun: Token | None


def with_color_classes(tokens: list[Token]) -> tuple[list[Token], list[str]]:
    """The tokens with the colors of each class that is told, and notes of which these are."""
    told: list[_Class] = []
    while (found := _told(tokens)) is not None:
        told.append(found)
        blocks = _blocks(tokens, found, found.begin) if found.noun is not None else []
        tokens = [*tokens[: found.begin], *blocks, *tokens[found.end :]]
    for one in told:
        tokens = _again(tokens, one)
    notes = (f"{' '.join(one.name)!r} stands for {' and '.join(t.word for t in one.colors)}" for one in told)
    return tokens, [*notes]


def _told(tokens: Sequence[Token]) -> _Class | None:
    """The class that is told first."""
    for at in range(len(tokens)):
        noun = at
        while noun < len(tokens) and _of_tone(tokens[noun]):
            noun += 1
        if noun == at or (at and _of_tone(tokens[at - 1])):
            continue
        begins = at == 0 or tokens[at - 1].word in _STOPS or (tokens[at - 1].word == "the" and at == 1)
        named = noun < len(tokens) and tokens[noun].word in _NOUNS
        mark = noun + named
        colors, end = _colors(tokens, mark + 1)
        last = tokens[end].word if end < len(tokens) else "."
        name = tuple(t.word for t in tokens[at:noun])
        if colors and named and mark < len(tokens) and last == _OPENED.get(tokens[mark].word):
            begin, counted = _begun(tokens, at)
            if counted in (0, len(colors)) and _NOUNS[tokens[noun].word] == (len(colors) > 1):
                return _Class(name, colors, begin, end + 1, tokens[noun])
        if colors and begins and mark < len(tokens) and tokens[mark].word in _MEANS and last in _STOPS:
            return _Class(name, colors, at - (at == 1), end + 1, None)
    return None


def _of_tone(token: Token) -> bool:
    return token.word in _TONES or (token.kind == "word" and unheard(token))


def _colors(tokens: Sequence[Token], at: int) -> tuple[tuple[Token, ...], int]:
    """The colors of a list that begins there, and the position behind it."""
    found: list[Token] = []
    end = at
    while at < len(tokens) and tokens[at].word in lexicon.COLOR:
        found.append(tokens[at])
        at = end = at + 1
        while at < len(tokens) and tokens[at].word in (",", "and", "the"):
            at += 1
    return tuple(found), end


def _begun(tokens: Sequence[Token], at: int) -> tuple[int, int]:
    """Where what is said of a class begins, "all the", and the number in front of it."""
    counted = tokens[at - 1].many if at else 0
    at -= counted > 0
    while at and tokens[at - 1].word in ("the", "all"):
        at -= 1
    return at, counted


def _blocks(tokens: Sequence[Token], told: _Class, at: int, noun: Token | None = None) -> list[Token]:
    """ "The red, orange and yellow blocks"."""
    noun = noun or told.noun or tokens[at]
    kind = noun.word if noun.word in lexicon.BLOCK or noun.word in ("one", "ones") else "blocks"
    listed: list[Token] = []
    for n, color in enumerate(told.colors):
        listed += [color.saying("and" if n == len(told.colors) - 1 else ",")] if n else []
        listed.append(color)
    return [tokens[at].saying("the"), *listed, noun.saying(kind)]


def _again(tokens: list[Token], told: _Class) -> list[Token]:
    """The tokens with the colors wherever the class is named."""
    out: list[Token] = []
    at = 0
    while at < len(tokens):
        noun = at + len(told.name)
        named = tuple(t.word for t in tokens[at:noun]) == told.name and noun < len(tokens)
        if named and _NOUNS.get(tokens[noun].word) is (len(told.colors) > 1):
            while out and (out[-1].word in ("the", "all") or out[-1].many == len(told.colors)):
                out.pop()
            out += _blocks(tokens, told, at, tokens[noun])
            at = noun + 1
        else:
            out.append(tokens[at])
            at += 1
    return out
