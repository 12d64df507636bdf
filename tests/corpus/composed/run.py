"""How composed sentences are read: `python -m tests.corpus.composed.run FAMILY [COUNT] [FIRST_SEED]`."""

from __future__ import annotations

import sys
from collections import Counter, defaultdict
from importlib import import_module
from pathlib import Path
from random import Random

from tests.corpus.composed import Composed
from tests.corpus.entries import entry
from tests.corpus.judge import Score, judge
from tests.corpus.run import read

FAMILIES = sorted(
    path.stem for path in Path(__file__).parent.glob("*.py") if not path.stem.startswith(("__", "test_", "run"))
)
SHOWN = 4
"""Refused sentences that are listed of a frame."""


def drawn(family: str, seed: int) -> Composed:
    """A sentence of a family."""
    composed: Composed = import_module(f"tests.corpus.composed.{family}").composed(Random(seed))
    return composed


def scored(one: Composed) -> Score:
    """What became of it: right, refused, wrong or a crash."""
    return judge(entry("composed", one.frame, one.text, one.meaning), read)


def main(family: str, count: int = 200, first: int = 0) -> None:
    """Print misreadings, and the frames of which sentences are refused, the worst first, with examples."""
    totals: Counter[str] = Counter()
    refused: defaultdict[str, list[Score]] = defaultdict(list)
    frames: Counter[str] = Counter()
    for seed in range(first, first + count):
        one = drawn(family, seed)
        score = scored(one)
        totals[score.outcome] += 1
        frames[one.frame] += 1
        if score.outcome == "refused":
            refused[one.frame].append(score)
        elif score.outcome != "right":
            print(f"{score.outcome}: {one.text!r}\n       {one.meaning}\n       {score.why}")
    for frame in sorted(refused, key=lambda frame: -len(refused[frame])):
        print(f"refused {len(refused[frame])} of {frames[frame]}: {frame}")
        for score in refused[frame][:SHOWN]:
            print(f"       {score.entry.text!r}: {score.why}")
    print(dict(totals))


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:]))
