"""The page on running a task: its example runs, and its figures are those of the code."""

from __future__ import annotations

import re
from pathlib import Path

import gymnasium  # noqa: F401
import pytest

from rpg.blocks import scene
from rpg.blocks.constants import SUBSTEPS, TABLE_Z, TIMESTEP
from rpg.env import gripper
from rpg.pipeline import compile_instruction
from rpg.publishing import publish
from rpg.registration import MAX_STEPS
from rpg.store import Workspace

PAGE = (Path(__file__).parents[2] / "docs" / "environment.md").read_text()


def test_the_example_runs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (code,) = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    publish(compile_instruction("put the red block on the yellow block"), Workspace(tmp_path / "tasks"))
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    exec(code, names)
    assert set(names["seen"]) == {"proprioception", "blocks", "viewer", "wrist"}  # type: ignore[call-overload]


def test_figures_are_those_of_the_code() -> None:
    said = [
        f"z = {TABLE_Z}",
        f"{TIMESTEP * 1000:g} ms steps, {SUBSTEPS} of them",
        f"blocks of {scene.DENSITY:g} kg/m³",
        f"coefficient of {scene.FRICTION[0]}",
        f"at most {gripper.STEP_LIMIT} along",
        f"at most {gripper.TURN_LIMIT} about",
        f"by {gripper.GRIP_STEP * 100:g} cm",
        f"more than {gripper.LEAD * 100:g} cm",
        f"limit of {MAX_STEPS} steps",
    ]
    flat = " ".join(PAGE.split())
    assert [text for text in said if text not in flat] == []
