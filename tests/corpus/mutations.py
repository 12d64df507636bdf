"""Sentences with one word changed, and why some say the same: `python -m tests.corpus.mutations [COUNT] [SEED]`.

A word that can be another one without a change of the task was not read, in one of the two sentences. Where both mean
the same there is a reason that holds of all sentences of the kind; each of these is named below.
"""

from __future__ import annotations

import re
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from random import Random

from rpg.ir.schema import TaskSchema
from rpg.language import lexicon
from rpg.passes.schema.ambiguity import same
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.corpus.entries import SPLITS, load

_PAIRS = (
    "left/right leftmost/rightmost front/back behind/above far/near farther/nearer top/bottom topmost/bottommost "
    "upper/lower first/last highest/lowest above/below row/column rows/columns inside/outside ascending/descending "
    "even/odd both/neither and/or largest/smallest biggest/smallest vertical/horizontal vertically/horizontally "
    "tower/row towers/rows starts/ends begins/ends clockwise/counterclockwise vowels/consonants letters/digits "
    "high/long least/most with/without circle/square pyramid/wall after/before never/always edge/corner "
    "middle/corner touching/near on/behind"
)
SWAPPED = {a: b for pair in _PAIRS.split() for a, b in (pair.split("/"), pair.split("/")[::-1])}
DROPPED = frozenset({"not", "never", "no", "alternating", "evenly", "upside", "reverse", "except", "without"})
_COUNTS = ["one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"]

SAYS_THE_SAME = {
    "a number that only counts sentences, tasks or levels": r"(?:step|stage|no\.|#|level|requirement|task|item) ?\["
    r"|\[\w+>\w+\]\)",
    "columns and rows are told by the way in which they run": r"(?=.*\[(?:column|row)>).*"
    r"(?:front to back|nearest|away|towards)",
    "what is sorted in two kinds, one or the other": r"(?:vowel|odd|letter|even)s? \[(?:and>or|or>and)\]",
    "measures with a limit, or with a tolerance": r"\[or>and\] (?:more|less|minus|take)",
    "none of two is neither of them": r"(?=.*(?:\b(?:neither|nor|not|no)\b|n't)).*\[(?:or>and|and>or)\]",
    "the far left of a line is its left": r"\[(?:far>near|near>far)\] (?:left|right)",
    "what reads the same from both ends": r"again|alternat|symm|mirror|both ends|checker|either (?:end|direction)",
    "left is what remains": r"\[left>right\] (?:on|in|over|out|alone|behind|where)",
    "a wall is as wide as it is long, and a tower as high": r"\[(?:long|high)>\w+\]",
    "what is taken back": r"\].*(?:, no,|no wait|no sorry|sorry,|wait,|i mean|make that)",
    "what is taken apart before anything else is done": r"(?:unstack|apart)\b.*\[(?:first|last)>",
}
"""Reasons for which another word says the same, with what the changed sentences look like: [word>other word]."""


def mutants(text: str) -> Iterator[tuple[str, str]]:
    """Each sentence with one word changed, and the same with the change marked, in lower case."""
    words = list(re.finditer(r"[A-Za-z]+|\d+", text))
    said = {lexicon.COLOR.get(found.group().lower()) for found in words}
    free = next(color for color in lexicon.COLORS if color not in said)
    for found in words:
        word = found.group().lower()
        other = SWAPPED.get(word) or (free if word in lexicon.COLOR else None)
        other = "" if word in DROPPED else other
        if word in _COUNTS[1:-1]:
            other = _COUNTS[_COUNTS.index(word) + 1]
        elif word.isdigit():
            other = str(int(word) + 1)
        if other is not None:
            before, after = text[: found.start()], text[found.end() :]
            yield f"{before}{other}{after}", f"{before}[{word}>{other}]{after}".lower()


def reason(marked: str) -> str | None:
    """Why a changed sentence may say the same."""
    return next((why for why, form in SAYS_THE_SAME.items() if re.search(form, marked)), None)


def read(text: str) -> TaskSchema | None:
    """The task of a sentence that is read."""
    return BuiltinFrontEnd().read(text)[0]


def unread(text: str) -> list[str]:
    """The changes of a sentence that change nothing, and of which no reason is known, marked."""
    task = read(text)
    if task is None:
        return []
    found = [(marked, read(changed)) for changed, marked in mutants(text) if reason(marked) is None]
    return [marked for marked, other in found if other is not None and same(task, other)]


def sample(count: int, seed: int, splits: Sequence[str] = SPLITS) -> list[str]:
    """Sentences that are to be read."""
    texts = sorted({entry.text for split in splits for entry in load(split) if not entry.refuse})
    return Random(seed).sample(texts, count)


def main(count: int, seed: int) -> None:
    """Print the words that were not read."""
    kinds: Counter[str] = Counter()
    for text in sample(count, seed):
        for marked in unread(text):
            kinds[marked[marked.index("[") : marked.index("]") + 1]] += 1
            print(marked.replace("\n", " "))
    print(kinds.most_common())


if __name__ == "__main__":
    numbers = [int(argument) for argument in sys.argv[1:]]
    main(numbers[0] if numbers else 200, numbers[1] if len(numbers) > 1 else 0)
