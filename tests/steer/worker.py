"""A process that steers a family over and over, saying each version that it has finished."""

from __future__ import annotations

import os
import sys
from pathlib import Path

os.environ["MUJOCO_GL"] = "disable"

from rpg.steering import steer
from rpg.store import Family

COLORS = ("green", "yellow", "white", "black", "pink", "orange", "purple", "brown")


def main(directory: str, times: int, offset: int) -> None:
    """Steer from the base, `times` times, each time with another colour."""
    family = Family(Path(directory))
    base = family.versions()[0]
    print("ready", flush=True)
    for k in range(times):
        color = COLORS[(k + offset) % len(COLORS)]
        place = "on top" if (k // len(COLORS)) % 2 == 0 else "underneath"
        done = steer(base, f"add a {color} block {place}")
        version = done.version
        print(version.hash if version else done.status, flush=True)


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]), int(sys.argv[3]))
