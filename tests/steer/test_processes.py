"""Many processes at one family, and processes killed at any moment: no version is lost, torn or numbered twice."""

from __future__ import annotations

import random
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from rpg.loading import verify
from rpg.pipeline import compile_instruction
from rpg.publishing import publish
from rpg.store import Family, Workspace, Written

KILLS = 6
"""How often a steering process is killed."""


@pytest.fixture
def family(tmp_path: Path) -> Family:
    place = publish(compile_instruction("put the blue block on the red block"), Workspace(tmp_path / "tasks"))
    assert isinstance(place, Written)
    return Family(place.version.directory.parent)


def worker(family: Family, times: int, offset: int) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "tests.steer.worker", str(family.directory), str(times), str(offset)]
    root = Path(__file__).resolve().parents[2]
    return subprocess.Popen(command, cwd=root, stdout=subprocess.PIPE, text=True)


def assert_whole(family: Family) -> None:
    """Hashes, lineage and code are as recorded, numbers run from 0, and every parent is the base."""
    assert verify(family) == ()
    versions = family.versions()
    assert [version.number for version in versions] == list(range(len(versions)))
    assert {version.snapshot.parent for version in versions[1:]} <= {versions[0].hash}
    assert family.head() in versions


def test_eight_processes_steer_one_family(family: Family) -> None:
    workers = [worker(family, 1, offset) for offset in range(8)]
    said = [process.communicate(timeout=300)[0].split() for process in workers]
    assert all(words[0] == "ready" and len(words[1]) == 64 for words in said)
    assert_whole(family)
    assert {version.hash for version in family.versions()[1:]} == {words[1] for words in said}
    assert len(family.versions()) == 9


def kill_one(family: Family, rng: random.Random) -> list[str]:
    """Start a steering process, kill it some time after it is ready; the versions that it said it had finished."""
    process = worker(family, 12, rng.randrange(8))
    assert process.stdout is not None
    assert process.stdout.readline() == "ready\n"
    time.sleep(rng.uniform(0.0, 0.8))
    process.send_signal(signal.SIGKILL)
    rest = process.stdout.read()
    process.wait()
    return [line for line in rest.splitlines() if len(line) == 64]


def test_a_killed_process_loses_no_finished_version(family: Family) -> None:
    rng = random.Random(4)
    finished: set[str] = set()
    for _ in range(KILLS):
        finished.update(kill_one(family, rng))
        assert_whole(family)
    assert finished <= {version.hash for version in family.versions()}
