"""The second reader by itself: `python -m tests.corpus.framed [every]` lists what it misreads of the whole corpus."""

from __future__ import annotations

import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor

from rpg.core.diagnostics import Refusal
from rpg.ir.schema import TaskSchema
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


def read(entry: Entry) -> Read:
    """What the second reader makes of an entry's text, whatever the first makes of it."""
    schema = _Second().told(entry.text)
    try:
        return (prepared(schema) if schema else None), ()
    except Refusal as refusal:
        return None, tuple(refusal.diagnostics)


def scored(entry: Entry) -> tuple[Score, str]:
    """An entry's score, and what it was retold as, if it was."""
    found: list[Read] = []

    def once(entry: Entry) -> Read:
        found.append(read(entry))
        return found[-1]

    score = judge(entry, once)
    schema = found[-1][0] if found else None
    return score, schema.assumptions[0] if schema is not None else ""


def main() -> None:
    every = int(sys.argv[1]) if len(sys.argv) > 1 else 1
    entries = [entry for split in SPLITS for entry in load(split)][::every]
    counts: Counter[str] = Counter()
    with ProcessPoolExecutor(2) as pool:
        for score, text in pool.map(scored, entries, chunksize=50):
            right = "right" if text else "right refusal" if score.entry.refuse else "refused, as it may be"
            counts[right if score.outcome == "right" else score.outcome] += 1
            if score.outcome in ("wrong", "crash"):
                print(f"{score.outcome}: {score.entry.text}\n    {text}\n    {score.why}")
    print(counts)


if __name__ == "__main__":
    main()
