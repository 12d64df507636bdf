"""Clauses of one sentence told in sentences of their own: "..., with the red one on the left" as "The red one must be
on the left", "so that the tallest is in the middle", "two and two blocks: the red ones go on the mat". And a sentence
about a part of what the one before it speaks of, told in one with it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rpg.language import lexicon
from rpg.language.grammar.rows.one_of_two import ONE_OF_TWO
from rpg.language.grammar.rows.parting import STOPS
from rpg.language.grammar.rows.turned import all_of_it, turned
from rpg.language.tokens import Token

_BREAKS = frozenset({",", ".", ";", ":", "!", "?", "…", "(", ")"})
_OF_ONE = frozenset({"the", "a", "an", "one", "all", "both", "no", "its", "their", "every", "each", "only",
                     *lexicon.NUMBER})  # fmt: skip
_PLACES = frozenset({"on", "in", "at", "to", "next", "behind", "under", "above", "below", "beside", "left", "right",
                     "touching", "facing", "between", "directly", "just", "exactly", "upside", "nearest", "closest",
                     "farthest"})  # fmt: skip
"""What begins to tell where something is, or how."""
_OF_THEM = frozenset({"all", "both", "none"})
_FINITE = frozenset({"is", "are", "must", "should", "shall", "has", "have"})
_GOES_ON = frozenset({"the", "but", "and", "except", "not"})
"""What begins a sentence that may be part of the one before it."""
_OF_THEIRS = frozenset({"the", "only", "all", "both", "each", "every", "no", "none"})
"""What begins to tell of blocks that are listed in front of a colon."""
MOST = 8
"""So many places at most are tried."""


def clauses_apart(tokens: Sequence[Token]) -> Iterator[list[Token]]:
    """The words parted, or joined, at one place: each place where that may be meant, from the left."""
    words = [token.word for token in tokens]
    told = turned([*tokens], ONE_OF_TWO, all_of_it)
    yield from [told] if told != tokens else []
    for at in range(1, len(tokens) - 2):
        yield from _told_with(tokens, words, at)
        yield from _so_that(tokens, words, at)
        yield from _behind_a_mark(tokens, words, at)
        yield from _of_all(tokens, words, at)


def _told_with(tokens: Sequence[Token], words: list[str], at: int) -> Iterator[list[Token]]:
    """ "..., with the red one on the left": the red one must be on the left."""
    if words[at] != "with" or words[at + 1] not in _OF_ONE:
        return
    ends = (n for n in range(at + 2, len(words)) if words[n] in _BREAKS or words[n] in _PLACES)
    place = next(ends, len(words))
    if place < len(words) - 1 and words[place] in _PLACES:
        before = tokens[: at - (words[at - 1] == ",")]
        said = [tokens[place].saying("must"), tokens[place].saying("be")]
        yield [*before, tokens[at].saying("."), *tokens[at + 1 : place], *said, *tokens[place:]]


def _so_that(tokens: Sequence[Token], words: list[str], at: int) -> Iterator[list[Token]]:
    """ "... so that the biggest is on top": the biggest is on top."""
    if words[at] in ("so", "such") and words[at + 1] == "that":
        yield [*tokens[: at - (words[at - 1] == ",")], tokens[at].saying("."), *tokens[at + 2 :]]


def _behind_a_mark(tokens: Sequence[Token], words: list[str], at: int) -> Iterator[list[Token]]:
    """Behind a colon, a comma with "and", or what tells of a part in a sentence that follows."""
    if words[at] == ":" and words[at + 1] in _OF_THEIRS:
        yield [*tokens[:at], tokens[at].saying("."), *tokens[at + 1 :]]
    if words[at] == "," and words[at + 1] == "and":
        yield [*tokens[:at], tokens[at].saying("."), *tokens[at + 2 :]]
    if words[at] in STOPS and words[at + 1] in _GOES_ON:
        yield [*tokens[:at], tokens[at].saying(","), *tokens[at + 1 :]]


def _of_all(tokens: Sequence[Token], words: list[str], at: int) -> Iterator[list[Token]]:
    """ "..., all of them on the mat": all of them must be on the mat."""
    if words[at] != "," or words[at + 1] not in _OF_THEM:
        return
    behind = at + 4 if words[at + 2 : at + 4] in (["of", "them"], ["of", "which"], ["of", "these"]) else at + 2
    if behind < len(words) and words[behind] not in _FINITE:
        said = [tokens[at + 1].saying(word) for word in ("of", "them", "must", "be")]
        yield [*tokens[:at], tokens[at].saying("."), tokens[at + 1], *said, *tokens[behind:]]
