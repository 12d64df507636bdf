"""Texts with one more sentence behind them: `python -m tests.corpus.followed [EVERY]` lists what changes nothing.

A sentence that leaves the task as it was without it was not read. Where it repeats what was said there is a reason that
holds of all such sentences; each of these is named below.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import yaml

from rpg.ir.schema import TaskSchema
from rpg.passes.schema.ambiguity import same
from rpg.passes.schema.frontend import BuiltinFrontEnd

FILE = Path(__file__).with_suffix(".yaml")
REPEATS = {
    "what lies open is left open": r"order does not matter|[Aa]ny order|does not matter where|may be anywhere",
    "their colours are open, and differ": r"(?:five|four|A, B, C and D|base of three|CAT).*They are all different",
    "each of these has a colour of its own": r"(?:red.*blue|red block).*They are all different",
    "none that is red was named": r"^(?!.*\bred\b.*None).*None of them is red",
    "all of them are on patches, only red ones there": r"(?:yellow|blue) patch\. (?:None on the table|Only red blocks)",
    "the middle of a tower stays so when it is reversed": r"Reverse the tower. The second one is green",
    "a pyramid is as high as its base is wide": r"pyramid with a base of three .* three blocks high",
    "a tower of red blocks has no others": r"tower of three red blocks. Use only red blocks",
    "one of three red blocks is red": r"Sort three red .* The first is red",
}
"""Reasons for which one more sentence says no more, with what the texts look like."""


def texts(every: int = 1) -> Iterator[tuple[str, str]]:
    """Each `every`-th text with a sentence that follows it."""
    groups = yaml.safe_load(FILE.read_text(encoding="utf-8"))
    pairs = [(text, more) for group in groups for text in group["texts"] for more in group["followed_by"]]
    yield from pairs[::every]


@cache
def read(text: str) -> TaskSchema | None:
    """The task of a text that is read."""
    return BuiltinFrontEnd().read(text)[0]


def passed_over(text: str, more: str) -> bool:
    """Whether a text is read with one more sentence as it is without it, for no reason that is known."""
    longer = f"{text} {more}"
    if any(re.search(form, longer) for form in REPEATS.values()):
        return False
    task = read(longer)
    alone = read(text) if task is not None else None
    return task is not None and alone is not None and same(task, alone)


def main() -> None:
    """List them."""
    every = int(sys.argv[1]) if len(sys.argv) > 1 else 1
    pairs = list(texts(every))
    found = [pair for pair in pairs if passed_over(*pair)]
    print(*(f"{text} | {more}" for text, more in found), sep="\n")
    print(f"{len(found)} of {len(pairs)}")


if __name__ == "__main__":
    main()
