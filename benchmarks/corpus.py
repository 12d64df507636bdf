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


def ratios(every: int) -> dict[str, float]:
    """Instructions that compile, and how many times of MuJoCo's share each takes (processor time, median of three)."""
    texts = sorted({entry.text for split in SPLITS for entry in load(split) if not entry.refuse})
    options = CompileOptions(paraphrases=0)
    found = {}
    for text in texts[::every]:
        outcome = compile_instruction(text, options)
        if outcome.status == "admitted":
            compiled, floor = alternately(partial(compile_instruction, text, options), mandated(outcome), 3)
            found[text] = compiled / floor
    return found


def main() -> None:
    """Print the share that keeps the budget, the mean and the median, and the slowest."""
    found = ratios(int(sys.argv[1]) if len(sys.argv) > 1 else 20)
    kept = sum(ratio <= BUDGET for ratio in found.values()) / len(found)
    values = found.values()
    print(f"{len(found)} instructions of the corpus: {kept:.1%} within {BUDGET}x of MuJoCo's share, awake")
    print(f"mean {statistics.mean(values):.2f}x, median {statistics.median(values):.2f}x; the slowest:")
    for text in sorted(found, key=found.__getitem__)[: -SLOWEST - 1 : -1]:
        print(f"  {found[text]:5.2f}x  {text}")


if __name__ == "__main__":
    main()
