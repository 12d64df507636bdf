"""How much of what tasks are described as reads back as the same task: `python -m tests.english.run --help`."""

from __future__ import annotations

import argparse
import time
from collections import Counter
from collections.abc import Iterator

from rpg.blocks.english import describe
from rpg.blocks.equivalence import equivalent
from rpg.blocks.state import World
from rpg.blocks.symmetry import link
from rpg.core.diagnostics import Refusal
from rpg.ir.schema import TaskSchema
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.corpus.entries import SPLITS, load
from tests.corpus.judge import judge
from tests.corpus.run import read
from tests.english.compositions import composed
from tests.english.schemas import begun

FRONT_END = BuiltinFrontEnd()


def difference(schema: TaskSchema) -> str:
    """What is wrong with the way back from the description of a task; nothing where it is the same task."""
    text = describe(schema)
    back, diagnostics = FRONT_END.read(text)
    if back is None:
        return f"{text}\n  refused: {'; '.join(d.message for d in diagnostics)}"
    same = equivalent(_linked(schema), _linked(back))
    return "" if same else f"{text}\n  was {schema.goal!r}\n  is {back.goal!r}\n  starts {back.init!r}"


def _linked(schema: TaskSchema) -> TaskSchema:
    """The task with orders compared by name where look-alikes are told apart, as the compiler leaves it."""
    return schema.model_copy(update={"goal": link(schema.goal, World(schema.assets))})


def compositions(count: int) -> Iterator[tuple[str, TaskSchema]]:
    """So many random tasks of several parts, each with its number; what only denies starts where that is so."""
    seed = 0
    while count:
        schema = composed(seed)
        if schema is not None:
            yield f"composition {seed}", begun(schema)
            count -= 1
        seed += 1


def corpus() -> Iterator[tuple[str, TaskSchema]]:
    """The tasks of all instructions of the corpus that are read right."""
    for split in SPLITS:
        for entry in load(split):
            schema, _ = read(entry)
            if schema is not None and not entry.refuse and judge(entry, read).outcome == "right":
                yield entry.text, schema


def main() -> None:
    """Print what does not come back, and how much does."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--compositions", type=int, default=600, metavar="N", help="so many random tasks")
    parser.add_argument("--corpus", action="store_true", help="every instruction of the corpus instead")
    options = parser.parse_args()
    began, counts = time.perf_counter(), Counter[str]()
    for title, schema in corpus() if options.corpus else compositions(options.compositions):
        try:
            wrong = difference(schema)
        except Refusal as refusal:
            wrong = str(refusal)
        counts["lost" if wrong else "the same"] += 1
        if wrong:
            print(f"{title}\n  {wrong}")
    print(f"{dict(counts)} in {time.perf_counter() - began:.0f} s")


if __name__ == "__main__":
    main()
