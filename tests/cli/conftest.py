"""A compiled task, and a way to run commands as from a shell."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from rpg.cli.main import run
from rpg.ir.assets import ColoredCube, GoalPatch, SemanticCube
from rpg.ir.goal import All, On, OnPatch
from rpg.ir.schema import TaskSchema
from rpg.store import dump_schema

SCHEMA = TaskSchema(
    name="red-on-blue",
    instruction="Put the blue block on the patch, and red on top of it.",
    assets=(
        ColoredCube(name="red_block", color="red"),
        ColoredCube(name="blue_block", color="blue"),
        SemanticCube(name="A_block", label="A"),
        GoalPatch(name="patch", color="green", position=(0.5, 0.1)),
    ),
    goal=All(goals=(OnPatch(a="blue_block", patch="patch"), On(a="red_block", b="blue_block", span=(37, 53)))),
    assumptions=("the patch is green",),
)


@dataclass(frozen=True)
class Result:
    """What a command left behind."""

    status: int
    out: str
    err: str

    @property
    def json(self) -> Any:
        return json.loads(self.out)


Rpg = Callable[..., Result]


@pytest.fixture(scope="session")
def compiled(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A workspace with one compiled task."""
    root = tmp_path_factory.mktemp("compiled")
    (root / "task.yaml").write_text(dump_schema(SCHEMA))
    arguments = ["compile", "--from", str(root / "task.yaml"), "--tasks", str(root / "tasks"), "--no-pictures", "-q"]
    assert run(arguments) == 0
    return root / "tasks"


@pytest.fixture
def tasks(compiled: Path, tmp_path: Path) -> Path:
    """A workspace of one's own with one compiled task."""
    return Path(shutil.copytree(compiled, tmp_path / "tasks"))


@pytest.fixture
def rpg(capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> Rpg:
    """Runs a command in this process."""
    monkeypatch.setenv("COLUMNS", "100")

    def call(*arguments: str | Path) -> Result:
        capfd.readouterr()
        status = run([str(argument) for argument in arguments])
        captured = capfd.readouterr()
        return Result(status, captured.out, captured.err)

    return call
