"""Distinct instructions of every kind, drawn from the examples of the language reference by changing their colours.

`python benchmarks/instructions.py 1000 > instructions.txt` writes a list for `rpg batch`.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from itertools import count, islice
from pathlib import Path
from random import Random

import yaml

EXAMPLES = Path(__file__).resolve().parent.parent / "docs" / "language_examples.yaml"
COLORS = ("red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink", "brown", "black")
_COLOR = re.compile(rf"\b({'|'.join(COLORS)})\b")


def instructions(seed: int = 0) -> Iterator[str]:
    """Without end: every example in turn, its colours drawn anew in every round; none comes twice."""
    sentences = [text for texts in yaml.safe_load(EXAMPLES.read_text(encoding="utf-8")).values() for text in texts]
    seen: set[str] = set()
    rng = Random(seed)
    for round_number in count():
        for sentence in sentences:
            text = recolored(sentence, rng) if round_number else sentence
            if text not in seen:
                seen.add(text)
                yield text


def recolored(sentence: str, rng: Random) -> str:
    """The sentence with other colours: what had one colour has one still, and no two become the same."""
    shuffled = dict(zip(COLORS, rng.sample(COLORS, len(COLORS)), strict=True))
    return _COLOR.sub(lambda found: shuffled[found[0]], sentence)


if __name__ == "__main__":
    print("\n".join(islice(instructions(), int(sys.argv[1]) if len(sys.argv) > 1 else 1000)))
