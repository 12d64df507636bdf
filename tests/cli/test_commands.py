"""Each command does what its help says, for people and for scripts."""

from __future__ import annotations

import json
from pathlib import Path

import mujoco
import pytest

from rpg.cli.main import COMMANDS

from .conftest import SCHEMA, Rpg


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_has_help_with_an_example(rpg: Rpg, command: str) -> None:
    result = rpg(command, "--help")
    assert result.status == 0
    assert f"Example: rpg {command}" in result.out
    assert "--json" in result.out and "--quiet" in result.out


def test_compile_from_a_file(rpg: Rpg, tmp_path: Path, compiled: Path) -> None:
    result = rpg("compile", "--from", compiled.parent / "task.yaml", "--tasks", tmp_path, "--no-pictures", "--json")
    assert result.status == 0
    data = result.json
    assert set(data) == {
        "status", "family", "version", "hash", "directory", "goal_text", "assumptions", "gates", "diagnostics",
        "mutation_score",
    }  # fmt: skip
    assert (data["status"], data["family"], data["version"]) == ("admitted", "red-on-blue", 0)
    assert data["assumptions"] == ["the patch is green"]
    assert Path(data["directory"]).name == f"v0-{data['hash'][:7]}"
    assert all(gate["passed"] for gate in data["gates"]) and len(data["gates"]) == 9
    assert data["mutation_score"] == 1.0
    assert rpg(
        "compile", "--from", Path(data["directory"]) / "task.yaml", "--tasks", tmp_path, "--no-pictures", "-q"
    ).out
    assert [path.name for path in tmp_path.iterdir() if not path.name.startswith(".")] == ["red-on-blue"]


def test_compile_for_people(rpg: Rpg, tmp_path: Path, compiled: Path) -> None:
    result = rpg("compile", "--from", compiled.parent / "task.yaml", "--tasks", tmp_path)
    assert result.status == 0
    for said in ("red-on-blue@0", "the red block is on the blue block", "assumed: the patch is green", "✓  mutation"):
        assert said in result.out
    (version,) = (tmp_path / "red-on-blue").glob("v0-*")
    assert {path.name for path in version.iterdir()} >= {"initial.png", "goal.png"}
    assert rpg("verify", "--tasks", tmp_path).status == 0


def test_quiet_compile_says_where(rpg: Rpg, tmp_path: Path, compiled: Path) -> None:
    result = rpg("compile", "--from", compiled.parent / "task.yaml", "--tasks", tmp_path, "--no-pictures", "-q")
    (version,) = (tmp_path / "red-on-blue").glob("v0-*")
    assert result.out == f"{version}\n"
    assert not result.err


def test_a_task_that_fails_is_kept_apart(rpg: Rpg, tmp_path: Path, compiled: Path) -> None:
    text = (compiled.parent / "task.yaml").read_text().replace("init:", "init_:")
    solved = text.replace(
        "goal:\n", 'init:\n  arranged:\n    - kind: "on"\n      a: red_block\n      b: blue_block\ngoal:\n'
    )
    goal = solved[solved.index("goal:\n") :]
    bad = solved.replace(goal, 'goal:\n  kind: "on"\n  a: red_block\n  b: blue_block\n')
    (tmp_path / "task.yaml").write_text(bad)
    result = rpg("compile", "--from", tmp_path / "task.yaml", "--tasks", tmp_path / "tasks", "--no-pictures", "--json")
    assert (result.status, result.json["status"]) in ((1, "failed"), (3, "refused"))
    assert result.json["diagnostics"]


def test_show(rpg: Rpg, compiled: Path) -> None:
    data = rpg("show", "red-on-blue", "--tasks", compiled, "--json").json
    assert set(data) == {
        "name", "instruction", "version", "hash", "assets", "init", "goal", "goal_text", "assumptions", "stages"
    }  # fmt: skip
    assert data["instruction"] == SCHEMA.instruction
    red, _, letter, patch = data["assets"]
    assert red["type"] == "ColoredCube" and red["color"] == "red" and not red["fixed"]
    assert red["extent"] == [0.04] * 3 and len(red["position"]) == 3 and len(red["orientation"]) == 4
    assert letter["label"] == "A"
    assert patch["fixed"] and patch["position"][:2] == [0.5, 0.1] and patch["shape"] == "square"
    other = rpg("show", "red-on-blue", "--tasks", compiled, "--json", "--seed", "5").json
    assert other["assets"][0]["position"] != red["position"]
    assert other == rpg("show", "red-on-blue", "--tasks", compiled, "--json", "--seed", "5").json
    people = rpg("show", "red-on-blue@0", "--tasks", compiled).out
    assert SCHEMA.instruction in people and "red_block" in people


def test_log_and_checkout(rpg: Rpg, tasks: Path) -> None:
    data = rpg("log", "red-on-blue", "--tasks", tasks, "--json").json
    assert [version["version"] for version in data["versions"]] == [0]
    assert data["versions"][0]["steering"] is None
    assert "v0" in rpg("log", "red-on-blue", "--tasks", tasks).out
    (tasks / "red-on-blue" / "HEAD").write_text("nonsense\n")
    assert rpg("verify", "--tasks", tasks).status == 1
    assert rpg("checkout", "red-on-blue", "0", "--tasks", tasks).status == 0
    assert rpg("verify", "--tasks", tasks).status == 0


def test_verify_names_what_differs(rpg: Rpg, tasks: Path) -> None:
    (path,) = (tasks / "red-on-blue").glob("v0-*/code.py")
    path.write_text(path.read_text() + "\n")
    result = rpg("verify", "red-on-blue", "--tasks", tasks, "--json")
    assert result.status == 1
    assert [problem["code"] for problem in result.json["families"]["red-on-blue"]] == ["file-changed"]
    assert "code.py" in rpg("verify", "red-on-blue", "--tasks", tasks).out


