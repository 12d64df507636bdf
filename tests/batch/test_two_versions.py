"""A workspace that one MuJoCo verified, under another one: both are real, each in an environment of its own.

OTHER_PYTHON names a Python with rpg and another MuJoCo (`make upgrade OTHER=...` sets it); without it this is skipped.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

OTHER = os.environ.get("OTHER_PYTHON", "")
LIST = [
    "Stack the red block on the blue block",
    "Stack the red, blue, green and yellow blocks",
    "Place the red block to the left of the blue block",
    "Build a pyramid of 14 blue blocks with a 3x3 base",
    "Spell the word CAT",
    "Put the green block on the blue patch",
]
HARMLESS = {"figures-changed"}
pytestmark = pytest.mark.skipif(not OTHER, reason="OTHER_PYTHON names no Python with another MuJoCo")


def rpg(python: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    environment = {**os.environ, "MUJOCO_GL": "disable"}
    command = [python, "-m", "rpg", *arguments]
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False, timeout=300)


def version(python: str) -> str:
    command = [python, "-c", "from importlib.metadata import version; print(version('mujoco'))"]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A workspace that the other MuJoCo verified."""
    root = tmp_path_factory.mktemp("other")
    (root / "list.txt").write_text("\n".join(LIST))
    done = rpg(OTHER, "batch", str(root / "list.txt"), "--no-pictures", "--tasks", str(root / "tasks"))
    assert done.returncode == 0, done.stdout + done.stderr
    return root


@pytest.fixture
def workspace(built: Path, tmp_path: Path) -> Path:
    shutil.copytree(built / "tasks", tmp_path / "tasks")
    return tmp_path / "tasks"


def verify(root: Path) -> tuple[int, dict[str, Any], dict[str, list[str]]]:
    done = rpg(sys.executable, "verify", "--all", "--json", "--tasks", str(root))
    document: dict[str, Any] = json.loads(done.stdout)
    codes = {name: [problem["code"] for problem in found] for name, found in document["families"].items()}
    return done.returncode, document, codes


def locked(root: Path) -> dict[str, Any]:
    return dict(json.loads((root / "rpg.lock").read_text()))


def test_the_lock_names_the_mujoco_that_verified(built: Path) -> None:
    assert locked(built / "tasks")["mujoco"] == version(OTHER) != version(sys.executable)


def test_an_upgrade_says_what_changed_meaning(workspace: Path) -> None:
    status, document, codes = verify(workspace)
    print(json.dumps(document, indent=1))
    assert document["upgraded"] == f"MuJoCo {version(OTHER)} -> {version(sys.executable)}"
    changed = {name for name, found in codes.items() if set(found) - HARMLESS}
    assert status == (1 if changed else 0)
    assert locked(workspace)["mujoco"] == version(OTHER if changed else sys.executable)


def test_a_goal_that_judges_otherwise_is_the_only_one_named(workspace: Path) -> None:
    before = {name for name, found in verify(_copy(workspace))[2].items() if set(found) - HARMLESS}
    document = locked(workspace)
    (snapshot,) = (workspace / "red-on-blue").glob("v0-*/snapshot.json")
    key = json.loads(snapshot.read_text())["hash"]
    record = document["verdicts"][key]
    document["verdicts"][key] = ("0" if record[0] == "1" else "1") + record[1:]
    (workspace / "rpg.lock").write_text(json.dumps(document))
    status, answer, codes = verify(workspace)
    assert status == 1
    assert "goal-changed" in codes["red-on-blue"]
    assert {name for name, found in codes.items() if set(found) - HARMLESS} == before | {"red-on-blue"}
    assert "the goal scene" in json.dumps(answer["families"]["red-on-blue"])


def test_a_flipped_byte_is_told_from_an_upgrade(workspace: Path) -> None:
    (code,) = (workspace / "red-on-blue").glob("v0-*/code.py")
    code.write_bytes(code.read_bytes().replace(b"red_block", b"rad_block", 1))
    status, _, codes = verify(workspace)
    assert status == 1 and codes["red-on-blue"] == ["file-changed"]
    assert not any("file-changed" in found for name, found in codes.items() if name != "red-on-blue")


def test_a_batch_builds_everything_again(workspace: Path, built: Path) -> None:
    done = rpg(sys.executable, "batch", str(built / "list.txt"), "--no-pictures", "--json", "--tasks", str(workspace))
    document = json.loads(done.stdout)
    assert document["upgraded"] and document["counts"] == {"built": len(LIST)}
    assert locked(workspace)["mujoco"] == version(sys.executable)


def _copy(root: Path) -> Path:
    target = root.parent / "copy"
    shutil.copytree(root, target)
    return target
