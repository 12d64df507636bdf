"""Measures batches: throughput and memory of workers, and a batch with nothing to do, over growing lists.

`python benchmarks/batches.py [INSTRUCTIONS]` prints a table; lists have up to that many instructions (1,000 unless
told), drawn from the language reference, no two alike.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Generator, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from multiprocessing import forkserver
from pathlib import Path

from bench import processes_time
from instructions import instructions

from rpg.batch.entries import Entry, read_entries
from rpg.batch.pool import Job, LocalPool
from rpg.batch.run import run_batch
from rpg.batch.work import Result
from rpg.store import Workspace

TICKS = os.sysconf("SC_CLK_TCK")
LENGTHS = (10, 100, 1000)


@dataclass(frozen=True)
class Throughput:
    """`workers` built `tasks` in `seconds`. `cpu`: processor time (s) of all processes; `parent`: of the one that hands
    out and puts in place; `peak`: the most MB that one worker held."""

    workers: int
    tasks: int
    seconds: float
    cpu: float
    parent: float
    peak: float


@dataclass
class Watched:
    """A local pool whose workers are looked at before they go."""

    workers: int
    cpu: float = 0.0
    peak: float = 0.0

    def map(self, jobs: Sequence[Job]) -> Generator[Result, None, None]:
        results = LocalPool(self.workers).map(jobs)
        for number, result in enumerate(results, 1):
            if number == len(jobs):
                server = forkserver._forkserver._forkserver_pid  # type: ignore[attr-defined]
                workers = children(server)
                self.cpu = sum(processor_time(pid) for worker in workers for pid in (worker, *children(worker)))
                self.peak = max((peak_memory(worker) for worker in workers), default=0.0)
            yield result


def children(pid: int) -> list[int]:
    return [int(child) for child in Path(f"/proc/{pid}/task/{pid}/children").read_text().split()]


def processor_time(pid: int) -> float:
    """Seconds of processor time of a process and of its children that have ended."""
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return sum(int(field) for field in fields[11:15]) / TICKS


def peak_memory(pid: int) -> float:
    """The most memory (MB) that a process held at once, shared pages included."""
    lines = Path(f"/proc/{pid}/status").read_text().splitlines()
    return next(int(line.split()[1]) / 1024 for line in lines if line.startswith("VmHWM"))


def entries(count: int) -> tuple[Entry, ...]:
    return tuple(Entry(f"list:{number}", text) for number, text in enumerate(islice(instructions(), count), 1))


def throughput(workers: int, count: int) -> Throughput:
    """Build `count` instructions into a fresh workspace, without pictures."""
    with tempfile.TemporaryDirectory() as root:
        pool = Watched(workers)
        begun, parent = time.perf_counter(), time.process_time()
        report = run_batch(entries(count), Workspace(Path(root)), pool, pictures=False)
        assert not report.count("failed")
        parent = time.process_time() - parent
        return Throughput(workers, count, time.perf_counter() - begun, pool.cpu + parent, parent, pool.peak)


@dataclass(frozen=True)
class Copies:
    """Gives the same few families again and again, so that long lists are there at once."""

    families: tuple[Result, ...]

    def map(self, jobs: Sequence[Job]) -> Generator[Result, None, None]:
        for number in range(len(jobs)):
            yield self.families[number % len(self.families)]


def nothing_to_do(lengths: Sequence[int]) -> Iterator[tuple[int, float, float]]:
    """Processor time (s) of a batch whose entries are all up to date, and of the whole command, for lists this long."""
    built = tuple(result for result in LocalPool(2).map([(entry, False) for entry in entries(12)]) if result.tree)
    for length in lengths:
        listed = [{"instruction": f"sentence {number}", "name": f"t{number}"} for number in range(length)]
        with tempfile.TemporaryDirectory() as directory:
            file, root = Path(directory, "list.jsonl"), Path(directory, "tasks")
            file.write_text("\n".join(map(json.dumps, listed)))
            named, workspace = read_entries([str(file)]), Workspace(root)
            run_batch(named, workspace, Copies(built), pictures=False)
            begun = time.process_time()
            report = run_batch(named, workspace, Copies(()), pictures=False)
            inside = time.process_time() - begun
            command = [sys.executable, "-m", "rpg", "batch", str(file), "--no-pictures", "--tasks", str(root)]
            begun = processes_time()
            subprocess.run(command, check=True, capture_output=True)
            whole = processes_time() - begun
        assert report.count("current") == length
        yield length, inside, whole


def main(most: int) -> None:
    """Print every figure as it is measured."""
    lengths = [length for length in LENGTHS if length < most] + [most]
    for workers, count in [(1, min(most, 100)), *((2, length) for length in lengths)]:
        found = throughput(workers, count)
        print(
            f"{found.tasks:5} instructions, {workers} worker{'s' * (workers > 1)}: {found.seconds:6.1f} s; "
            f"{1000 * found.cpu / count:4.0f} ms of processor each, {1000 * found.parent / count:3.1f} ms of them the "
            f"parent's; {found.peak:.0f} MB at most per worker",
            flush=True,
        )
    for length, inside, whole in nothing_to_do(LENGTHS):
        print(
            f"nothing to do over {length:5} tasks: "
            f"{1000 * inside:7.1f} ms of processor, {1000 * whole:7.1f} ms as a command",
            flush=True,
        )


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else LENGTHS[-1])
