"""The second reader by itself: `python -m tests.corpus.framed [every]` lists what it misreads of the whole corpus."""

from __future__ import annotations

import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor

from rpg.core.diagnostics import Refusal
from rpg.language.formulas import formulas_told
from rpg.language.frames import retold
from rpg.language.spelling import read_words
from rpg.language.tokens import tokenize
from rpg.passes.schema.build import build
from rpg.passes.schema.frontend import _PLAINER
from rpg.pipeline import prepared
from tests.corpus.entries import SPLITS, Entry, load
from tests.corpus.judge import Read, Score, judge


def read(entry: Entry) -> Read:
    """What the second reader makes of an entry's text, whatever the first makes of it."""
    try:
        tokens, strays = formulas_told(*tokenize(entry.text))
        for plainer in _PLAINER:
            tokens, _ = plainer(tokens)
        words, _, wrong = read_words(tokens)
        found = None if wrong or strays or not words else retold(words)
        if found is None:
            return None, ()
        schema = build(found[0], entry.text, [], name=None, seed=0, author=None).task
        return prepared(schema), ()
    except Refusal as refusal:
        return None, refusal.diagnostics


def scored(entry: Entry) -> tuple[Score, str]:
    """An entry's score, and what it was retold as."""
    score = judge(entry, read)
    if score.outcome in ("wrong", "crash"):
        tokens, _ = formulas_told(*tokenize(entry.text))
        for plainer in _PLAINER:
            tokens, _ = plainer(tokens)
        found = retold(read_words(tokens)[0])
        return score, found[1] if found else ""
    return score, ""


def main() -> None:
    every = int(sys.argv[1]) if len(sys.argv) > 1 else 1
    entries = [entry for split in SPLITS for entry in load(split)][::every]
    counts: Counter[str] = Counter()
    with ProcessPoolExecutor(2) as pool:
        for score, text in pool.map(scored, entries, chunksize=50):
            counts["right refusal" if score.entry.refuse and score.outcome == "right" else score.outcome] += 1
            if score.outcome in ("wrong", "crash"):
                print(f"{score.outcome}: {score.entry.text}\n    {text}\n    {score.why}")
    print(counts)


if __name__ == "__main__":
    main()
