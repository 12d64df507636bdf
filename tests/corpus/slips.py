"""Sentences with one slip of the keyboard, which make no other task: `python -m tests.corpus.slips [COUNT] [SEED]`.

What is typed with a slip is read as it was meant, or refused; words that a slip turns into another word are left out.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from random import Random

from rpg.language.spelling import vocabulary
from rpg.passes.schema.ambiguity import same
from tests.corpus.mutations import read, sample

TRIES = 3
"""Words of a sentence that are tried."""


def slipped(word: str, chance: Random) -> str:
    """A word with two letters changed round, one left out, or one typed twice."""
    at = chance.randrange(len(word) - 1)
    turned = word[:at] + word[at + 1] + word[at] + word[at + 2 :]
    return chance.choice((turned, word[:at] + word[at + 1 :], word[: at + 1] + word[at:]))


def slips(text: str, chance: Random) -> Iterator[str]:
    """The sentence with a slip in one of its longer words, but for what is to be spelt."""
    told = re.split(r"(?i)spell|writ|word", text)[0]
    words = [found for found in re.finditer(r"[A-Za-z]{4,}", told) if found.group().lower() in vocabulary()]
    for found in chance.sample(words, min(TRIES, len(words))):
        wrong = slipped(found.group(), chance)
        if wrong != found.group() and wrong.lower() not in vocabulary():
            yield text[: found.start()] + wrong + text[found.end() :]


def misread(text: str, chance: Random) -> list[str]:
    """The slips by which a sentence becomes another task."""
    task = read(text)
    if task is None:
        return []
    found = [(changed, read(changed)) for changed in slips(text, chance)]
    return [changed for changed, other in found if other is not None and not same(task, other)]


if __name__ == "__main__":
    numbers = [int(argument) for argument in sys.argv[1:]]
    seed = numbers[1] if len(numbers) > 1 else 0
    for text in sample(numbers[0] if numbers else 200, seed):
        for changed in misread(text, Random(f"{seed} {text}")):
            print(changed)
