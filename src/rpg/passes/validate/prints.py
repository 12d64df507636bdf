"""Fingerprints of simulation states: equal to the bit, or not equal."""

from __future__ import annotations

import hashlib

from rpg.env import BlockTask
from rpg.passes.validate.load import load


def print_of(task: BlockTask) -> str:
    """A digest of every bit of the simulation's positions and velocities."""
    data = task.data
    return hashlib.sha256(data.qpos.tobytes() + data.qvel.tobytes()).hexdigest()


def prints_of(code: str, goal_code: str, resets: int, steps: int) -> dict[str, str]:
    """The prints that the smoke and reset gates leave, made anew: the resets of the first seeds, and a few steps."""
    task = load(code, goal_code)[0]()
    found = {}
    for seed in range(resets):
        task.reset(seed)
        found[f"reset {seed}"] = print_of(task)
        if seed == 0:
            task.step(steps)
            found["steps"] = print_of(task)
    return found
