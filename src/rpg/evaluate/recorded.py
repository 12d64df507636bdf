"""States as JSON lines, judged by a task: what `rpg check` reads and writes."""

from __future__ import annotations

import difflib
import json
import math
from collections.abc import Iterable, Iterator
from typing import Any

from rpg.blocks.judgement import Judgement
from rpg.blocks.state import IDENTITY, BlockState, Quat, Vec3, World
from rpg.core.diagnostics import UsageError
from rpg.env import BlockTask

UNIT = 1e-3
"""How far from 1 the length of a quaternion may be."""
PLACE = 0.01
"""How far (m) a patch may be given from where it is."""
FARTHEST = 1e6
"""What no number of a pose exceeds; geometry would overflow far beyond."""


class BadState(ValueError):
    """What is wrong with a line, to be said with its number."""


def judge_lines(task: BlockTask, lines: Iterable[bytes], origin: str, seed: int) -> Iterator[tuple[bool, str]]:
    """For each line of `lines` whether its state is a success, and the line of JSON that answers it."""
    start = task.reset(seed)
    empty = True
    for number, line in enumerate(lines, start=1):
        if not line.strip():
            continue
        empty = False
        try:
            judgement = _judged(task, start, json.loads(line.rstrip()))
        except BadState as problem:
            raise UsageError(f"{origin}:{number}: {problem}") from problem
        except json.JSONDecodeError as problem:
            raise UsageError(f"{origin}:{number}:{problem.colno}: not JSON: {problem.msg}") from problem
        except (ValueError, RecursionError) as problem:
            raise UsageError(f"{origin}:{number}: not JSON: {problem}") from problem
        yield succeeded(judgement), answer(judgement)
    if empty:
        raise UsageError(f"{origin}: there is no state in it to judge")


def succeeded(judgement: Judgement) -> bool:
    """Whether the goal holds, in an episode that was not lost on the way."""
    return judgement.success.value and not judgement.failed


def answer(judgement: Judgement) -> str:
    """A judgement as a line of JSON."""
    data = {
        "success": succeeded(judgement),
        "margin": judgement.success.margin,
        "conditions": [
            {"name": name, "value": verdict.value, "margin": verdict.margin} for name, verdict in judgement.conditions
        ],
        "stage": judgement.stage,
    }
    return json.dumps(data, ensure_ascii=False) + "\n"


def _judged(task: BlockTask, start: BlockState, data: Any) -> Judgement:
    if not isinstance(data, dict) or len(data.keys() & {"objects", "trajectory"}) != 1:
        raise BadState('a line is {"objects": {...}} or {"trajectory": [{"objects": {...}}, ...]}')
    if "objects" in data:
        return task.judge_states([_state(task.world, data, "")], start)[-1]
    steps = data["trajectory"]
    if not isinstance(steps, list) or not steps:
        raise BadState("trajectory: should be a list of at least one state")
    states = [_state(task.world, step, f"trajectory[{at}].") for at, step in enumerate(steps)]
    return task.judge_states(states)[-1]


def _state(world: World, data: Any, where: str) -> BlockState:
    objects = data.get("objects") if isinstance(data, dict) else None
    if not isinstance(objects, dict):
        raise BadState(f'{where}objects: should map names to {{"position": [x, y, z], "orientation": [w, x, y, z]}}')
    position: dict[str, Vec3] = {}
    orientation: dict[str, Quat] = {}
    for name, pose in objects.items():
        if name in world.blocks:
            position[name], orientation[name] = _pose(pose, f"{where}objects.{name}")
        else:
            _other(world, name, pose, f"{where}objects")
    if len(position) < len(world.blocks):
        missing = [name for name in world.blocks if name not in position]
        raise BadState(f"{where}objects: {missing[0]} is missing; the task has {', '.join(world.blocks)}")
    return BlockState(world, position, orientation)


def _other(world: World, name: str, pose: Any, where: str) -> None:
    """What is no block may be a patch, which is where it always is; anything else is an error."""
    if name not in world.patches:
        near = difflib.get_close_matches(name, list(world.blocks), n=1)
        hint = f"did you mean {near[0]}?" if near else f"the task has {', '.join(world.blocks)}"
        raise BadState(f"{where}: there is no {name!r}; {hint}")
    given, (x, y) = _pose(pose, f"{where}.{name}")[0], world.patches[name].position or (math.nan, math.nan)
    if math.dist(given[:2], (x, y)) > PLACE:
        raise BadState(f"{where}.{name}: the patch is fixed at x = {x:.3f}, y = {y:.3f}")


def _pose(pose: Any, where: str) -> tuple[Vec3, Quat]:
    if not isinstance(pose, dict) or "position" not in pose:
        raise BadState(f"{where}: needs a position")
    unknown = pose.keys() - {"position", "orientation"}
    if unknown:
        raise BadState(f"{where}: {sorted(unknown)[0]!r} is not known here; a pose has position and orientation")
    x, y, z = _numbers(pose["position"], 3, f"{where}.position")
    if "orientation" not in pose:
        return (x, y, z), IDENTITY
    w, i, j, k = _numbers(pose["orientation"], 4, f"{where}.orientation")
    length = math.sqrt(w * w + i * i + j * j + k * k)
    if abs(length - 1.0) > UNIT:
        raise BadState(f"{where}.orientation: [w, x, y, z] should have length 1, this has {length:.4g}")
    return (x, y, z), (w / length, i / length, j / length, k / length)


def _numbers(value: Any, count: int, where: str) -> list[float]:
    if not isinstance(value, list) or len(value) != count:
        raise BadState(f"{where}: should be a list of {count} numbers")
    for number in value:
        if type(number) not in (float, int) or number != number or abs(number) == math.inf:
            raise BadState(f"{where}: {json.dumps(number)[:40]} is not a number")
        if abs(number) > FARTHEST:
            raise BadState(f"{where}: {json.dumps(number)[:40]} is out of every range")
    return value
