"""Where entries are built: warm worker processes on this machine."""

from __future__ import annotations

import os
from collections import deque
from collections.abc import Generator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from multiprocessing import get_context, resource_tracker
from multiprocessing.forkserver import ensure_running
from typing import Protocol

from rpg.batch.entries import Entry
from rpg.batch.signals import undisturbed
from rpg.batch.work import Result, build, lost, warm

Job = tuple[Entry, bool]
"""An entry, and whether to draw its pictures."""


AHEAD = 6
"""Jobs per worker that are handed out before the result that comes next is there."""


class Executor(Protocol):
    """Builds entries somewhere; results come in the order of the jobs."""

    def map(self, jobs: Sequence[Job]) -> Generator[Result, None, None]: ...


@dataclass(frozen=True)
class LocalPool:
    """`workers` processes that import everything once. A worker that dies takes only its own entry with it."""

    workers: int = 0

    def map(self, jobs: Sequence[Job]) -> Generator[Result, None, None]:
        done = 0
        while done < len(jobs):
            for result in self._until_broken(jobs[done:]):
                done += 1
                yield result
            if done < len(jobs):
                yield self._alone(jobs[done])
                done += 1

    def _until_broken(self, jobs: Sequence[Job]) -> Generator[Result, None, None]:
        """Results in order, up to the first whose worker (or one beside it) died.

        Few jobs are handed out ahead: results that wait for their turn take memory.
        """
        workers = min(self.workers or os.cpu_count() or 1, len(jobs))
        pool = self._pool(workers)
        waiting: deque[Future[Result]] = deque()
        try:
            for job in jobs:
                with undisturbed():
                    waiting.append(pool.submit(build, *job))
                if len(waiting) >= AHEAD * workers:
                    yield waiting.popleft().result()
            while waiting:
                yield waiting.popleft().result()
        except BrokenProcessPool:
            return
        finally:
            pool.shutdown(wait=True, cancel_futures=True)

    def _alone(self, job: Job) -> Result:
        """The entry that was next when a worker died, with a worker to itself to tell whether it is the culprit."""
        results = list(self._until_broken([job]))
        message = "the process that built this entry was killed, twice; it may need more memory than there is"
        return results[0] if results else lost("worker-lost", message)

    def _pool(self, workers: int) -> ProcessPoolExecutor:
        context = get_context("forkserver")
        context.set_forkserver_preload(["rpg.batch.preload"])
        resource_tracker.ensure_running()  # which changes the mask of signals itself
        with undisturbed():
            ensure_running()
        return ProcessPoolExecutor(workers, mp_context=context, initializer=warm)
