"""After an upgrade: which tasks changed meaning, by hashes, gates and verdicts on record."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from rpg import upgrade
from rpg.batch import ledger
from rpg.batch.entries import Entry
from rpg.batch.ledger import LOCKFILE
from rpg.batch.run import run_batch
from rpg.cli.main import run
from rpg.ir.artifact import GateReport, Program
from rpg.passes.codegen import read_goal
from rpg.passes.validate.findings import failure
from rpg.pipeline import compile_instruction
from rpg.store import Workspace
from rpg.upgrade import bank, verdicts
from tests.batch.test_run import ROW, STACK, Here


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    entries = (Entry("list:1", STACK), Entry("list:2", ROW))
    assert run_batch(entries, Workspace(tmp_path), Here(), pictures=False).good
    return tmp_path


def verify(root: Path, capsys: pytest.CaptureFixture[str]) -> tuple[int, dict[str, Any]]:
    status = run(["verify", "--all", "--json", "--tasks", str(root)])
    return status, json.loads(capsys.readouterr().out)


def found(document: dict[str, Any]) -> dict[str, list[str]]:
    return {family: [problem["code"] for problem in problems] for family, problems in document["families"].items()}


def lock(root: Path) -> dict[str, Any]:
    return dict(json.loads((root / LOCKFILE).read_text()))


def test_an_upgrade_that_changes_nothing_is_noted_in_the_lock(
    workspace: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(ledger, "mujoco_version", lambda: "9.9.9")
    status, document = verify(workspace, capsys)
    assert status == 0 and "9.9.9" in document["upgraded"]
    assert found(document) == {"red-left-of-blue": [], "red-on-yellow": []}
    assert lock(workspace)["mujoco"] == "9.9.9"
    assert verify(workspace, capsys)[1]["upgraded"] is None


def test_a_goal_that_judges_otherwise_is_named_with_the_state(
    workspace: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    document = lock(workspace)
    family = workspace / "red-on-yellow"
    snapshot = json.loads(next(family.glob("v0-*/snapshot.json")).read_text())["hash"]
    record = document["verdicts"][snapshot]
    document["verdicts"][snapshot] = record[:2] + ("0" if record[2] == "1" else "1") + record[3:]
    (workspace / LOCKFILE).write_text(json.dumps(document))
    monkeypatch.setattr(ledger, "mujoco_version", lambda: "9.9.9")
    status, answer = verify(workspace, capsys)
    assert status == 1
    assert found(answer) == {"red-left-of-blue": [], "red-on-yellow": ["goal-changed"]}
    assert "red_block moved 3 cm away" in answer["families"]["red-on-yellow"][0]["message"]
    assert lock(workspace)["mujoco"] != "9.9.9"


def test_a_gate_that_is_no_longer_passed_is_said(
    workspace: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def validate(program: Program) -> tuple[GateReport, ...]:
        if "yellow" not in program.task.instruction:
            return whole(program)
        return (GateReport.of("goal-state", [failure("goal-state", "goal-not-kept", "goal", "the stack falls")]),)

    whole = upgrade.validate_program
    monkeypatch.setattr(upgrade, "validate_program", validate)
    monkeypatch.setattr(ledger, "mujoco_version", lambda: "9.9.9")
    status, document = verify(workspace, capsys)
    assert status == 1
    assert found(document) == {"red-left-of-blue": [], "red-on-yellow": ["gate-no-longer-passed"]}
    assert "the stack falls" in document["families"]["red-on-yellow"][0]["message"]


def test_other_figures_alone_are_no_change_of_meaning(
    workspace: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    render = upgrade.render_log
    monkeypatch.setattr(upgrade, "render_log", lambda *given: render(*given).replace("moved_mm", "moved_mm 7"))
    monkeypatch.setattr(ledger, "mujoco_version", lambda: "9.9.9")
    status, document = verify(workspace, capsys)
    assert status == 0
    assert found(document)["red-on-yellow"] == ["figures-changed"]


def test_the_bank_tells_goals_apart_and_follows_from_the_files() -> None:
    outcome = compile_instruction(STACK)
    assert outcome.program is not None
    record = verdicts(outcome.program)
    states = [what for what, _ in bank(outcome.program)]
    assert len(record) == len(states) == len(set(states))
    assert record[0] == "1" and "0" in record
    path = read_goal(outcome.program.goal_code)
    assert path is not None
    assert verdicts(outcome.program.model_copy(update={"path": path})) == record
