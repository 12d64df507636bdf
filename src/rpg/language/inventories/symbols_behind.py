"""Which symbols there are, told behind a colon where all else is told of classes of them: "the odd numbers form a row,
the even numbers a tower: 1 to 6"."""

from __future__ import annotations

from rpg.language.grammar.rows.parting import STOPS, sentences
from rpg.language.inventories.labels import labels_at
from rpg.language.tokens import Token

_CLASSES = frozenset({"vowel", "vowels", "consonant", "consonants", "odd", "even", "odds", "evens"})
_KINDS = frozenset({"letters", "digits", "numbers"})
_TOLD = frozenset({"greater", "larger", "bigger", "higher", "less", "smaller", "lower", "above", "below", "under",
                   "over", "after", "before", "more"})  # fmt: skip


def symbols_behind(tokens: list[Token]) -> list[Token] | None:
    """The words with the symbols that there are in front of them; None where none are listed so, or they are the order
    in which the blocks of one class are to stand."""
    words = {token.word for token in tokens}
    if words.isdisjoint(_CLASSES) and (words.isdisjoint(_KINDS) or words.isdisjoint(_TOLD)):
        return None
    for part in sentences(tokens):
        colon = next((n for n, token in enumerate(part) if token.word == ":"), 0)
        end = len(part) - (part[-1].word in STOPS) if part else 0
        for labels, last in labels_at(part, colon + 1) if colon else ():
            if last == end and len(labels) > 1:
                listed = [word for token in labels for word in (token, token.saying(","))][:-1]
                there = [part[0].saying("there"), part[0].saying("are"), *listed, part[0].saying(".")]
                rest = [token for token in tokens if not part[colon].span[0] <= token.span[0] < part[end - 1].span[1]]
                return [*there, *rest]
    return None
