"""What a test bench may do with tasks, and no task does by itself."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from rpg.blocks.alike import Judge
from rpg.blocks.judgement import Judgement
from rpg.blocks.namings import Namings
from rpg.blocks.state import BlockState
from rpg.env.task import BlockTask
from rpg.ir import goal as g


def run_in_place_of(other: BlockTask, task: BlockTask) -> None:
    """Let `task` simulate in the memory of `other`, if their scenes are the same: both must be reset after the other
    one was used."""
    task._lender = other


def goal_told(task: BlockTask) -> g.Goal | None:
    """What must hold once every block is at rest, as the code of a task tells it; None where it does not, or does not
    wait for that."""
    told = task._told
    return told.goal if told is not None and told.waits else None


def namings_of(task: BlockTask) -> Namings:
    """Every naming of look-alikes under which a task judges its goal."""
    return task._namings


def judge_by(task: BlockTask, judge: Judge) -> None:
    """Let `judge` say whether the goal of `task` holds: it is one of just that goal, which needs no memory."""
    task._judge, task._looks_back = judge, False


def same_goal(other: BlockTask, task: BlockTask) -> None:
    """Let `task`, whose code says the same of every state as that of `other`, share what is known of its calls."""
    task._calls, task._script = other._calls, other._script
    task._distinct, task._variants = other._distinct, other._variants
    task._names_of_conditions, task._looks_back = other._names_of_conditions, other._looks_back


def judge_each(task: BlockTask, past: Sequence[BlockState], states: Iterable[BlockState]) -> list[Judgement]:
    """Judge each of some states, without physics, as what comes next in one and the same episode, of which `past` are
    the scenes so far. Where there are none, each is a start."""
    if not past:
        return [task.judge_states((state,))[-1] for state in states]
    begun = past[0].since(None)
    task.judge_states((begun, *past[1:]))
    remembered, found = task._memories, []
    for state in states:
        task._memories = [memory.copy() for memory in remembered]
        task._observe(state.since(begun))
        found.append(task.judge())
    task._state = task._judgement = None
    return found
