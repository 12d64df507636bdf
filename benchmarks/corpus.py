"""Compiles of what people say, over the whole corpus: how many keep the budget that a compile has.

`python -m benchmarks.corpus` takes every 20th instruction of tests/corpus; `python -m benchmarks.corpus 5` every fifth.
"""

from __future__ import annotations

import statistics
import sys
from functools import partial

from benchmarks.bench import alternately, mandated
from tests.corpus.entries import SPLITS, load

from rpg.pipeline import CompileOptions, compile_instruction

BUDGET = 2.0
"""Times of MuJoCo's share that the warm compile of a sentence may take, without its paraphrases."""
SLOWEST = 5


def times(every: int) -> dict[str, tuple[float, float]]:
    """Instructions that compile, how long each takes (s, processor time, median of three), and MuJoCo's share of it."""
    texts = sorted({entry.text for split in SPLITS for entry in load(split) if not entry.refuse})
    options = CompileOptions(paraphrases=0)
    found = {}
    for text in texts[::every]:
        outcome = compile_instruction(text, options)
        if outcome.status == "admitted":
            found[text] = alternately(partial(compile_instruction, text, options), mandated(outcome), 3)
    return found


def main() -> None:
    """Print what all of them take, the share that keeps the budget by itself, mean and median, and the slowest."""
    found = times(int(sys.argv[1]) if len(sys.argv) > 1 else 20)
    compiled, floor = (sum(times) for times in zip(*found.values(), strict=True))
    print(f"{len(found)} instructions: {compiled / floor:.2f}x of MuJoCo's share, awake (at most {BUDGET}x)")
    values = {text: compiled / floor for text, (compiled, floor) in found.items()}
    kept = sum(ratio <= BUDGET for ratio in values.values()) / len(values)
    mean, median = statistics.mean(values.values()), statistics.median(values.values())
    print(f"one by one: {kept:.1%} within {BUDGET}x, mean {mean:.2f}x, median {median:.2f}x")
    longest = max(compiled for compiled, _ in found.values())
    print(f"the longest takes {1000 * longest:.0f} ms; those farthest above their share:")
    for text in sorted(values, key=values.__getitem__)[: -SLOWEST - 1 : -1]:
        print(f"  {values[text]:5.2f}x  {text}")


if __name__ == "__main__":
    main()
