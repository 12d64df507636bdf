"""Whether memory stays flat while one process compiles thousands of distinct instructions.

`python benchmarks/memory.py [COMPILES]` (10,000 unless told) prints what the process holds after every 500.
"""

from __future__ import annotations

import os
import sys
import time
from collections import Counter
from itertools import islice
from pathlib import Path

os.environ.setdefault("MUJOCO_GL", "disable")

from instructions import instructions

import rpg.batch.preload  # noqa: F401
from rpg.batch.entries import Entry
from rpg.batch.work import build

EVERY = 500


def held() -> float:
    """The memory (MB) that this process holds now."""
    lines = Path("/proc/self/status").read_text().splitlines()
    return next(int(line.split()[1]) / 1024 for line in lines if line.startswith("VmRSS"))


def main(count: int) -> None:
    """Compile, as a worker of a batch does, and print memory and the time of the last ones."""
    begun, became = time.process_time(), Counter[str]()
    for number, text in enumerate(islice(instructions(), count), 1):
        became[build(Entry(f"list:{number}", text), pictures=False).status] += 1
        if number % EVERY == 0:
            each = 1000 * (time.process_time() - begun) / EVERY
            counts = ", ".join(f"{many} {what}" for what, many in sorted(became.items()))
            print(f"{number:6} compiles: {held():6.1f} MB; {each:5.1f} ms of processor time each; {counts}", flush=True)
            begun = time.process_time()


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000)
