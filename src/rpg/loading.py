"""From a task on disk to a task that runs: checked first, since running it means running its code."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rpg.core.diagnostics import Diagnostic, UsageError
from rpg.env import BlockTask
from rpg.ir.artifact import Program
from rpg.ir.schema import TaskSchema
from rpg.passes.codegen import lower
from rpg.passes.validate.bench import Bench
from rpg.passes.validate.gates.text import TextGate
from rpg.passes.validate.load import load as load_classes
from rpg.store import Family, Version, Workspace, resolve, verify_family, verify_version


@dataclass(frozen=True)
class Task:
    """A verified task. `task_class()` runs it; `goal_class()` starts in its goal configuration."""

    version: Version
    schema: TaskSchema
    task_class: type[BlockTask]
    goal_class: type[BlockTask]

    @property
    def instruction(self) -> str:
        return self.schema.instruction

    def make_env(self, **options: Any) -> Any:
        """A Gymnasium environment of the task; `options` are those of `rpg.env.gym.BlockEnv`."""
        from rpg.env.gym import BlockEnv

        return BlockEnv(self.task_class, **options)


def load(task: str | Path, tasks: str | Path = "tasks") -> Task:
    """The task that `task` names (a directory, `family`, `family@2`, a hash), verified before any of its code runs."""
    return load_version(resolve(Workspace(Path(tasks)), str(task)))


def load_version(version: Version) -> Task:
    """The task of a version on disk. Its hashes must be whole, and both files pass the check of the text."""
    problems = verify_version(version, lower)
    if problems:
        raise UsageError(f"{version} is not run: {problems[0].message}; rpg verify {version.family} says more")
    program = Program(task=version.schema, path=(), code=version.code, goal_code=version.goal_code)
    report = TextGate().check(program, Bench(program))
    if not report.passed:
        raise UsageError(f"{version} is not run: {report.failures[0].message}")
    classes = load_classes(program.code, program.goal_code)
    return Task(version, program.task, *classes)


def verify(family: Family) -> tuple[Diagnostic, ...]:
    """Everything that is wrong with a family on disk, its code compared with what task.yaml gives."""
    return verify_family(family, lower)
