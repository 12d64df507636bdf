"""A batch that is killed again and again, at random moments, until it is done: are its bytes those of a whole one?

`python benchmarks/resuming.py [KILLS] [INSTRUCTIONS]` (50 and 60 unless told) runs `rpg batch` as a command and kills
it: in turn with all its processes, without them, and by Ctrl-C; every other time just after a family was put in place.
What it leaves must be sound each time, and the workspace in the end the same to the byte.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from random import Random

from instructions import instructions

WAYS = ("killed", "alone", "interrupted")
"""With all its processes; without its workers, who have to notice; by Ctrl-C."""
EXIT = 130
INTERRUPTED = (EXIT, -signal.SIGINT)
"""The second: while Python itself is still starting."""


def start(root: Path, listed: Path) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", "rpg", "batch", str(listed), "--no-pictures", "--jobs", "2", "--tasks", str(root)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)


def contents(root: Path) -> dict[str, bytes]:
    """Every file of a workspace by its path."""
    return {str(path.relative_to(root)): path.read_bytes() for path in sorted(root.rglob("*")) if path.is_file()}


def families(root: Path) -> int:
    return len(list(root.glob("*/HEAD")))


def end(process: subprocess.Popen[bytes], root: Path, moment: float, way: str) -> tuple[int, bytes] | None:
    """End it `moment` seconds from its start or, where that is negative, so long after the next family is in place; its
    exit status and what it said, or None where it was done before."""
    if moment < 0:
        before = families(root)
        while process.poll() is None and families(root) == before:
            time.sleep(0.002)
    try:
        process.communicate(timeout=abs(moment))
    except subprocess.TimeoutExpired:
        if way == "alone":
            process.kill()
        else:
            os.killpg(process.pid, signal.SIGKILL if way == "killed" else signal.SIGINT)
        _, said = process.communicate()
        return process.returncode, said
    return None


def faults_of(root: Path, way: str, status: int, said: bytes) -> Iterator[str]:
    """What a kill must not leave: a family that is not whole, or other words than Ctrl-C's none."""
    if way == "interrupted" and (status not in INTERRUPTED or (status == EXIT and said)):
        yield f"exit status {status} after Ctrl-C: {said.decode()}"
    if families(root):
        command = [sys.executable, "-m", "rpg", "verify", "--tasks", str(root)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode:
            yield done.stdout + done.stderr


def main(kills: int, count: int) -> int:
    """Print what happened; the exit status is 0 if all bytes are the same."""
    rng = Random(0)
    faults: list[str] = []
    reached: list[int] = []
    with tempfile.TemporaryDirectory() as directory:
        base = Path(directory)
        listed = base / "list.txt"
        listed.write_text("\n".join(islice(instructions(), count)))
        begun = time.perf_counter()
        start(base / "whole", listed).communicate()
        seconds = time.perf_counter() - begun
        expected, batches = contents(base / "whole"), 0
        while len(reached) < kills:
            root = base / f"killed-{batches}"
            while len(reached) < kills:
                way = WAYS[len(reached) % len(WAYS)]
                moment = rng.uniform(0.1, seconds) if len(reached) % 2 else -rng.uniform(0.001, 0.3)
                ended = end(start(root, listed), root, moment, way)
                if ended is None:
                    break
                reached.append(families(root))
                faults += faults_of(root, way, *ended)
            start(root, listed).communicate()
            found = contents(root)
            faults += [
                f"batch {batches}: {path} differs"
                for path in expected.keys() | found.keys()
                if expected.get(path) != found.get(path)
            ]
            batches += 1
    print(f"{kills} kills in {batches} batches of {count} instructions ({seconds:.1f} s each without a kill)")
    print(f"families in place after each kill: {' '.join(map(str, reached))}")
    print("\n".join(faults) or "every batch ended with the same bytes")
    return int(bool(faults))


if __name__ == "__main__":
    given = [int(argument) for argument in sys.argv[1:]]
    sys.exit(main(given[0] if given else 50, given[1] if len(given) > 1 else 60))
