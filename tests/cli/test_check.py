"""rpg check: a line of JSON in, a line out, and what is said about lines that are wrong."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from .conftest import Result, Rpg

GOAL: dict[str, Any] = {
    "blue_block": {"position": [0.5, 0.1, 0.97], "orientation": [1, 0, 0, 0]},
    "red_block": {"position": [0.5, 0.1, 1.01], "orientation": [1, 0, 0, 0]},
    "A_block": {"position": [0.6, -0.1, 0.97], "orientation": [0.7071068, 0, 0, 0.7071068]},
}
START = GOAL | {"red_block": {"position": [0.5, -0.1, 0.97], "orientation": [1, 0, 0, 0]}}


def check(rpg: Rpg, tasks: Path, directory: Path, *lines: Any) -> Result:
    path = directory / "states.jsonl"
    path.write_text("".join(line if isinstance(line, str) else json.dumps(line) + "\n" for line in lines))
    return rpg("check", "red-on-blue", "--states", path, "--tasks", tasks)


def test_a_line_out_for_each_line_in(rpg: Rpg, compiled: Path, tmp_path: Path) -> None:
    result = check(rpg, compiled, tmp_path, {"objects": GOAL}, {"objects": START}, "\n", {"objects": GOAL})
    answers = [json.loads(line) for line in result.out.splitlines()]
    assert [answer["success"] for answer in answers] == [True, False, True]
    assert result.status == 1
    for answer in answers:
        assert set(answer) == {"success", "margin", "conditions", "stage"}
        assert answer["success"] == (answer["margin"] >= 0)
        assert all(set(condition) == {"name", "value", "margin"} for condition in answer["conditions"])
    assert {c["name"]: c["value"] for c in answers[1]["conditions"]}["the red block is on the blue block"] is False
    assert check(rpg, compiled, tmp_path, {"objects": GOAL}).status == 0


def test_a_trajectory_is_judged_at_its_end(rpg: Rpg, compiled: Path, tmp_path: Path) -> None:
    there, back = [{"objects": START}, {"objects": GOAL}], [{"objects": GOAL}, {"objects": START}]
    result = check(rpg, compiled, tmp_path, {"trajectory": there}, {"trajectory": back})
    assert [json.loads(line)["success"] for line in result.out.splitlines()] == [True, False]


def test_a_fixed_patch_may_be_given(rpg: Rpg, compiled: Path, tmp_path: Path) -> None:
    at = {"position": [0.5, 0.1, 0.95], "orientation": [1, 0, 0, 0]}
    assert check(rpg, compiled, tmp_path, {"objects": GOAL | {"patch": at}}).status == 0
    result = check(rpg, compiled, tmp_path, {"objects": GOAL | {"patch": at | {"position": [0.4, 0.1, 0.95]}}})
    assert (result.status, "fixed at x = 0.500" in result.err) == (2, True)


def changed(name: str, **values: Any) -> dict[str, Any]:
    return {"objects": GOAL | {name: GOAL.get(name, {}) | values}}


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("{\n", "2:2: not JSON"),
        ("[1]\n", '2: a line is {"objects"'),
        ({"objekts": {}}, '2: a line is {"objects"'),
        ({"objects": GOAL, "trajectory": []}, '2: a line is {"objects"'),
        ({"objects": [1]}, "2: objects: should map names"),
        ({"trajectory": []}, "2: trajectory: should be a list of at least one state"),
        ({"trajectory": [{"objects": GOAL}, 5]}, "2: trajectory[1].objects: should map names"),
        ({"objects": {"red_block": GOAL["red_block"]}}, "2: objects: blue_block is missing"),
        (changed("red_blok", position=[0, 0, 1]), "2: objects: there is no 'red_blok'; did you mean red_block?"),
        (changed("red_block", position=[0, 0]), "2: objects.red_block.position: should be a list of 3 numbers"),
        (changed("red_block", position=[0, 0, "1"]), '2: objects.red_block.position: "1" is not a number'),
        (changed("red_block", position=[0, 0, True]), "2: objects.red_block.position: true is not a number"),
        (changed("red_block", position=[0, 0, float("nan")]), "2: objects.red_block.position: NaN is not a number"),
        (changed("red_block", orientation=[1, 1, 0, 0]), "should have length 1, this has 1.414"),
        (changed("red_block", velocity=[0, 0, 0]), "'velocity' is not known here"),
        ({"objects": GOAL | {"red_block": [1, 2, 3]}}, "2: objects.red_block: needs a position"),
    ],
)
def test_wrong_lines_are_named(rpg: Rpg, compiled: Path, tmp_path: Path, line: Any, said: str) -> None:
    result = check(rpg, compiled, tmp_path, {"objects": GOAL}, line)
    assert result.status == 2
    assert said in result.err
    assert len(result.out.splitlines()) == 1
    assert "Traceback" not in result.err


def test_a_file_that_is_not_there(rpg: Rpg, compiled: Path, tmp_path: Path) -> None:
    result = rpg("check", "red-on-blue", "--states", tmp_path / "none.jsonl", "--tasks", compiled)
    assert (result.status, "No such file" in result.err) == (2, True)


def test_states_stream_from_stdin(compiled: Path) -> None:
    command = [sys.executable, "-m", "rpg", "check", "red-on-blue", "--states", "-", "--tasks", str(compiled)]
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    assert process.stdin and process.stdout
    for state, success in ((GOAL, True), (START, False)):
        process.stdin.write(json.dumps({"objects": state}) + "\n")
        process.stdin.flush()
        assert json.loads(process.stdout.readline())["success"] is success
    process.stdin.close()
    assert process.wait(timeout=30) == 1
    process.stdout.close()


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ('{"objects": {"red_block": {"position": [1' + "0" * 5000 + ", 0, 0]}}}", "not JSON"),
        ('{"objects": {"red_block": {"position": [1' + "0" * 400 + ", 0, 0]}}}", "out of every range"),
        ("", "no state in it"),
        ("\n\n", "no state in it"),
    ],
)
def test_nothing_that_can_be_judged(rpg: Rpg, compiled: Path, tmp_path: Path, line: str, said: str) -> None:
    result = check(rpg, compiled, tmp_path, line)
    assert (result.status, said in result.err) == (2, True)
