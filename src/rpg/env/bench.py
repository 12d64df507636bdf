"""What a test bench may do with tasks, and no task does by itself."""

from __future__ import annotations

from rpg.blocks.alike import Judge
from rpg.env.task import BlockTask
from rpg.ir import goal as g


def run_in_place_of(other: BlockTask, task: BlockTask) -> None:
    """Let `task` simulate in the memory of `other`, if their scenes are the same: both must be reset after the other
    one was used."""
    task._lender = other


def goal_told(task: BlockTask) -> g.Goal | None:
    """The goal of a task that has been reset, as its code tells it; None where it does not."""
    return task._told


def judge_by(task: BlockTask, judge: Judge) -> None:
    """Let `judge` say whether the goal of `task` holds: it is one of just that goal, which needs no memory."""
    task._judge = judge
