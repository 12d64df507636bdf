"""Sentences in the order of words of a specification, as rows that turn them into plain ones."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from functools import cached_property, lru_cache

from rpg.language.grammar.rows.parting import STOPS
from rpg.language.lexicon import COMMANDS
from rpg.language.needs import needed
from rpg.language.tokens import Token

Turn = tuple[str, str]
"""What is looked for in a sentence, and what is said instead; "{1}" is the first group, "{1s}" several of it."""
_SIGNS = frozenset("+*/=")
"""What cubes show; a dash may stand between two words as well."""
_MOST = 4
"""No sentence is turned more often by the same row."""
_SETS = 4
"""As many sets of parts of words at most are looked at for every row."""
_MOST_WORDS = 4096
"""Words of which it is remembered what they do for the rows."""


class Turns:
    """Rows in their order, found by what the words of a text have in them where they fit."""

    def __init__(self, rows: Sequence[Turn]) -> None:
        self.rows = tuple(rows)
        self._held: dict[str, int] = {}

    @cached_property
    def _by_part(self) -> tuple[dict[str, int], int]:
        """What each part of a word does for the rows, as bits: as many for every row as there may be sets of parts that
        it needs one of; and the bits of the sets that no row needs."""
        found: dict[str, int] = {}
        spare = (1 << len(self.rows) * _SETS) - 1
        for number, (row, _) in enumerate(self.rows):
            for nth, parts in enumerate(needed(row)[:_SETS]):
                bit = 1 << nth * len(self.rows) + number
                spare ^= bit
                for part in parts:
                    found[part] = found.get(part, 0) | bit
        return found, spare

    def _holding(self, word: str) -> int:
        """What a word does for the rows: all that its parts do."""
        held = self._held.get(word)
        if held is None:
            if len(self._held) >= _MOST_WORDS:
                self._held.clear()
            held = 0
            for part, bits in self._by_part[0].items():
                if part in word:
                    held |= bits
            self._held[word] = held
        return held

    def fitting(self, told: Told, behind: int = -1) -> list[int]:
        """The rows behind a certain one that may fit somewhere in a text."""
        held = self._by_part[1]
        for word in {word for _, _, words, _ in told for word in words}:
            held |= self._holding(word)
        size = len(self.rows)
        fit = (1 << size) - 1
        for nth in range(_SETS):
            fit &= held >> nth * size
        fit = fit >> behind + 1 << behind + 1
        found = []
        while fit:
            found.append((fit & -fit).bit_length() - 1)
            fit &= fit - 1
        return found


Spans = Iterable[tuple[int, int]]
"""Where parts of a text begin and end."""


def sentences_of(tokens: list[Token]) -> Spans:
    """The sentences, without their stops."""
    begin = 0
    for n, token in enumerate(tokens):
        if token.kind == "punct" and token.word in STOPS:
            yield begin, n
            begin = n + 1
    yield begin, len(tokens)


def all_of_it(tokens: list[Token]) -> Spans:
    """The whole text, stops and all."""
    return [(0, len(tokens))]


def turned(tokens: list[Token], turns: Turns, parted: Callable[[list[Token]], Spans] = sentences_of) -> list[Token]:
    """The tokens, every sentence of them turned by whichever rows fit it, or all of them by rows across sentences."""
    told = _told(tokens, parted)
    waiting = turns.fitting(told)
    while waiting:
        number = waiting.pop(0)
        row, said = turns.rows[number]
        for _ in range(_MOST):
            changed = _once(tokens, told, _compiled(row), said, parted)
            if changed is None:
                break
            tokens, told = changed, _told(changed, parted)
            waiting = turns.fitting(told, number)
    return tokens


@lru_cache(maxsize=4096)
def _compiled(pattern: str) -> re.Pattern[str]:
    return re.compile(pattern)


Told = list[tuple[int, int, list[str], str]]
"""Where each sentence begins and ends, its words, and all of it."""


def _told(tokens: list[Token], parted: Callable[[list[Token]], Spans]) -> Told:
    words = [token.word.replace(" ", "_") or "_" for token in tokens]
    return [(begin, end, words[begin:end], " ".join(words[begin:end])) for begin, end in parted(tokens)]


def _once(
    tokens: list[Token], told: Told, pattern: re.Pattern[str], said: str, parted: Callable[[list[Token]], Spans]
) -> list[Token] | None:
    """The tokens with the first fitting sentence turned."""
    for begin, end, words, text in told:
        match = pattern.search(text)
        if match is None or not match.group() or (" . " in said and parted is sentences_of and _chooses(words)):
            continue
        starts = _starts(words)
        first, last = _covered(starts, match.span())
        plain = list(_said(tokens[begin:end], match, said, starts))
        return [*tokens[: begin + first], *plain, *tokens[begin + last :]]
    return None


def _chooses(words: list[str]) -> bool:
    """Whether one or another thing is to be done, so that what is done in one of them is no sentence of its own."""
    return any(
        after in COMMANDS and word == "or" and before not in COMMANDS
        for before, word, after in zip(words, words[1:], words[2:], strict=False)
    )


def _starts(words: list[str]) -> list[int]:
    """Where in the text each word begins."""
    starts, at = [], 0
    for word in words:
        starts.append(at)
        at += len(word) + 1
    return starts


def _covered(starts: list[int], span: tuple[int, int]) -> tuple[int, int]:
    """The first word of a stretch of text, and the one behind it."""
    inside = [n for n, at in enumerate(starts) if span[0] <= at < span[1]]
    return (inside[0], inside[-1] + 1) if inside else (0, 0)


def _said(tokens: list[Token], match: re.Match[str], said: str, starts: list[int]) -> Iterable[Token]:
    first, last = _covered(starts, match.span())
    span = (tokens[first].span[0], tokens[last - 1].span[1])
    for word in said.split():
        if not word.startswith("{"):
            if word.isdigit():
                yield Token("number", word, word, span, float(word))
                continue
            if word in _SIGNS:
                yield Token("sign", word, word, span)
                continue
            yield Token("word" if word.isalpha() else "punct", word, word, span)
            continue
        group = int(word.strip("{s}"))
        if match.group(group):
            begin, end = _covered(starts, match.span(group))
            kept = tokens[begin:end]
            if word.endswith("s}") and not kept[-1].word.endswith("s"):
                kept = [*kept[:-1], replace(kept[-1], word=kept[-1].word + "s", raw=kept[-1].raw + "s")]
            yield from kept
