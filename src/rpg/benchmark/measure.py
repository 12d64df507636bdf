"""The metrics of a suite, turn by turn: did the task come about, do its files compile, does it run."""

from __future__ import annotations

import ast
import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from rpg.batch.entries import Entry
from rpg.benchmark.smoke import smoke_test
from rpg.ir.base import Record
from rpg.pipeline import CompileOptions, compile_instruction
from rpg.publishing import publish
from rpg.steering import steer
from rpg.store import Version, Workspace, Written

METRICS = ("task_success", "compiled", "smoke")
Z95 = 1.959964
"""Half-width of a 95 % interval in standard errors of a normal distribution."""


class Turn(Record):
    """One task of a suite: the words that asked for it, and what became of them.

    `task_success`: both files passed every gate, the goal holding in the goal state. `compiled`: both files parse and
    compile on their own. `smoke`: reset and ten steps of zero action in a fresh process.
    """

    case: str
    number: int
    words: str
    directory: str | None = None
    goal_text: str = ""
    problem: str = ""
    task_success: bool = False
    compiled: bool = False
    smoke: bool = False

    @property
    def key(self) -> str:
        return f"{self.case}/{self.number}"


@dataclass(frozen=True)
class Share:
    """A percentage over turns, with the half-width of its 95 % interval."""

    percent: float
    half_width: float


def measure(entries: tuple[Entry, ...], root: Path, pictures: bool, listen: Callable[[str], None]) -> list[Turn]:
    """Build every entry below `root` and measure each of its tasks. A turn that is refused ends its session."""
    turns = []
    for entry in entries:
        listen(entry.title)
        turns += _session(entry, root, pictures)
    return turns


def _session(entry: Entry, root: Path, pictures: bool) -> list[Turn]:
    case = entry.name or entry.instruction
    options = CompileOptions(name=entry.name, seed=entry.seed, author=entry.author, pictures=pictures)
    outcome = compile_instruction(entry.instruction, options)
    place = publish(outcome, Workspace(root), explicit=True)
    version = place.version if isinstance(place, Written) else None
    reason = next((d.message for d in outcome.diagnostics if d.severity == "error"), "")
    turns = [_turn(case, 0, entry.instruction, version, reason)]
    for number, edit in enumerate(entry.edits, 1):
        if version is None:
            turns.append(_turn(case, number, edit, None, "the task to change did not come about"))
            continue
        done = steer(version, edit, options)
        reason = next((d.message for d in done.diagnostics if d.severity == "error"), "")
        turns.append(_turn(case, number, edit, done.version, reason))
        version = done.version or version
    return turns


def _turn(case: str, number: int, words: str, version: Version | None, problem: str) -> Turn:
    if version is None:
        return Turn(case=case, number=number, words=words, problem=problem)
    return Turn(
        case=case,
        number=number,
        words=words,
        directory=str(version.directory),
        goal_text=version.snapshot.snapshot.goal_summary,
        task_success=True,
        compiled=_compiles(version.code) and _compiles(version.goal_code),
        smoke=smoke_test(version.directory),
    )


def _compiles(code: str) -> bool:
    try:
        compile(ast.parse(code), "code.py", "exec")
    except (SyntaxError, ValueError):
        return False
    return True


def share(turns: list[Turn], metric: str) -> Share:
    """The percentage of turns where `metric` holds; the interval is the normal one, as in published tables."""
    if not turns:
        return Share(0.0, 0.0)
    p = sum(bool(getattr(turn, metric)) for turn in turns) / len(turns)
    return Share(100 * p, 100 * Z95 * math.sqrt(p * (1 - p) / len(turns)))
