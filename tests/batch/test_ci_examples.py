"""The workflow and the hook of examples/ci do what they say, with the commands that stand in them."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from importlib import metadata
from pathlib import Path

import pytest
import yaml

CI = Path(__file__).parents[2] / "examples" / "ci"


def start(directory: Path) -> None:
    """Begin a repository with a list."""
    (directory / "lists").mkdir()
    (directory / "lists" / "ours.txt").write_text("Stack the red block on the blue block\n")
    subprocess.run(["git", "init", "-q", str(directory)], check=True)


@pytest.fixture
def repository(tmp_path: Path) -> Path:
    start(tmp_path)
    return tmp_path


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A repository in which the hook has built the tasks."""
    directory = tmp_path_factory.mktemp("built")
    start(directory)
    hook = shell(directory, str(CI / "pre-commit"))
    assert hook.returncode == 0, hook.stderr
    return directory


@pytest.fixture
def committed(built: Path, tmp_path: Path) -> Path:
    """A copy of it."""
    return Path(shutil.copytree(built, tmp_path / "repository", symlinks=True))


def shell(repository: Path, command: str) -> subprocess.CompletedProcess[str]:
    binaries = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    environment = {**os.environ, "PATH": binaries, "GITHUB_STEP_SUMMARY": str(repository / "summary.md")}
    return subprocess.run(["sh", "-c", command], cwd=repository, env=environment, capture_output=True, text=True)


def steps() -> list[str]:
    """The commands of the workflow after the installation, which a test cannot do over."""
    return commands()[1:]


def commands() -> list[str]:
    job = yaml.safe_load((CI / "check-tasks.yml").read_text())["jobs"]["check"]
    return [step["run"] for step in job["steps"] if "run" in step]


def test_the_hook_builds_and_the_workflow_then_agrees(committed: Path) -> None:
    staged = shell(committed, "git diff --cached --name-only").stdout
    assert "tasks/red-on-blue/HEAD" in staged and "tasks/rpg.lock" in staged
    assert "tasks/.lock" not in staged
    for command in steps():
        done = shell(committed, command)
        assert done.returncode == 0, done.stdout + done.stderr
    assert "1 same" in (committed / "summary.md").read_text()


def test_the_workflow_finds_a_changed_instruction_and_a_flipped_byte(committed: Path) -> None:
    check = next(command for command in steps() if "--check" in command)
    (committed / "lists" / "ours.txt").write_text("Stack the red block on the green block\n")
    changed = shell(committed, check)
    assert changed.returncode == 1 and "not in the workspace" in changed.stdout
    (committed / "lists" / "ours.txt").write_text("Stack the red block on the blue block\n")
    code = next((committed / "tasks").rglob("code.py"))
    code.write_text(code.read_text().replace('"red_block"', '"blue_block"', 1))
    flipped = shell(committed, check)
    assert flipped.returncode == 1 and "code.py" in flipped.stdout


def test_the_workflow_installs_the_mujoco_that_verified_the_tasks(committed: Path) -> None:
    pip = 'pip() { printf "%s\\n" "$@"; }; RPG=the-package; '
    done = shell(committed, pip + commands()[0])
    assert done.stdout.split() == ["install", "the-package", f"mujoco=={metadata.version('mujoco')}"]


def test_the_hook_stops_at_a_refusal(repository: Path) -> None:
    (repository / "lists" / "ours.txt").write_text("Frobnicate the wug\n")
    hook = shell(repository, str(CI / "pre-commit"))
    assert hook.returncode == 1
    assert "frobnicate" in hook.stdout.lower()
