"""How the sessions of edits fare: `python -m tests.steer.run [dev|heldout] [--show]`.

A session is right where all of its turns are; a turn is right where it has the class, the reference and the meaning
that are written down for it, or is refused where it has to be. A refused turn was to be carried out; a wrong one was
carried out otherwise, or not refused.
"""

from __future__ import annotations

import sys
import tempfile
from collections import Counter
from pathlib import Path

from tests.steer.harness import Mark, Script, play, scripts

SCORES = ("right", "refused", "wrong")


def played(script: Script) -> list[Mark]:
    """The turns of a session that were come to."""
    with tempfile.TemporaryDirectory() as directory:
        return list(play(script, Path(directory)))


def report(split: str, show: bool) -> bool:
    """Print the figures of a split; whether nothing in it is wrong."""
    turns: Counter[str] = Counter()
    sessions: Counter[str] = Counter()
    refusing = 0
    for script in scripts(split):
        marks = played(script)
        turns.update(mark.score for mark in marks)
        turns["not come to"] += len(script.turns) - len(marks)
        sessions[max((mark.score for mark in marks), key=SCORES.index)] += 1
        refusing += any(turn.get("refuse") for turn in script.turns)
        for mark in marks:
            if show and mark.score != "right":
                print(f"  {script.file} {script.number}: {mark.edit!r}: {mark.score}: {mark.why}")
    told = ", ".join(f"{sessions[score]} {score}" for score in SCORES)
    print(f"{split:8} {sum(sessions.values())} sessions ({refusing} with refusals): {told}")
    print(f"{'':8} {sum(turns.values())} turns: " + ", ".join(f"{turns[s]} {s}" for s in (*SCORES, "not come to")))
    return not turns["wrong"]


def main() -> int:
    """Report every split asked for, or both."""
    chosen = [word for word in sys.argv[1:] if not word.startswith("-")] or ["dev", "heldout"]
    fine = [report(split, "--show" in sys.argv) for split in chosen]
    return 0 if all(fine) else 1


if __name__ == "__main__":
    sys.exit(main())
