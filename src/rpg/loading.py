"""From a task on disk to a task that runs: checked first, since running it means running its code."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from rpg.core.diagnostics import Diagnostic, Refusal, UsageError
from rpg.env import BlockTask
from rpg.ir.edits import EDIT, EditError, apply
from rpg.ir.schema import TaskSchema
from rpg.ir.shrink import TooSmall
from rpg.passes.validate.load import load as load_classes
from rpg.pipeline import is_lowered, load_program, prepared, validate_program
from rpg.store import Family, Version, Workspace, dump_schema, resolve, verify_family, verify_version


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
    """The task of a version on disk. Its files must be those that were written, and its code what its task.yaml gives;
    code that a model wrote must pass every gate first, confined."""
    problems = verify_version(version, lowered)
    if problems:
        hint = f"rpg verify {version.directory} says more"
        if problems[0].code == "does-not-lower":
            hint = f"rpg compile --from {version.directory}/task.yaml builds it again"
        raise UsageError(f"{version} is not run: {problems[0].message}; {hint}")
    program = load_program(version.directory, version.schema)
    if version.snapshot.backend != "lower":
        failures = [failure for report in validate_program(program) for failure in report.failures]
        if failures:
            raise UsageError(f"{version} is not run: {failures[0].message}")
    classes = load_classes(program.code, program.goal_code)
    return Task(version, program.task, *classes)


def lowered(version: Version) -> bool:
    """Is the code of a version, byte for byte, what its task.yaml and the goal state in it give?"""
    return is_lowered(load_program(version.directory, version.schema))


def replayed(version: Version, parent: Version) -> bool:
    """Do the edits that a version records, applied to its parent, give its task.yaml, byte for byte?"""
    steering = version.snapshot.steering
    try:
        edits = [EDIT.validate_python(edit) for edit in steering.edits] if steering else []
        again = prepared(apply(parent.schema, edits))
    except (EditError, TooSmall, ValidationError, Refusal):
        return False
    return dump_schema(again) == dump_schema(version.schema)


def verify(family: Family) -> tuple[Diagnostic, ...]:
    """Everything that is wrong with a family on disk, its code compared with what task.yaml gives, and its edits with
    what they lead to."""
    return verify_family(family, lowered, replayed)
