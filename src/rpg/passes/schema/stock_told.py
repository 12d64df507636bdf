"""How many cubes of a letter there are or may be used: "spell HELLO but use only one L cube"."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from rpg.ir.schema import TaskSchema
from rpg.language import lexicon
from rpg.language.tokens import Token
from rpg.passes.schema.resolve.things.world import refuse

_USED = frozenset({"use", "using"})
_ONE = frozenset({"a", "an"})
_SHOWING = frozenset({"with", "showing", "bearing"})
_LED = frozenset({"a", "an", "the", "letter", "digit", "number"})


def check_stock(words: Sequence[Token], task: TaskSchema) -> None:
    """Refuse a task with more cubes of a letter than are told of: "there is one O block. Spell NOON"; or with a letter
    that is none of those that alone may be used: "spell CAB. Use only the letters A and B"."""
    for label in _others(words, task):
        raise refuse("count-mismatch", "these letters are not enough", label.span, "name each letter that is needed")
    told: Counter[str] = Counter()
    where: dict[str, Token] = {}
    for number, label in _numbered(words):
        told[label.raw] += number
        where.setdefault(label.raw, label)
    for symbol, label in where.items():
        there = sum(getattr(block, "label", None) == symbol for block in task.blocks)
        if there > told[symbol]:
            raise refuse("count-mismatch", f"{there} of these blocks are needed", label.span,
                         f"say how many may be used: at least {there}")  # fmt: skip


def _others(words: Sequence[Token], task: TaskSchema) -> Iterator[Token]:
    """The last of the letters that alone may be used, where the task has another one."""
    for begin, end in _of_stock(words):
        only = next((n for n in range(begin, end) if words[n].word == "only"), end)
        letters = [word for word in words[only:end] if _is_label(word)]
        many = next((n for n in range(only, end) if words[n].word in ("letters", "digits", "numbers")), 0)
        there = {label for block in task.blocks if (label := getattr(block, "label", None))}
        if many and letters and not there <= {word.raw for word in letters}:
            yield letters[-1]


def _numbered(words: Sequence[Token]) -> Iterator[tuple[int, Token]]:
    """Numbers of cubes of one letter where it is told what there is: "one O block", "two blocks with an L on them"."""
    for begin, end in _of_stock(words):
        for n in range(begin, end - 1):
            number = 1 if words[n].word in _ONE else lexicon.NUMBER.get(words[n].word, 0)
            shown = n + 1 if _is_label(words[n + 1]) else _shown_on(words, n + 1, end)
            if number and shown and words[n - 1].word not in _SHOWING:
                yield number, words[shown]


def _of_stock(words: Sequence[Token]) -> Iterator[tuple[int, int]]:
    """From where to where it is told which blocks there are or may be used."""
    for n in range(len(words) - 2):
        there = words[n].word == "there" and words[n + 1].word in ("is", "are")
        if there or words[n].word in _USED:
            end = next((k for k in range(n, len(words)) if words[k].word in (".", "!", "?", ";", ":")), len(words))
            yield n + 1, end


def _is_label(token: Token) -> bool:
    return len(token.raw) == 1 and token.raw.isupper()


def _shown_on(words: Sequence[Token], at: int, end: int) -> int:
    """Where the letter stands in "block with (the letter) L"; 0 where none does."""
    if words[at].word not in lexicon.BLOCK or at + 2 >= end or words[at + 1].word not in _SHOWING:
        return 0
    shown = next((n for n in range(at + 2, end) if words[n].word not in _LED or _is_label(words[n])), end)
    return shown if shown < end and _is_label(words[shown]) else 0
