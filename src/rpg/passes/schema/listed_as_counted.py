"""Symbols that are listed behind their number: "the four cubes A, B, C and D" are one of each."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise, takewhile

from rpg.ir.assets import FACES, SemanticCube
from rpg.ir.schema import TaskSchema
from rpg.language import lexicon
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_NOUNS = frozenset({*lexicon.BLOCK, "letters", "digits", "numbers", "symbols"})


def check_listed_as_counted(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse "the four cubes A, B, C and D" as four cubes that show an A, and others."""
    for n, (number, noun) in enumerate(pairwise(words)):
        if number.many < 2 or noun.word not in _NOUNS or not noun.word.endswith("s"):
            continue
        listed = [*takewhile(_symbol_or_joint, words[n + 2 :])]
        symbols = [token.raw.upper() for token in listed if token.word not in _JOINTS]
        if len(symbols) != number.many:
            continue
        there = sum(symbols[0] in map(block.symbol, FACES) for block in task.blocks if isinstance(block, SemanticCube))
        if there > symbols.count(symbols[0]):
            raise refuse("ambiguous", f"it is not clear which the {number.word} {noun.word} are", number.span,
                         "list them in a sentence of their own: 'There are four blocks A, B, C and D.'")  # fmt: skip


_JOINTS = frozenset({",", "and", "or"})


def _symbol_or_joint(token: Token) -> bool:
    return token.word in _JOINTS or (len(token.raw) == 1 and token.raw.isalnum())
