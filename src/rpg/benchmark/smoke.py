"""The smoke test of a version, in a process of its own: reset and ten control steps of zero action.

`python -m rpg.benchmark.smoke VERSION_DIRECTORY` exits with 0 if nothing was raised.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

STEPS = 10
TIMEOUT = 60.0
"""Seconds that reset and steps may take."""


def smoke_test(directory: Path) -> bool:
    """Run the version at `directory` in a fresh interpreter."""
    command = [sys.executable, "-m", "rpg.benchmark.smoke", str(directory)]
    environment = {**os.environ, "MUJOCO_GL": "disable"}
    try:
        done = subprocess.run(command, env=environment, capture_output=True, timeout=TIMEOUT, check=False)
    except subprocess.TimeoutExpired:
        return False
    return done.returncode == 0


def main(directory: str) -> None:
    """Reset and step the task of the version at `directory`."""
    import rpg

    task = rpg.load(directory).task_class()
    task.reset(0)
    for _ in range(STEPS):
        task.step()


if __name__ == "__main__":
    main(sys.argv[1])
