"""Every base instruction of the suites is admitted, and `rpg check` tells its successes from its near-misses."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
import yaml

from rpg.batch.entries import Entry
from rpg.benchmark.suites import SUITES, read_suite
from rpg.blocks.state import BlockState
from rpg.cli.main import run
from rpg.ir.schema import TaskSchema
from rpg.store import Workspace
from tests.corpus.looks import Binding
from tests.corpus.states import Painter

EXPECTED: dict[str, dict[str, Any]] = yaml.safe_load(Path(__file__).with_name("listed.yaml").read_text())
LISTED = {f"{suite}/{entry.name}": entry for suite in SUITES for entry in read_suite(suite)}


def test_every_instruction_has_its_states() -> None:
    assert set(EXPECTED) == set(LISTED) and len(LISTED) == 42


@pytest.mark.parametrize("key", LISTED)
def test_it_is_admitted_and_means_what_it_says(key: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    compiled = _compiled(LISTED[key], tmp_path, capsys)
    assert compiled["status"] == "admitted", compiled["diagnostics"]
    assert compiled["mutation_score"] == 1.0
    schema = Workspace(tmp_path).family(compiled["family"]).head().schema
    wanted = EXPECTED[key]
    binding = Binding(schema, wanted.get("assets"))
    binding.check()
    painter = Painter(binding)
    for value in (True, False):
        for picture in wanted.get("hold" if value else "miss", ()):
            line = _line(picture, painter)
            assert _checked(compiled["family"], line, tmp_path, capsys) is value, (key, picture)
    assert schema.init.arranged or "start" not in wanted
    _start_as_said(schema, wanted, painter)


def _compiled(entry: Entry, root: Path, capsys: pytest.CaptureFixture[str]) -> dict[str, Any]:
    run(["compile", entry.instruction, "--json", "--no-pictures", "--tasks", str(root)])
    found: dict[str, Any] = json.loads(capsys.readouterr().out)
    return found


def _line(picture: str | list[str], painter: Painter) -> dict[str, Any]:
    if isinstance(picture, str):
        return {"objects": _objects(painter.state(picture))}
    start = painter.state(picture[0])
    states = [start, *(painter.state(later, start) for later in picture[1:])]
    return {"trajectory": [{"objects": _objects(state)} for state in states]}


def _objects(state: BlockState) -> dict[str, Any]:
    return {n: {"position": p, "orientation": state.orientation[n]} for n, p in state.position.items()}


def _checked(family: str, line: dict[str, Any], root: Path, capsys: pytest.CaptureFixture[str]) -> bool:
    states = root / "states.jsonl"
    states.write_text(json.dumps(line) + "\n")
    run(["check", family, "--states", str(states), "--tasks", str(root)])
    return bool(json.loads(capsys.readouterr().out)["success"])


def _start_as_said(schema: TaskSchema, wanted: dict[str, Any], painter: Painter) -> None:
    from rpg.blocks.evaluate import evaluate

    for picture in wanted.get("start", ()):
        for goal in schema.init.arranged:
            assert evaluate(goal, painter.state(picture)), picture
