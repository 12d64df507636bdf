"""Starts of a task, drawn until the goal is ahead."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from rpg.blocks.initial import crowded, foreseen, sample_start, solved_at_start
from rpg.blocks.state import BlockState
from rpg.blocks.waypoints import always_ahead, stage_holds, still_ahead
from rpg.core.diagnostics import Refusal
from rpg.ir.schema import InitialState

if TYPE_CHECKING:
    from rpg.env.task import BlockTask

ATTEMPTS = 100
"""Starts drawn in search of one where the goal is still ahead."""
MOST_AHEAD = 10
"""Starts drawn in search of one where no later stage holds, once there is one where the first does not."""
IN_VAIN = 4
"""Where seed 0 builds so many starts in vain, all starts are built so that the goal does not hold."""


@dataclass
class Drawing:
    """What the starts of a task are drawn from: what it says, but for what is drawn in vain; and what seed 0 drew when
    that was found out, by attempt."""

    told: InitialState
    init: InitialState
    drawn: dict[int, BlockState] = field(default_factory=dict)


def drawn_start(task: BlockTask, seed: int, told: InitialState) -> BlockState:
    """The start of `seed`; the episode of the task has begun with it."""
    if task._drawing is None or task._drawing.told != told:
        task._drawing = _drawing(task, told)
    init = task._drawing.init
    fallback: BlockState | None = None
    narrow = False
    for attempt in range(ATTEMPTS):
        known = task._drawing.drawn.get(attempt) if seed == 0 else None
        start = known or _sampled(task, init, seed, attempt)
        if attempt and _plainly_past(task, start, fallback is not None and attempt < MOST_AHEAD):
            continue
        task._begin(start)
        if task._past():
            continue
        ahead = any(memory.ahead for memory in task._memories)
        if not (ahead and fallback) and not task._leaves_room(start, f"{seed}/{attempt}/room"):
            narrow = True
            continue
        if not ahead:
            return start
        fallback = fallback or start
        if attempt >= MOST_AHEAD or (task._told is not None and always_ahead(task._told.goal, init)):
            break
    if fallback is None:
        raise Refusal([crowded(ATTEMPTS) if narrow else solved_at_start(ATTEMPTS)])
    if start is not fallback:
        task._begin(fallback)
    return fallback


def _sampled(task: BlockTask, init: InitialState, seed: int, attempt: int) -> BlockState:
    known = foreseen(init, task.world, seed, attempt)
    return known or sample_start(init, task.world, seed, attempt, task._plainly)


def _plainly_past(task: BlockTask, start: BlockState, later: bool) -> bool:
    """Is it seen at a glance that a stage is met at `start`, or with `later` that one holds that is not up yet?"""
    return len(task._namings) == 1 and task._told is not None and stage_holds(task._told.goal, start, later)


def _drawing(task: BlockTask, told: InitialState) -> Drawing:
    """What starts are drawn from."""
    drawing = Drawing(told, told)
    if not told.arranged:
        return drawing
    for attempt in range(IN_VAIN):
        start = drawing.drawn[attempt] = _sampled(task, told, 0, attempt)
        task._begin(start)
        if not task._past():
            return drawing
    ahead = still_ahead(task._told.goal) if task._told is not None else ()
    init = told.model_copy(update={"arranged": (*told.arranged, *ahead)})
    try:
        return Drawing(told, init, {0: sample_start(init, task.world, 0, 0, task._plainly)}) if ahead else drawing
    except Refusal:
        return drawing
