"""Measures batches: throughput and memory of workers, and a batch with nothing to do, over growing lists.

`python benchmarks/batches.py [INSTRUCTIONS]` prints a table; the first figures build that many (100 unless told).
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections.abc import Generator, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from multiprocessing import forkserver
from pathlib import Path

from instructions import instructions

from rpg.batch.entries import Entry
from rpg.batch.pool import Job, LocalPool
from rpg.batch.run import run_batch
from rpg.batch.work import Result
from rpg.store import Workspace

TICKS = os.sysconf("SC_CLK_TCK")
LENGTHS = (10, 100, 1000)


@dataclass(frozen=True)
class Throughput:
    """`workers` built `tasks` in `seconds`; `cpu` are their seconds of processor time, `peak` the most MB of one."""

    workers: int
    tasks: int
    seconds: float
    cpu: float
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
        begun = time.perf_counter()
        run_batch(entries(count), Workspace(Path(root)), pool, pictures=False)
        return Throughput(workers, count, time.perf_counter() - begun, pool.cpu, pool.peak)


@dataclass(frozen=True)
class Copies:
    """Gives the same few families again and again, so that long lists are there at once."""

    families: tuple[Result, ...]

    def map(self, jobs: Sequence[Job]) -> Generator[Result, None, None]:
        for number in range(len(jobs)):
            yield self.families[number % len(self.families)]


def nothing_to_do(lengths: Sequence[int]) -> Iterator[tuple[int, float]]:
    """Seconds that a batch takes whose entries are all up to date, for lists of these lengths."""
    built = tuple(result for result in LocalPool(2).map([(entry, False) for entry in entries(12)]) if result.tree)
    for length in lengths:
        named = tuple(Entry(f"list:{number}", f"sentence {number}", name=f"t{number}") for number in range(length))
        with tempfile.TemporaryDirectory() as root:
            workspace = Workspace(Path(root))
            run_batch(named, workspace, Copies(built), pictures=False)
            begun = time.perf_counter()
            report = run_batch(named, workspace, Copies(()), pictures=False)
            seconds = time.perf_counter() - begun
        assert report.count("current") == length
        yield length, seconds


def main(count: int) -> None:
    """Print every figure as it is measured."""
    for workers in (1, 2):
        found = throughput(workers, count)
        print(
            f"{found.tasks} instructions, {workers} worker{'s' * (workers > 1)}: {found.seconds:.1f} s, "
            f"{1000 * found.cpu / found.tasks:.0f} ms of processor time each, {found.peak:.0f} MB at most per worker",
            flush=True,
        )
    for length, seconds in nothing_to_do(LENGTHS):
        print(f"nothing to do over {length:5} tasks: {1000 * seconds:8.1f} ms", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 100)
