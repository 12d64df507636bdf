"""Instructions with words that could be typed for several others, with each of these in their places."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import islice, product

from rpg.core.diagnostics import Diagnostic, Span
from rpg.language.slips import MIXED_UP, meant_by
from rpg.language.spelling import read_words
from rpg.language.tokens import Token
from rpg.passes.schema.respelt import Respelt

_MOST = 6
"""So many ways to mean a text are tried."""
_MISSPELT = 3
"""A text with more words that mean nothing is none that was typed in a hurry."""


def ways_meant(text: str, tokens: Sequence[Token], why: Sequence[Diagnostic]) -> Iterator[tuple[Respelt, list[str]]]:
    """The text as it may be meant, the likeliest first, each with notes of how its words are read. `why`: what is told
    of the text as it was typed."""
    strange = [found.span for found in why if found.code == "unknown-word" and "word" in found.facts and found.span]
    if strange and len(strange) == len(why) and len(strange) <= _MISSPELT:
        found = _of_the_unknown(tokens, {*strange})
    elif why[0].code in _OUT_OF_PLACE:
        found = _of_the_mixed_up(tokens, why[0].span)
    else:
        return
    for meant in islice(found, _MOST):
        words, notes, _ = read_words(meant)
        typed = {token.span: token.raw for token in tokens}
        said = [f"read {typed[t.span]!r} as {t.raw!r}" for t, was in zip(meant, tokens, strict=True) if t is not was]
        yield Respelt.of(text, words, tokens), [*said, *notes]


_OUT_OF_PLACE = frozenset({"misplaced-word", "incomplete"})


def _of_the_unknown(tokens: Sequence[Token], strange: set[Span]) -> Iterator[list[Token]]:
    """The tokens with known words for the unknown ones."""
    places = [n for n, token in enumerate(tokens) if token.span in strange]
    choices = [meant_by(tokens[n].word) for n in places]
    if len(places) < len(strange):
        return
    for chosen in sorted(product(*choices), key=lambda ways: sum(cost for cost, _ in ways)):
        yield _said(tokens, {n: word for n, (_, word) in zip(places, chosen, strict=True)})


def _of_the_mixed_up(tokens: Sequence[Token], span: Span | None) -> Iterator[list[Token]]:
    """The tokens with another word for the one that does not fit, or for one beside it."""
    at = next((n for n, token in enumerate(tokens) if span and token.span[1] > span[0]), None)
    for n in () if at is None else (at, at - 1, at + 1):
        if 0 <= n < len(tokens) and tokens[n].word in MIXED_UP:
            yield _said(tokens, {n: MIXED_UP[tokens[n].word]})


def _said(tokens: Sequence[Token], words: dict[int, str]) -> list[Token]:
    return [replace(t, word=words[n], raw=words[n]) if n in words else t for n, t in enumerate(tokens)]
