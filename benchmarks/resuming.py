"""A batch that is killed again and again, at random moments, until it is done: are its bytes those of a whole one?

`python benchmarks/resuming.py [KILLS] [INSTRUCTIONS]` (50 and 60 unless told) runs `rpg batch` as a command, kills it in
turn with all its processes, without them, and by Ctrl-C, and compares the workspace in the end.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
import time
from itertools import islice
from pathlib import Path
from random import Random

from instructions import instructions

WAYS = ("killed", "alone", "interrupted")
"""With all its processes; without its workers, who have to notice; by Ctrl-C."""
INTERRUPTED = 130


def start(root: Path, listed: Path) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", "rpg", "batch", str(listed), "--no-pictures", "--jobs", "2", "--tasks", str(root)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, start_new_session=True)


def contents(root: Path) -> dict[str, bytes]:
    """Every file of a workspace by its path."""
    return {str(path.relative_to(root)): path.read_bytes() for path in sorted(root.rglob("*")) if path.is_file()}


def whole(root: Path) -> bool:
    """Is every family there whole? A version appears with all its files, or not at all."""
    done = subprocess.run(
        [sys.executable, "-m", "rpg", "verify", "--tasks", str(root)], capture_output=True, check=False
    )
    return done.returncode == 0


def families(root: Path) -> int:
    return len(list(root.glob("*/HEAD")))


def end(process: subprocess.Popen[bytes], after: float, way: str) -> int | None:
    """Let it run for so many seconds, then end it; its exit status, or None where it was done before."""
    try:
        process.communicate(timeout=after)
    except subprocess.TimeoutExpired:
        if way == "alone":
            process.kill()
        else:
            os.killpg(process.pid, signal.SIGKILL if way == "killed" else signal.SIGINT)
        process.communicate()
        return process.returncode
    return None


def main(kills: int, count: int) -> int:
    """Print what happened; the exit status is 0 if all bytes are the same."""
    rng, faults = Random(0), 0
    with tempfile.TemporaryDirectory() as directory:
        base = Path(directory)
        listed = base / "list.txt"
        listed.write_text("\n".join(islice(instructions(), count)))
        begun = time.perf_counter()
        start(base / "whole", listed).communicate()
        seconds = time.perf_counter() - begun
        expected, reached, round_number, done = contents(base / "whole"), [], 0, 0
        while done < kills:
            root = base / f"killed-{round_number}"
            while done < kills:
                way = WAYS[done % len(WAYS)]
                status = end(start(root, listed), rng.uniform(0.1, 0.6 * seconds), way)
                if status is None:
                    break
                done += 1
                reached.append(families(root) if root.exists() else 0)
                faults += way == "interrupted" and status != INTERRUPTED
                faults += root.exists() and families(root) > 0 and not whole(root)
            start(root, listed).communicate()
            faults += contents(root) != expected
            round_number += 1
        print(f"{done} kills in {round_number} batches of {count} ({seconds:.1f} s each without one)")
        print(f"families in place after each kill: {' '.join(map(str, reached))}")
        print("every batch ended with the same bytes" if not faults else f"{faults} faults")
    return int(faults > 0)


if __name__ == "__main__":
    given = [int(argument) for argument in sys.argv[1:]]
    sys.exit(main(given[0] if given else 50, given[1] if len(given) > 1 else 60))
