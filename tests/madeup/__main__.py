"""Reads made-up sentences and prints the wrong ones; with -v the refused ones, too."""

from __future__ import annotations

import argparse
from collections import Counter

from tests.madeup import made_up
from tests.madeup.judged import judged


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("seed", type=int)
    parser.add_argument("count", type=int)
    parser.add_argument("-v", action="store_true", help="print what is refused, too")
    options = parser.parse_args()
    outcomes: Counter[str] = Counter()
    for sentence in made_up(options.seed, options.count):
        score = judged(sentence)
        outcomes[score.outcome] += 1
        if score.outcome in ("wrong", "crash") or (options.v and score.outcome == "refused"):
            print(f"{score.outcome}: {sentence.text}\n    {score.why}")
    print(dict(outcomes))


if __name__ == "__main__":
    main()
