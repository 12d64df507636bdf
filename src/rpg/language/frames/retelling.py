"""A text told again by the one family that knows all of its parts."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from rpg.language import lexicon
from rpg.language.frames import relations, tower
from rpg.language.frames.pieces import Pattern, Piece, Unclear, cut
from rpg.language.tokens import Token, tokenize

FAMILIES: tuple[tuple[Sequence[Pattern], Callable[[Sequence[Piece]], str]], ...] = (
    (tower.PATTERNS, tower.told),
    (relations.PATTERNS, relations.told),
)
"""The patterns of each family, and how it tells its pieces again (or raises Unclear)."""
_ENDS = frozenset({".", "!", "?", ";"})
_LEADS = frozenset({"please", "then", "now", "you", "to", ",", "and", "first", "just", "should"})
"""Behind these a command may begin."""
_BINDING = frozenset({
    "another", "other", "others", "same", "again", "after", "afterwards", "before", "then", "first", "finally", "next",
    "initial", "initially", "start", "starting", "begin", "beginning", "goal", "end", "until", "or", "if", ":",
})  # fmt: skip
"""With these, sentences do not stand for themselves."""
_MOST = 120
"""Longer texts are not told again."""


def retold(tokens: list[Token]) -> Iterator[tuple[list[Token], str]]:
    """The text in plain sentences, and the words of that: all of it, or its first or last part, where the other part
    is left as it is. Most of the text comes first. Told words stand where what they tell again stands."""
    if not 0 < len(tokens) <= _MOST:
        return
    if (whole := plainly(tokens)) is not None:
        yield _standing(whole, tokens), whole
        return
    if not _BINDING.isdisjoint(token.word for token in tokens):
        return
    parts = [(ahead, behind) for ahead, behind in _parted(tokens) if commands(ahead) or not commands(behind)]
    for ahead, behind in reversed(parts):
        if (first := plainly(ahead)) is not None:
            yield [*_standing(first, ahead), *behind], f"{first} {_text(behind)}"
    for ahead, behind in parts:
        if (last := plainly(behind)) is not None:
            yield [*ahead, *_standing(last, behind)], f"{_text(ahead)} {last}"


def plainly(tokens: Sequence[Token]) -> str | None:
    """What the one family that knows all the words says of them; None where none does, or several differ."""
    found = set()
    for known, told in FAMILIES:
        pieces = cut(tokens, known)
        try:
            found |= {told(pieces)} if pieces else set()
        except Unclear:
            continue
    return found.pop() if len(found) == 1 else None


def commands(tokens: Sequence[Token]) -> bool:
    """Whether a sentence asks for something to be done; one that only describes may tell of the start."""
    begins = [0, *(n + 1 for n, token in enumerate(tokens) if token.word in _ENDS or token.word in _LEADS)]
    return any(_asks(tokens[n]) for n in begins if n < len(tokens))


def _asks(token: Token) -> bool:
    return any(tense == "base" for _, _, tense in lexicon.VERB.get(token.word, ()))


def _parted(tokens: list[Token]) -> Iterator[tuple[list[Token], list[Token]]]:
    """The text in two parts of whole sentences."""
    for n in range(1, len(tokens) - 1):
        if tokens[n].word in _ENDS:
            yield tokens[: n + 1], tokens[n + 1 :]


def _standing(text: str, told: Sequence[Token]) -> list[Token]:
    span = (told[0].span[0], told[-1].span[1])
    return [replace(token, span=span) for token in tokenize(text)[0]]


def _text(tokens: Sequence[Token]) -> str:
    return " ".join({token.span: token.raw for token in tokens}.values())

