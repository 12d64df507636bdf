"""A compiler from sentences to verified MuJoCo manipulation tasks."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path

    from rpg.loading import Task

__version__ = "0.1.0"


def load(task: str | Path, tasks: str | Path = "tasks") -> Task:
    """The task that `task` names (a directory, `family`, `family@2`, a hash), verified before any of its code runs."""
    from rpg.loading import load as load_task

    return load_task(task, tasks)


if "gymnasium" in sys.modules:
    import rpg.registration  # noqa: F401
