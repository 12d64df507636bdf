"""What the repair agents exchange: the case they look at, what they propose, what has been tried."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from random import Random
from typing import Protocol

from rpg.core.diagnostics import Diagnostic
from rpg.core.digest import digest_of
from rpg.ir.artifact import FailureClass, GateReport, Program, Scene
from rpg.ir.goal import Goal
from rpg.ir.schema import TaskSchema


@dataclass(frozen=True)
class Tools:
    """The other passes, as the repair needs them."""

    lower: Callable[[TaskSchema], str]
    lower_goal: Callable[[TaskSchema, tuple[Scene, ...]], str]
    read_goal: Callable[[str], tuple[Scene, ...] | None]
    arrange: Callable[[TaskSchema, Random], tuple[Scene, ...]]
    """A path to a goal state, another one for another generator; raises Refusal where there is none."""
    validate: Callable[[Program], tuple[GateReport, ...]]


@dataclass(frozen=True)
class Case:
    """A program that failed, and what the instruction asks for (`asked`), which no repair may lose."""

    program: Program
    reports: tuple[GateReport, ...]
    asked: Goal

    @property
    def gate(self) -> GateReport:
        """The gate that failed."""
        return self.reports[-1]


@dataclass(frozen=True)
class Proposal:
    """A changed program. `strategy` says what was done in a few words, and is not tried again where it failed."""

    strategy: str
    program: Program


class Agent(Protocol):
    """Mends one class of failure by deterministic operators."""

    @property
    def name(self) -> str: ...
    @property
    def handles(self) -> FailureClass: ...

    def propose(self, case: Case, failures: tuple[Diagnostic, ...], tools: Tools) -> Iterator[Proposal]:
        """Changes that may mend the failures of this agent's class, the most careful first."""


@dataclass(frozen=True)
class Attempt:
    """One cycle: who did what, and how many gates were passed then.

    `kept`: it came further than everything before. `refused`: why it was not even tried.
    """

    agent: str
    strategy: str
    gates_passed: int = 0
    kept: bool = False
    refused: str | None = None


def digest(program: Program) -> str:
    """What tells one state of a repair from another."""
    task = program.task.model_dump(mode="json")
    return digest_of([task, program.code, program.goal_code])


def relowered(
    program: Program, tools: Tools, *, task: TaskSchema | None = None, path: tuple[Scene, ...] | None = None
) -> Program:
    """The program made anew from its schema and scenes, changed where they are given."""
    task = task or program.task
    path = program.path if path is None else path
    return Program(task=task, path=path, code=tools.lower(task), goal_code=tools.lower_goal(task, path))
