"""What became of an instruction: right, refused or wrong."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal

from rpg.blocks.evaluate import evaluate
from rpg.core.diagnostics import Diagnostic
from rpg.env import BlockTask
from rpg.ir import goal as g
from rpg.ir.schema import TaskSchema
from rpg.passes.codegen import lower
from tests.corpus.entries import Entry
from tests.corpus.looks import Binding, Mismatch
from tests.corpus.states import Painter

Read = tuple[TaskSchema | None, tuple[Diagnostic, ...]]
Compiler = Callable[[Entry], Read]
Outcome = Literal["right", "refused", "wrong", "crash"]


@dataclass(frozen=True)
class Score:
    """The outcome for one entry, and why it is not right. `blamed`: a refusal underlines the words it should."""

    entry: Entry
    outcome: Outcome
    why: str = ""
    blamed: bool = True


def judge(entry: Entry, compiler: Compiler) -> Score:
    """Compile an entry's text and compare the result with what it has to mean."""
    try:
        schema, diagnostics = compiler(entry)
        errors = [d for d in diagnostics if d.severity == "error"]
        if schema is None or errors:
            return _refused(entry, errors)
        if entry.refuse:
            return Score(entry, "wrong", "compiled")
        why = _disagreement(entry, schema)
    except Exception as error:  # a crash is a score of its own, and the report must go on
        return Score(entry, "crash", f"{type(error).__name__}: {error}"[:160])
    return Score(entry, "wrong" if why else "right", why)


def _refused(entry: Entry, errors: list[Diagnostic]) -> Score:
    said = "; ".join(f"{d.code}: {d.message}" for d in errors)
    if not entry.refuse:
        return Score(entry, "right" if entry.may_refuse else "refused", said)
    if isinstance(entry.refuse, tuple) and not any(d.code in entry.refuse for d in errors):
        return Score(entry, "refused", f"refused for another reason: {said}")
    spans = [s for d in errors for s in (d.span, *(label.span for label in d.labels)) if s]
    blamed = not entry.marked or any(a < d and c < b for a, b in spans for c, d in entry.marked)
    return Score(entry, "right", said, blamed)


def _disagreement(entry: Entry, schema: TaskSchema) -> str:
    try:
        binding = Binding(schema, entry.assets)
        binding.check()
        painter = Painter(binding)
        return _of_start(entry, schema, painter) or _of_goal(entry, schema, painter)
    except Mismatch as mismatch:
        return f"assets: {mismatch}"


def _of_start(entry: Entry, schema: TaskSchema, painter: Painter) -> str:
    heaped = sum(len(heap) for heap in schema.init.heaps)
    if heaped != entry.heap:
        return f"{heaped} blocks start in a heap"
    arranged = g.All(goals=schema.init.arranged)
    for picture in entry.start:
        if not evaluate(arranged, painter.state(picture)):
            return f"cannot start as {picture}"
    for picture in entry.start_miss:
        if evaluate(arranged, painter.state(picture)):
            return f"may start as {picture}"
    return ""


def _of_goal(entry: Entry, schema: TaskSchema, painter: Painter) -> str:
    task = task_of(schema)
    for pictures in entry.hold:
        if not succeeds(task, painter, pictures):
            return f"does not hold: {' , '.join(pictures)}"
    for pictures in entry.miss:
        if succeeds(task, painter, pictures):
            return f"holds: {' , '.join(pictures)}"
    return ""


def task_of(schema: TaskSchema) -> BlockTask:
    """The task that the schema's code defines."""
    scope: dict[str, Any] = {"__name__": "corpus_task"}
    exec(compile(lower(schema), "code.py", "exec"), scope)
    (task,) = [v for v in scope.values() if isinstance(v, type) and issubclass(v, BlockTask) and v is not BlockTask]
    return task()


def succeeds(task: BlockTask, painter: Painter, pictures: tuple[str, ...]) -> bool:
    """Whether a trajectory of pictures, or a single one after a scattered start, ends in success."""
    states = [painter.state(p) for p in (pictures if len(pictures) > 1 else ("", *pictures))]
    last = task.judge_states(states)[-1]
    return bool(last.success) and not last.failed
