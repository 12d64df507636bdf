"""Makes `gymnasium.make("rpg/Task-v0", task=...)` work: importing this module tells Gymnasium about it.

`import rpg` does that where Gymnasium is imported already; `gymnasium.make("rpg.registration:rpg/Task-v0", ...)`
works in any case.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from gymnasium.envs.registration import register, registry

ENV_ID = "rpg/Task-v0"
MAX_STEPS = 600
"""Control steps of an episode before it is cut off: 30 s."""


def make(task: Any, **options: Any) -> Any:
    """The environment of a task: a task directory or name, what `rpg.load` gives, or a BlockTask class."""
    if isinstance(task, str | Path):
        from rpg import load

        return load(task).make_env(**options)
    if hasattr(task, "make_env"):
        return task.make_env(**options)
    from rpg.env.gym import BlockEnv

    return BlockEnv(task, **options)


if ENV_ID not in registry:
    register(ENV_ID, entry_point="rpg.registration:make", max_episode_steps=MAX_STEPS)
