"""Score the front end on the corpus: `python -m tests.corpus.run --help`."""

from __future__ import annotations

import argparse
import time
from collections import Counter
from random import Random

from rpg.core.diagnostics import Refusal
from rpg.passes.schema.frontend import BuiltinFrontEnd
from rpg.pipeline import compile_instruction, goal_path, prepared
from tests.corpus.entries import SPLITS, Entry, load
from tests.corpus.judge import Read, Score, judge

WAITING = "waiting"
"""Sentences that nothing was mended for yet: no part of the corpus, and not scored unless asked for."""
OUTCOMES = ("right", "refused", "wrong", "crash")


def read(entry: Entry) -> Read:
    """The schema pass and what the compiler decides, without physics; what is or may be refused is also arranged."""
    try:
        schema, diagnostics = BuiltinFrontEnd().read(entry.text)
        if schema is None:
            return None, diagnostics
        schema = prepared(schema)
        if entry.refuse or entry.may_refuse:
            goal_path(schema, Random(0))
        return schema, diagnostics
    except Refusal as refusal:
        return None, refusal.diagnostics


def compile_fully(entry: Entry) -> Read:
    """All four passes with every gate."""
    outcome = compile_instruction(entry.text)
    return (outcome.schema if outcome.status == "admitted" else None), outcome.diagnostics


def score(split: str, *, full: bool = False, only: str | None = None, every: int = 1) -> list[Score]:
    """Judge the entries of a split; with `every` 3 each third of them."""
    compiler = compile_fully if full else read
    return [judge(entry, compiler) for entry in load(split)[::every] if only in (None, entry.phenomenon)]


def table(scores: list[Score]) -> str:
    """Right, refused, wrong and crashed by phenomenon, with the share that is right."""
    lines = [f"{'phenomenon':24}" + "".join(f"{o:>9}" for o in OUTCOMES) + f"{'share':>9}"]
    phenomena = sorted({s.entry.phenomenon for s in scores})
    for name in [*phenomena, "all"]:
        mine = [s for s in scores if name in ("all", s.entry.phenomenon)]
        counts = Counter(s.outcome for s in mine)
        share = f"{counts['right'] / len(mine):9.1%}" if mine else ""
        lines.append(f"{name:24}" + "".join(f"{counts[o]:9}" for o in OUTCOMES) + share)
    unblamed = sum(not s.blamed for s in scores)
    marked = sum(bool(s.entry.marked) for s in scores)
    return "\n".join([*lines, f"refusals that underline the marked words: {marked - unblamed} of {marked}"])


def main() -> None:
    """Print the report."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--split", choices=(*SPLITS, WAITING), action="append")
    parser.add_argument("--only", help="one phenomenon")
    parser.add_argument("--full", action="store_true", help="through all four passes, with physics")
    parser.add_argument("--show", action="store_true", help="list what is not right")
    options = parser.parse_args()
    for split in options.split or SPLITS:
        began = time.perf_counter()
        scores = score(split, full=options.full, only=options.only)
        print(f"== {split}: {len(scores)} instructions, {time.perf_counter() - began:.1f} s")
        print(table(scores), end="\n\n")
        for s in scores if options.show else ():
            if s.outcome != "right":
                print(f"{s.outcome:8} {s.entry.phenomenon}: {s.entry.text!r}\n         {s.why}")


if __name__ == "__main__":
    main()