def test_code_that_was_changed_is_not_run(rpg: Rpg, tasks: Path) -> None:
    (path,) = (tasks / "red-on-blue").glob("v0-*/code.py")
    path.write_text("raise SystemExit('ran')\n")
    for command in ("show", "render", "export"):
        result = rpg(command, "red-on-blue", "--tasks", tasks)
        assert result.status == 2
        assert "is not run" in result.err and "ran" not in result.out


def test_validate(rpg: Rpg, tasks: Path) -> None:
    assert rpg("validate", "red-on-blue", "--tasks", tasks, "--json").json["status"] == "passed"
    (path,) = (tasks / "red-on-blue").glob("v0-*/code.py")
    path.write_text(path.read_text().replace("self.on(", "self.off("))
    result = rpg("validate", "red-on-blue", "--tasks", tasks, "--json")
    assert result.status == 1
    assert result.json["gates"][-1]["name"] == "text" and not result.json["gates"][-1]["passed"]


def test_render(rpg: Rpg, compiled: Path, tmp_path: Path) -> None:
    result = rpg("render", "red-on-blue", "--tasks", compiled, "--out", tmp_path, "--json")
    assert [Path(name).name for name in result.json["files"]] == ["initial.png", "goal.png"]
    pictures = [(tmp_path / name).read_bytes() for name in ("initial.png", "goal.png")]
    assert all(picture.startswith(b"\x89PNG") for picture in pictures) and pictures[0] != pictures[1]


def test_export_is_loadable_by_plain_mujoco(rpg: Rpg, compiled: Path, tmp_path: Path) -> None:
    result = rpg("export", "red-on-blue", "--tasks", compiled, "--out", tmp_path, "--format", "mjcf", "--json")
    assert result.status == 0
    model = mujoco.MjModel.from_xml_path(str(tmp_path / "scene.xml"))
    assert model.nkey == 2 and model.ntex >= 2
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("goal").id)
    mujoco.mj_step(model, data, 200)
    red, blue = data.body("red_block").xpos, data.body("blue_block").xpos
    assert red[2] - blue[2] == pytest.approx(0.04, abs=1e-3)
    assert abs(red[:2] - blue[:2]).max() < 0.02


def test_view_without_a_display(rpg: Rpg, compiled: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("DISPLAY", raising=False)
    monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
    result = rpg("view", "red-on-blue", "--tasks", compiled)
    assert result.status == 4
    assert "rpg render red-on-blue" in result.err


def test_doctor_says_what_pictures_will_be_drawn_with(rpg: Rpg, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MUJOCO_GL", "disable")
    assert "casting rays, as MUJOCO_GL=disable asks" in rpg("doctor", "--json").json["graphics"]["detail"]


def test_doctor(rpg: Rpg) -> None:
    data = rpg("doctor", "--json").json
    assert set(data) == {"python", "mujoco", "graphics", "viewer", "sandbox", "models", "robot"}
    assert data["mujoco"]["ok"]
    for finding in data.values():
        assert finding["ok"] or finding["hint"] or "is used" in finding["detail"] or "needs none" in finding["detail"]


def test_options_may_stand_anywhere(rpg: Rpg, compiled: Path) -> None:
    wanted = json.dumps(rpg("log", "red-on-blue", "--tasks", compiled, "--json").json)
    for arguments in (
        ("--tasks", str(compiled), "--json", "log", "red-on-blue"),
        (f"--tasks={compiled}", "log", "--json", "red-on-blue"),
        ("log", "--json", "--tasks", str(compiled), "red-on-blue"),
    ):
        assert json.dumps(rpg(*arguments).json) == wanted


def test_the_workspace_may_come_from_the_environment(rpg: Rpg, compiled: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RPG_TASKS", str(compiled))
    assert rpg("log", "red-on-blue").status == 0


def test_an_instruction_is_compiled(rpg: Rpg, tmp_path: Path) -> None:
    result = rpg("compile", "Put the pink block on the brown block", "--tasks", tmp_path, "--no-pictures", "--json")
    assert result.status == 0
    data = result.json
    shown = rpg("show", data["family"], "--tasks", tmp_path, "--json").json
    assert {asset["color"] for asset in shown["assets"]} == {"pink", "brown"}
    assert shown["instruction"] == "Put the pink block on the brown block"
    again = rpg("compile", "Put the pink block on the brown block", "--tasks", tmp_path, "--no-pictures", "--json").json
    assert again == data


def test_a_refusal_is_data_and_a_picture_of_it(rpg: Rpg, tmp_path: Path) -> None:
    text = "Put the pink zorgle on the brown block"
    result = rpg("compile", text, "--tasks", tmp_path / "tasks", "--json")
    assert result.status == 3
    data = result.json
    assert (data["status"], data["family"], data["directory"]) == ("refused", None, None)
    (diagnostic,) = [d for d in data["diagnostics"] if d["severity"] == "error"]
    assert text[slice(*diagnostic["span"])] == "zorgle" and diagnostic["code"] == "unknown-word"
    people = rpg("compile", text, "--tasks", tmp_path / "tasks")
    assert (people.status, people.out) == (3, "")
    lines = [line.rstrip() for line in people.err.splitlines()]
    at = lines.index(f"  │ {text}")
    assert lines[at + 1] == "  │ " + " " * text.index("zorgle") + "^" * len("zorgle")
    assert not (tmp_path / "tasks").exists()
