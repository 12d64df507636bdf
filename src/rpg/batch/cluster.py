"""The same batch on a Ray cluster, for those who outgrow one machine. Needs the extra `ray`."""

from __future__ import annotations

from collections import deque
from collections.abc import Generator, Sequence
from dataclasses import dataclass
from typing import Any

from rpg.batch.entries import Entry
from rpg.batch.pool import AHEAD, Job
from rpg.batch.work import Result, build, lost
from rpg.core.diagnostics import Unavailable

RETRIES = 3
"""How often an entry is built again after its worker or its machine was lost."""


@dataclass(frozen=True)
class RayCluster:
    """The cluster that RAY_ADDRESS names, or one of its own on this machine. Results come back through Ray."""

    def map(self, jobs: Sequence[Job]) -> Generator[Result, None, None]:
        try:
            import ray
        except ImportError as error:
            raise Unavailable('--executor ray needs Ray: pip install "roboplayground[ray]"') from error
        if not jobs:
            return
        started = not ray.is_initialized()
        if started:
            _begin(ray)
        try:
            remote = ray.remote(max_retries=RETRIES)(_build)
            ahead = AHEAD * max(1, int(ray.cluster_resources().get("CPU", 1)))
            waiting: deque[Any] = deque()
            for job in jobs:
                waiting.append(remote.remote(*job))
                if len(waiting) >= ahead:
                    yield _result(ray, waiting.popleft())
            while waiting:
                yield _result(ray, waiting.popleft())
        finally:
            if started:
                ray.shutdown()


def _begin(ray: Any) -> None:
    try:
        ray.init(log_to_driver=False, include_dashboard=False)
    except Exception as error:  # Ray raises whatever it met with
        reason = next(iter(str(error).splitlines()), type(error).__name__)
        raise Unavailable(f"no Ray cluster is to be had: {reason}") from error


def _build(entry: Entry, pictures: bool) -> Result:
    import rpg.batch.preload  # noqa: F401

    return build(entry, pictures)


def _result(ray: Any, reference: Any) -> Result:
    try:
        found: Result = ray.get(reference)
        return found
    except ray.exceptions.RayError as error:
        return lost("worker-lost", f"the cluster lost this entry {RETRIES + 1} times: {str(error).splitlines()[0]}")
