"""The commands that steer: their JSON, their exit statuses, files, pipes and pictures."""

from __future__ import annotations

import io
import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from rpg.cli.main import run
from rpg.store import Family
from tests.store.test_verify import reseal


@pytest.fixture
def tasks(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Path:
    place = tmp_path / "tasks"
    assert run(["compile", "put the blue block on the red block", "--name", "tower", "--no-pictures", *at(place)]) == 0
    capsys.readouterr()
    return place


def at(tasks: Path) -> list[str]:
    return ["--tasks", str(tasks)]


def said(capsys: pytest.CaptureFixture[str], arguments: list[str], status: int = 0) -> Any:
    assert run([*arguments, "--json"]) == status
    return json.loads(capsys.readouterr().out)


def steer(capsys: pytest.CaptureFixture[str], tasks: Path, edit: str, status: int = 0, *more: str) -> Any:
    return said(capsys, ["steer", "tower", edit, "--no-pictures", *at(tasks), *more], status)


def test_a_steer_says_its_class_its_reference_and_its_proof(tasks: Path, capsys: pytest.CaptureFixture[str]) -> None:
    told = steer(capsys, tasks, "add a green block on top")
    assert (told["status"], told["category"], told["reference"], told["version"]) == ("admitted", "EXTEND", 0, 1)
    assert told["preserve"] == {"assets": True, "positions": True, "goals": True}
    assert told["axes"] == ["S", "V", "B"]
    goals = told["proof"]["goals"]
    assert goals["relation"] == "implies" and goals["states"] >= 500 and goals["only_new"] == 0
    assert told["proof"]["positions"]["identical"] == told["proof"]["positions"]["seeds"]
    assert told["mutation_score"] == 1.0
    assert Path(told["directory"]).is_dir()
    assert run(["verify", "tower", *at(tasks)]) == 0


def test_a_refused_edit_changes_nothing(tasks: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = sorted((path, path.read_bytes()) for path in (tasks / "tower").rglob("*") if path.is_file())
    told = steer(capsys, tasks, "remove the purple one", 3)
    assert told["status"] == "refused" and told["version"] is None
    (diagnostic,) = told["diagnostics"]
    start, end = diagnostic["span"]
    assert "remove the purple one"[start:end] == "the purple one"
    assert "red block" in diagnostic["hint"]
    assert sorted((path, path.read_bytes()) for path in (tasks / "tower").rglob("*") if path.is_file()) == before


def test_going_back_and_on_makes_a_sibling(tasks: Path, capsys: pytest.CaptureFixture[str]) -> None:
    steer(capsys, tasks, "add a green block on top")
    back = steer(capsys, tasks, "undo")
    assert back["reverted"] and back["version"] == 0
    assert (back["category"], back["reference"], back["axes"]) == ("TWEAK", 0, [])
    assert back["preserve"] == {"assets": True, "positions": True, "goals": True}
    assert back["proof"]["goals"]["relation"] == "equal" and not back["proof"]["diff"]["assets_changed"]
    assert all(gate["passed"] for gate in back["gates"]) and back["mutation_score"] == 1.0
    sibling = steer(capsys, tasks, "add a yellow block on top")
    assert (sibling["version"], sibling["reference"]) == (2, 0)
    from_one = steer(capsys, tasks, "add a white block on top", 0, "--from", "1")
    assert (from_one["version"], from_one["reference"]) == (3, 1)
    log = said(capsys, ["log", "tower", *at(tasks)])
    parents = {entry["version"]: entry["parent"] for entry in log["versions"]}
    hashes = {entry["version"]: entry["hash"] for entry in log["versions"]}
    assert parents == {0: None, 1: hashes[0], 2: hashes[0], 3: hashes[1]}


def test_a_loop_is_told_and_its_validation_reused(tasks: Path, capsys: pytest.CaptureFixture[str]) -> None:
    first = steer(capsys, tasks, "reverse the order")
    steer(capsys, tasks, "reverse the order")
    again = steer(capsys, tasks, "reverse the order")
    assert again["same_as"] == first["version"]
    assert again["status"] == "admitted"
    assert [gate["name"] for gate in again["gates"]] == [gate["name"] for gate in first["gates"]]


def test_diff_shows_a_state_for_each_difference(
    tasks: Path, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    steer(capsys, tasks, "swap the red and the blue block")
    told = said(capsys, ["diff", "tower@0", "tower@1", "--out", str(tmp_path / "out"), *at(tasks)])
    assert told["goals"]["relation"] == "disjoint"
    assert {witness["accepted_by"] for witness in told["witnesses"]} == {"old", "new"}
    for witness in told["witnesses"]:
        assert Path(witness["picture"]).read_bytes().startswith(b"\x89PNG")
        version = 0 if witness["accepted_by"] == "old" else 1
        states = tmp_path / "states.jsonl"
        states.write_text(json.dumps({"objects": witness["objects"]}) + "\n")
        for number in (0, 1):
            capsys.readouterr()
            run(["check", f"tower@{number}", "--states", str(states), *at(tasks)])
            assert json.loads(capsys.readouterr().out)["success"] == (number == version)


SESSIONS = """
sessions:
  - name: one
    base: put the blue block on the red block
    edits: [add a green block on top, remove the purple one, undo]
"""


def test_a_session_stops_or_goes_on(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "sessions.yaml"
    file.write_text(SESSIONS)
    command = ["session", str(file), "--no-pictures"]
    stopped = said(capsys, [*command, *at(tmp_path / "a")], 3)
    assert [turn["status"] for turn in stopped["sessions"][0]["turns"]] == ["admitted", "admitted", "refused"]
    whole = said(capsys, [*command, "--keep-going", *at(tmp_path / "b")], 3)
    assert [turn["status"] for turn in whole["sessions"][0]["turns"]] == ["admitted", "admitted", "refused", "admitted"]
    assert whole["sessions"][0]["turns"][-1]["version"] == 0


@pytest.mark.parametrize(
    "text", ["", "sessions: []", "sessions: [{name: x}]", "- base: [1]", ": :", "- {base: x, edit: y}"]
)
def test_a_file_that_is_no_session_is_bad_input(text: str, tmp_path: Path) -> None:
    file = tmp_path / "sessions.yaml"
    file.write_text(text)
    assert run(["session", str(file), *at(tmp_path / "tasks")]) == 2


def test_a_session_can_be_piped(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = (
        "put the blue block on the red block\n\n# a comment\nadd a green block on top\nundo\nlog\nquit\nnever read\n"
    )
    monkeypatch.setattr("sys.stdin", io.StringIO(lines))
    assert run(["session", "--no-pictures", *at(tmp_path / "tasks")]) == 0
    told = capsys.readouterr().out
    assert "EXTEND of version 0" in told and "back at" in told and "HEAD" in told


def test_a_piped_session_is_one_document(
    tasks: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO("Make the red block purple\nPaint the moon\nlog\nquit\n"))
    assert run(["session", "--task", "tower", "--tasks", str(tasks), "--json", "--no-pictures"]) == 3
    (session,) = json.loads(capsys.readouterr().out)["sessions"]
    assert [turn["status"] for turn in session["turns"]] == ["admitted", "refused"]


def test_what_was_changed_is_not_built_upon(tasks: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source = next(tasks.glob("*/v0-*/task.yaml"))
    source.write_text(source.read_text() + "\n")
    family = source.parent.parent.name
    assert run(["steer", family, "Make the red block purple", "--tasks", str(tasks), "--no-pictures"]) == 2
    said = capsys.readouterr().err
    assert "task.yaml differs" in said and f"rpg compile --from {source.parent}" in said
    assert len(list((tasks / family).glob("v*"))) == 1


@pytest.mark.parametrize("harm", ["removed", "changed", "unreadable"])
def test_nothing_is_built_upon_a_lineage_with_a_gap(tasks: Path, capsys: pytest.CaptureFixture[str], harm: str) -> None:
    steer(capsys, tasks, "add a green block on top")
    steer(capsys, tasks, "make the green block white")
    middle = next(tasks.glob("tower/v1-*"))
    if harm == "removed":
        shutil.rmtree(middle)
    else:
        file = middle / ("task.yaml" if harm == "changed" else "snapshot.json")
        file.write_bytes(file.read_bytes()[:-9])
    capsys.readouterr()
    assert run(["steer", "tower", "make the white block pink", "--no-pictures", *at(tasks)]) == 2
    said = capsys.readouterr().err
    assert middle.name.rpartition("-")[2] in said
    assert run(["verify", "tower", *at(tasks)]) == 1
    hint = said[said.rindex("rpg compile --from") :].partition(" makes")[0].split()
    assert run([*hint[1:], "--name", "apart", "--no-pictures", *at(tasks)]) == 0
    assert run(["steer", "apart", "make the white block pink", "--no-pictures", *at(tasks)]) == 0


def test_forged_edits_are_found_out(tasks: Path, capsys: pytest.CaptureFixture[str]) -> None:
    steer(capsys, tasks, "add a green block on top")
    version = Family(tasks / "tower").head()
    data = version.snapshot.model_dump(mode="json")
    data["steering"]["edits"][0]["asset"]["color"] = "pink"
    reseal(version, **data["steering"])
    assert run(["verify", "tower", *at(tasks)]) == 1
    assert "its edits do not lead from version 0" in capsys.readouterr().out


def test_words_over_several_lines_are_kept_as_one(tasks: Path, capsys: pytest.CaptureFixture[str]) -> None:
    steer(capsys, tasks, "add a green block\r\n on top")
    assert Family(tasks / "tower").head().snapshot.snapshot.description == "add a green block on top"
    assert run(["verify", "tower", *at(tasks)]) == 0


def test_a_missing_head_is_told_how_to_be_mended(tasks: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (head,) = tasks.glob("*/HEAD")
    head.unlink()
    assert run(["log", head.parent.name, "--tasks", str(tasks)]) == 2
    hint = capsys.readouterr().err.partition("; rpg ")[2].partition(" sets it")[0]
    assert run(hint.split()) == 0
    assert run(["log", head.parent.name, "--tasks", str(tasks)]) == 0
