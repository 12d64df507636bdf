"""Makes `gymnasium.make("rpg/Task-v0", task=...)` work: Gymnasium calls `register` when it is imported."""

from __future__ import annotations

from pathlib import Path
from typing import Any

ENV_ID = "rpg/Task-v0"
MAX_STEPS = 600
"""Control steps of an episode before it is cut off: 30 s."""


def register() -> None:
    """Tell Gymnasium about the environment, once."""
    from gymnasium.envs.registration import register as add
    from gymnasium.envs.registration import registry

    if ENV_ID not in registry:
        add(ENV_ID, entry_point="rpg.registration:make", max_episode_steps=MAX_STEPS)


def make(task: Any, **options: Any) -> Any:
    """The environment of a task: a task directory or name, what `rpg.load` gives, or a BlockTask class."""
    if isinstance(task, str | Path):
        from rpg import load

        return load(task).make_env(**options)
    if hasattr(task, "make_env"):
        return task.make_env(**options)
    from rpg.env.gym import BlockEnv

    return BlockEnv(task, **options)
