"""Instructions with words that could be typed for several others, with each of these in their places."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice, pairwise, product

from rpg.core.diagnostics import Diagnostic, Span
from rpg.language.slips import MIXED_UP, meant_by
from rpg.language.spelling import read_words
from rpg.language.tokens import Token
from rpg.passes.schema.respelt import Respelt

_MOST = 6
"""So many ways to mean a text are tried."""
_MISSPELT = 3
"""A text with more words that mean nothing is none that was typed in a hurry."""
_COMPARED = frozenset({"more", "less", "fewer", "rather"})
_NEAR = 4
"""A comparison stands within so many words ahead of its "than"."""
_OUT_OF_PLACE = frozenset({"misplaced-word", "incomplete"})
"""Why a text is refused of which a word may be mended wrongly, or be mixed up with another."""


def ways_meant(
    text: str, tokens: Sequence[Token], why: Sequence[Diagnostic]
) -> Iterator[Iterator[tuple[Respelt, list[str]]]]:
    """The text as it may be meant, each with notes of how its words are read: with other words for those that mean
    nothing, or that do not fit, and then for those that were mended as well. `why`: what is told of it as it stands."""
    mended = read_words([*tokens])[0]
    strange = {told.span for told in why if told.code == "unknown-word" and "word" in told.facts and told.span}
    if not (strange and all(told.code == "unknown-word" for told in why)) and why[0].code not in _OUT_OF_PLACE:
        return
    guessed = {span for span, _ in Respelt.of(text, mended, tokens).edits}
    first = _with_others(tokens, strange) if strange else _mixed_up(tokens, why[0].span)
    for ways in (first, _with_others(tokens, strange | guessed) if guessed else ()):
        respelt = (
            Respelt.of(text, (replace(t, raw=way.get(t.span, t.raw)) for t in mended), tokens)
            for way in islice(ways, _MOST)
        )
        yield ((one, [f"read {text[slice(*span)]!r} as {word!r}" for span, word in one.edits]) for one in respelt)


def _with_others(tokens: Sequence[Token], strange: set[Span]) -> Iterator[Mapping[Span, str]]:
    """For some of the words the ones that they could be typed for."""
    words = {token.span: token.word for token in tokens if token.span in strange}
    if len(words) == len(strange) and 0 < len(strange) <= _MISSPELT:
        for chosen in sorted(product(*map(meant_by, words.values())), key=lambda ways: sum(cost for cost, _ in ways)):
            way = dict(zip(words, (word for _, word in chosen), strict=True))
            said = [(way.get(token.span, token.word), token.span in way) for token in tokens]
            if not any(a == b and (new or new_too) for (a, new), (b, new_too) in pairwise(said)):  # nor "the the"
                yield way


def _mixed_up(tokens: Sequence[Token], span: Span | None) -> Iterator[Mapping[Span, str]]:
    """Another word for the one that does not fit, or for one beside it."""
    at = next((n for n, token in enumerate(tokens) if span and token.span[1] > span[0]), None)
    for n in () if at is None else (at, at - 1, at + 1):
        if 0 <= n < len(tokens) and tokens[n].word in MIXED_UP and not _compares(tokens, n):
            yield {tokens[n].span: MIXED_UP[tokens[n].word]}


def _compares(tokens: Sequence[Token], at: int) -> bool:
    """Whether a "than" stands behind what it compares: "three more blocks than", "taller than"."""
    if tokens[at].word != "than":
        return False
    return any(t.word in _COMPARED or t.word.endswith("er") for t in tokens[max(0, at - _NEAR) : at])
