"""The second and the third reader by themselves, over the whole corpus.

`python -m tests.corpus.framed [every]` lists what the second one misreads, with `parser` ahead of the number what the
third one does. Contradictions are found only when a goal is arranged: they are listed, too.
"""

from __future__ import annotations

import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from functools import partial

from rpg.core.diagnostics import Refusal
from rpg.ir.schema import TaskSchema
from rpg.language.chat import as_typed
from rpg.language.compose import composed_ways
from rpg.language.formulas import formulas_told
from rpg.language.spelling import read_words
from rpg.language.tokens import tokenize
from rpg.passes.schema.frontend import _PLAINER, BuiltinFrontEnd
from rpg.pipeline import prepared
from tests.corpus.entries import SPLITS, Entry, load
from tests.corpus.judge import Read, Score, judge


class _Second(BuiltinFrontEnd):
    """Reads a text only as the second reader tells it."""

    def told(self, text: str) -> TaskSchema | None:
        try:
            tokens, strays = formulas_told(*tokenize(text))
            for plainer in _PLAINER:
                tokens, _ = plainer(tokens)
            words, _, wrong = read_words(tokens)
            if wrong or strays:
                return None
            return self._retold(words, text, None, 0, None, [])[0]
        except Refusal:
            return None


class _Third(BuiltinFrontEnd):
    """Reads a text only as it is parsed."""

    def told(self, text: str) -> TaskSchema | None:
        try:
            tokens, strays = formulas_told(*tokenize(text))
            words, _, wrong = read_words(as_typed(tokens))
            found = None if wrong or strays else next(composed_ways(words), None)
            if found is None:
                return None
            (plain, *_), said = found
            notes = [f"understood as: {said}"]
            return self._read_tokens((plain, []), text, None, 0, None, [], notes, again=False)[0]
        except Refusal:
            return None


READERS = {"frames": _Second, "parser": _Third}


def read(entry: Entry, reader: str) -> Read:
    """What a reader makes of an entry's text, whatever the others make of it."""
    schema = READERS[reader]().told(entry.text)
    try:
        return (prepared(schema) if schema else None), ()
    except Refusal as refusal:
        return None, tuple(refusal.diagnostics)


def scored(entry: Entry, reader: str) -> tuple[Score, str]:
    """An entry's score by a reader, and what it was retold as, if it was."""
    found: list[Read] = []

    def once(entry: Entry) -> Read:
        found.append(read(entry, reader))
        return found[-1]

    score = judge(entry, once)
    schema = found[-1][0] if found else None
    return score, schema.assumptions[0] if schema is not None else ""


def main() -> None:
    reader = "parser" if "parser" in sys.argv else "frames"
    every = next((int(word) for word in sys.argv if word.isdigit()), 1)
    entries = [entry for split in SPLITS for entry in load(split)][::every]
    counts: Counter[str] = Counter()
    with ProcessPoolExecutor(2) as pool:
        for score, text in pool.map(partial(scored, reader=reader), entries, chunksize=50):
            right = "right" if text else "right refusal" if score.entry.refuse else "refused, as it may be"
            counts[right if score.outcome == "right" else score.outcome] += 1
            if score.outcome in ("wrong", "crash"):
                print(f"{score.outcome}: {score.entry.text}\n    {text}\n    {score.why}")
    print(counts)


if __name__ == "__main__":
    main()
