"""What the gates share about one program: its classes, and what earlier gates have measured with them."""

from __future__ import annotations

import ast
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Protocol

from rpg.blocks.alike import Judge
from rpg.blocks.state import BlockState, World
from rpg.blocks.waypoints import over_time
from rpg.env import BlockTask
from rpg.env.bench import goal_told, judge_by, namings_of, run_in_place_of, same_goal
from rpg.ir.artifact import GateReport, Program
from rpg.ir.walk import plain
from rpg.passes.validate.load import load


@dataclass(frozen=True)
class Measures:
    """How much each gate does. Steps are control steps at 20 Hz."""

    smoke_steps: int = 10
    settle_steps: int = 50
    hold_steps: int = 50
    resets: int = 8
    other_goals: int = 2
    drift_m: float = 0.01
    topple_m: float = 0.02
    overlap_m: float = 0.001


@dataclass
class Trace:
    """The goal configuration in physics: as authored, after settling, at the end; earlier waypoints in `history`."""

    authored: BlockState
    settled: BlockState
    final: BlockState
    history: tuple[BlockState, ...] = ()


@dataclass
class Bench:
    """One program on the test bench. Gates run in order, each may use what the ones before it left here."""

    program: Program
    measures: Measures = field(default_factory=Measures)
    trusted: bool = False
    """Is the code our own lowering, word for word?"""
    trees: dict[str, ast.Module] = field(default_factory=dict)
    """The generated files as they were parsed."""
    prints: dict[str, str] = field(default_factory=dict)
    trace: Trace | None = None
    judge: Judge | None = None
    """Says whether the goal of the task holds, if it may, which is less work than to run the code for every state."""
    elsewhere: Callable[[], dict[str, str]] | None = None
    """Yields the prints of the same program in a fresh process."""

    @cached_property
    def classes(self) -> tuple[type[BlockTask], type[BlockTask]]:
        """The task class and its goal class; running the code may raise anything."""
        return load(*(self.trees.get(name, source) for name, source in self.sources.items()))

    @cached_property
    def task(self) -> BlockTask:
        """One instance of the task, reset by every gate that uses it."""
        made = self.classes[0]()
        self.judge = self._judge_of(made)
        if self.judge is not None:
            judge_by(made, self.judge)
        return made

    @cached_property
    def goal(self) -> BlockTask:
        """One instance of the goal-state task. It simulates where the task did: no gate uses both, and each resets."""
        made = self.classes[1]()
        run_in_place_of(self.task, made)
        if self.trusted:
            same_goal(self.task, made)
        return made

    def _judge_of(self, task: BlockTask) -> Judge | None:
        """A judge of the schema's goal, where the code tells just that, and nothing has to be remembered."""
        goal = self.program.task.goal
        return Judge(goal, self.world, namings_of(task)) if not over_time(goal) and self._tells(task) else None

    def _tells(self, task: BlockTask) -> bool:
        """Is the code our own lowering, and does it tell just the schema's goal?"""
        told = goal_told(task) if self.trusted else None
        return told is not None and plain(told) == plain(self.program.task.goal)

    @cached_property
    def tells(self) -> bool:
        """Is the code our own lowering, and does it tell just the schema's goal? Then it holds nowhere where that does
        not, whatever it remembers."""
        return self.judge is not None or self._tells(self.task)

    @cached_property
    def world(self) -> World:
        """The objects that the schema asks for."""
        return World(self.program.task.assets)

    @property
    def sources(self) -> dict[str, str]:
        """The generated files by name."""
        return {"code.py": self.program.code, "goal_state_code.py": self.program.goal_code}


class Gate(Protocol):
    """One gate. `cost` orders them: 0 reads text, 1 runs Python, 2 runs physics, 3 needs another process."""

    @property
    def name(self) -> str: ...
    @property
    def cost(self) -> int: ...

    def check(self, program: Program, bench: Bench) -> GateReport:
        """Everything independent that is wrong, with measured figures in any case."""
