"""Writers that are killed, and writers that are many, leave a workspace that can be trusted."""

from __future__ import annotations

import random
import subprocess
import sys
import time
from pathlib import Path

from rpg.store import Workspace, verify_family

from .conftest import lowered

ROOT = Path(__file__).resolve().parents[2]


def start(root: Path, name: str, count: int) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "tests.store.writer", str(root), name, str(count)]
    return subprocess.Popen(command, cwd=ROOT, stdout=subprocess.PIPE, text=True)


def test_killed_writers_lose_nothing_that_was_finished(workspace: Workspace) -> None:
    rng = random.Random(4)
    finished: list[str] = []
    for attempt in range(12):
        writer = start(workspace.root, f"writer {attempt}", 10_000)
        assert writer.stdout is not None
        finished += [writer.stdout.readline().strip(), writer.stdout.readline().strip()]
        time.sleep(rng.uniform(0.0, 0.06))
        writer.kill()
        finished += writer.stdout.read().split("\n")[:-1]
        writer.wait()
        writer.stdout.close()
        family = workspace.family("shared")
        assert not verify_family(family, lowered)
        assert {name for name in finished if name} <= {version.directory.name for version in family.versions()}
    assert len(set(finished)) > 12


def test_many_writers_number_each_version_once(workspace: Workspace) -> None:
    writers = [start(workspace.root, f"writer {index}", 10) for index in range(4)]
    for writer in writers:
        writer.communicate(timeout=60)
        assert writer.returncode == 0
    family = workspace.family("shared")
    assert [version.number for version in family.versions()] == list(range(41))
    assert not verify_family(family, lowered)
    assert not list(workspace.root.rglob(".new-*"))
