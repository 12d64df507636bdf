"""The same batch on a Ray cluster, for those who outgrow one machine. Needs the extra `ray`."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from dataclasses import dataclass

from rpg.batch.pool import Job
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
            ray.init(log_to_driver=False, include_dashboard=False)
        try:
            remote = ray.remote(max_retries=RETRIES)(build)
            for reference in [remote.remote(entry, pictures) for entry, pictures in jobs]:
                yield _result(ray, reference)
        finally:
            if started:
                ray.shutdown()


def _result(ray: object, reference: object) -> Result:
    try:
        found: Result = ray.get(reference)  # type: ignore[attr-defined]
        return found
    except ray.exceptions.RayError as error:  # type: ignore[attr-defined]
        message = f"the cluster lost this entry {RETRIES + 1} times: {str(error).splitlines()[0]}"
        return lost("worker-lost", message)
