"""Batches on a local Ray: the bytes of a local batch, also after a worker was killed. Skipped where Ray is missing."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Iterator
from pathlib import Path
from threading import Thread

import pytest

from rpg.batch.cluster import RayCluster
from rpg.batch.run import run_batch
from rpg.cli.main import run
from rpg.store import Workspace
from tests.batch.test_run import ROW, STACK, batch, contents, entries

try:
    import ray
except ImportError:
    ray = None

needs_ray = pytest.mark.skipif(ray is None, reason="Ray is not installed")


@pytest.fixture
def cluster() -> Iterator[None]:
    ray.init(num_cpus=1, log_to_driver=False, include_dashboard=False)
    yield
    ray.shutdown()


@needs_ray
def test_ray_gives_the_bytes_of_a_local_batch(tmp_path: Path, cluster: None) -> None:
    items = entries(STACK, ROW)
    batch(tmp_path / "local", items)
    assert run_batch(items, Workspace(tmp_path / "ray"), RayCluster(), pictures=False).good
    assert contents(tmp_path / "ray") == contents(tmp_path / "local")


@needs_ray
def test_a_lost_worker_is_replaced(tmp_path: Path, cluster: None) -> None:
    killed: list[int] = []

    def kill() -> None:
        for _ in range(600):
            time.sleep(0.05)
            for path in Path("/proc").glob("[0-9]*/cmdline"):
                if b"ray::_build" in _read(path):
                    killed.append(int(path.parent.name))
                    os.kill(killed[0], signal.SIGKILL)
                    return

    Thread(target=kill, daemon=True).start()
    items = entries(STACK, ROW, "Stack the blue block on the red block")
    report = run_batch(items, Workspace(tmp_path / "ray"), RayCluster(), pictures=False)
    assert report.good and killed
    batch(tmp_path / "local", items)
    assert contents(tmp_path / "ray") == contents(tmp_path / "local")


@needs_ray
def test_a_cluster_that_is_not_there_is_said_to_be_missing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def init(**_: object) -> None:
        raise ConnectionError("ray://nowhere:10001 does not answer\nmore")

    monkeypatch.setattr(ray, "init", init)
    (tmp_path / "a.txt").write_text(STACK)
    assert run(["batch", str(tmp_path / "a.txt"), "--executor", "ray", "--tasks", str(tmp_path / "w")]) == 4
    assert capsys.readouterr().err == "rpg: no Ray cluster is to be had: ray://nowhere:10001 does not answer\n"


def _read(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError:
        return b""


@pytest.mark.skipif(ray is not None, reason="Ray is installed")
def test_without_ray_the_command_says_what_to_install(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "a.txt").write_text(STACK)
    status = run(["batch", str(tmp_path / "a.txt"), "--executor", "ray", "--tasks", str(tmp_path / "w")])
    assert status == 4
    assert "roboplayground[ray]" in capsys.readouterr().err
