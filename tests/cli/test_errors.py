"""Mistakes get a sentence and an exit status, never a traceback."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from rpg.cli import errors, main
from rpg.core.diagnostics import Diagnostic, Refusal, Unavailable, UsageError

from .conftest import Rpg

RPG = [sys.executable, "-m", "rpg"]
STATE = json.dumps(
    {
        "objects": {
            name: {"position": [0.5, y, 0.97], "orientation": [1, 0, 0, 0]}
            for name, y in (("red_block", 0.0), ("blue_block", 0.1), ("A_block", 0.2))
        }
    }
)
"""A state of the task `compiled`, as a line of JSON."""


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("bogus",), "No such command"),
        (("log",), "Missing argument"),
        (("log", "x", "--bogus"), "No such option"),
        (("log", "nothing-like-it"), "no task 'nothing-like-it'"),
        (("show", "red-on-blu"), "did you mean red-on-blue?"),
        (("show", "red-on-blue", "--seed", "x"), "--seed"),
        (("show", "red-on-blue@9"), "it has 0"),
        (("compile",), "give an instruction"),
        (("compile", "a", "--from", "b"), "give an instruction"),
        (("compile", "a", "--name", "Not A Name"), "lower-case words"),
        (("compile", "--from", "missing.yaml"), "cannot read missing.yaml"),
        (("compile", "--from", "/"), "cannot read /"),
        (("check", "red-on-blue"), "--states"),
        (("export", "red-on-blue", "--format", "usd"), "mjcf"),
        (("checkout", "red-on-blue", "7"), "it has 0"),
        (("verify", "red-on-blu"), "did you mean"),
    ],
)
def test_mistakes_are_explained(rpg: Rpg, compiled: Path, arguments: tuple[str, ...], said: str) -> None:
    result = rpg(*arguments, *(("--tasks", compiled) if arguments[0] != "bogus" else ()))
    assert result.status == 2
    assert said in " ".join(result.err.split())
    assert "Traceback" not in result.err and not result.out


def test_a_script_gets_its_document_for_mistakes_too(rpg: Rpg, compiled: Path) -> None:
    result = rpg("show", "nothing", "--tasks", compiled, "--json")
    assert result.status == 2
    assert result.json["status"] == "error" and "nothing" in result.json["message"]


def test_a_taken_name_is_said_to_be(rpg: Rpg, compiled: Path, tmp_path: Path) -> None:
    text = (compiled.parent / "task.yaml").read_text()
    first, second = tmp_path / "a.yaml", tmp_path / "b.yaml"
    first.write_text(text)
    second.write_text(text.replace("red on top of it", "the red block on it"))
    shared = ("--tasks", tmp_path / "tasks", "--no-pictures", "-q", "--name", "mine")
    assert rpg("compile", "--from", first, *shared).status == 0
    assert rpg("compile", "--from", first, *shared).status == 0
    result = rpg("compile", "--from", second, *shared)
    assert (result.status, "another task called 'mine'" in result.err) == (2, True)


@pytest.mark.parametrize(
    ("error", "status"),
    [
        (UsageError("wrong"), 2),
        (Refusal([Diagnostic(code="unknown-word", message="wrong")]), 3),
        (Unavailable("wrong"), 4),
        (PermissionError(13, "wrong", "file"), 2),
    ],
)
def test_every_error_has_its_status(
    error: Exception, status: int, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(**_: object) -> None:
        raise error

    monkeypatch.setattr(main, "app", fail)
    assert main.run(["x", "--json"]) == status
    captured = capsys.readouterr()
    assert "wrong" in captured.err and "wrong" in json.loads(captured.out)["message"]


def test_a_bug_is_not_hidden(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(**_: object) -> None:
        raise ZeroDivisionError

    monkeypatch.setattr(main, "app", fail)
    with pytest.raises(ZeroDivisionError):
        main.run(["x"])
    assert errors.report(ZeroDivisionError(), as_json=False) is None


def test_an_interrupt_is_quiet(compiled: Path) -> None:
    command = [*RPG, "check", "red-on-blue", "--states", "-", "--tasks", str(compiled)]
    pipe = subprocess.PIPE
    process = subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=pipe, text=True)
    assert process.stdin and process.stdout
    print(STATE, file=process.stdin, flush=True)
    process.stdout.readline()  # it is at work by now, and waits for more
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=20)
    assert process.returncode == 130
    assert "Traceback" not in said


def test_a_reader_that_leaves_is_no_error(compiled: Path, tmp_path: Path) -> None:
    (tmp_path / "many.jsonl").write_text((STATE + "\n") * 2000)
    command = [*RPG, "check", "red-on-blue", "--states", str(tmp_path / "many.jsonl"), "--tasks", str(compiled)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout and process.stderr
    process.stdout.readline()
    process.stdout.close()
    said = process.stderr.read()
    process.stderr.close()
    assert process.wait(timeout=30) == 1
    assert not said


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_a_workspace_that_cannot_be_written(rpg: Rpg, compiled: Path, tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    result = rpg("compile", "--from", compiled.parent / "task.yaml", "--tasks", tmp_path / "tasks", "--no-pictures")
    assert (result.status, "choose another --tasks" in result.err) == (2, True)


@pytest.mark.parametrize("arguments", [("bogus",), ("show",), ("show", "x", "--seed", "x"), ("compile", "a", "b"), ()])
def test_a_script_gets_its_document_for_misuse_too(rpg: Rpg, arguments: tuple[str, ...]) -> None:
    result = rpg(*arguments, "--json")
    assert result.status == 2
    assert result.json["status"] == "error" and result.json["message"] in " ".join(result.err.split())


def test_the_version_is_told(rpg: Rpg) -> None:
    result = rpg("--version")
    assert (result.status, result.out.split()[0], result.err) == (0, "rpg", "")


@pytest.mark.parametrize("command", ["compile", "session", "batch"])
def test_files_that_would_eat_memory_or_the_stack(rpg: Rpg, tmp_path: Path, command: str) -> None:
    deep, wide = tmp_path / "deep.yaml", tmp_path / "wide.yaml"
    deep.write_text("[" * 100_000)
    rows = [f"r{at}: &r{at} [{', '.join([f'*r{at - 1}' if at else 'x'] * 10)}]" for at in range(12)]
    wide.write_text("\n".join([*rows, "sessions: [{name: *r11, base: Stack the red block on the blue block}]"]))
    for path in (deep, wide):
        result = rpg(command, *(("--from",) if command == "compile" else ()), path, "--tasks", tmp_path / "tasks")
        assert result.status == 2
        assert path.name in result.err and "Traceback" not in result.err


def test_view_with_a_back_end_that_there_is_not(compiled: Path) -> None:
    surroundings = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    command = [*RPG, "view", "red-on-blue", "--tasks", str(compiled)]
    done = subprocess.run(command, env=surroundings | {"MUJOCO_GL": "bogus"}, capture_output=True, text=True)
    assert (done.returncode, "no display" in done.stderr) == (4, True)


@pytest.mark.parametrize(
    "arguments", [("--help",), ("log", "red-on-blue", "--json"), ("log", "red-on-blue"), ("x", "--json")]
)
def test_an_output_that_takes_nothing(compiled: Path, arguments: tuple[str, ...]) -> None:
    command = [*RPG, *arguments, *(("--tasks", str(compiled)) if arguments[0] == "log" else ())]
    with Path("/dev/full").open("w") as full:
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True)
    assert (done.returncode, "Traceback" in done.stderr) == (2, False)
    assert "No space left" in done.stderr
    closed = subprocess.run(["sh", "-c", '"$@" >&- 2>&-', "sh", *command])
    assert closed.returncode == (2 if arguments[0] == "x" else 0)


@pytest.mark.parametrize("seconds", [0.1, 0.2, 0.3, 0.5])
def test_an_interrupt_is_quiet_at_any_moment(compiled: Path, seconds: float) -> None:
    command = [*RPG, "verify", "--json", "--tasks", str(compiled)]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    time.sleep(seconds)
    process.send_signal(signal.SIGINT)
    said, complained = process.communicate(timeout=60)
    assert "rpg/cli" not in complained
    if said and process.returncode == -signal.SIGINT:  # Python's own end was interrupted, and the answer is whole
        assert json.loads(said)
    elif "rpg" in complained or not complained:  # else it was Python's own start that was interrupted
        assert process.returncode in ((0, 130) if said else (130, -signal.SIGINT))


@pytest.mark.parametrize("encoding", ["ascii", "latin-1", "utf-8"])
def test_any_encoding_of_the_output(compiled: Path, encoding: str) -> None:
    surroundings = os.environ | {"PYTHONIOENCODING": encoding}
    for arguments, status in ((("show", "red-on-blue"), 0), (("compile", "Paint \U0001f600 \udcff"), 3)):
        for more in ((), ("--json",)):
            command = [*RPG, *arguments, "--tasks", str(compiled), *more]
            done = subprocess.run([os.fsencode(word) for word in command], env=surroundings, capture_output=True)
            assert (done.returncode, b"Traceback" in done.stderr) == (status, False)
            if more:
                json.loads(done.stdout.decode(encoding))


def test_what_a_terminal_would_obey_is_not_taken(rpg: Rpg, compiled: Path, tmp_path: Path) -> None:
    text = (compiled.parent / "task.yaml").read_text()
    old = next(line for line in text.splitlines() if line.startswith("instruction:"))
    for character in ("\\e[31m", "\\a", "\\u202e"):
        (tmp_path / "task.yaml").write_text(text.replace(old, f'instruction: "Put {character} it"'))
        result = rpg("compile", "--from", tmp_path / "task.yaml", "--tasks", tmp_path / "tasks")
        assert (result.status, "control character" in result.err) == (2, True)
    assert rpg("compile", "x", "--author", "\x1b[31m", "--tasks", tmp_path / "tasks").status == 2


def test_a_long_instruction_is_quoted_in_part(rpg: Rpg, tmp_path: Path) -> None:
    result = rpg("compile", "x" * 50_000, "--tasks", tmp_path / "tasks")
    assert result.status == 3
    assert len(result.err.splitlines()) < 30


@pytest.mark.parametrize("name", ['""', '"a\\nb"', '"../a"', "'a\"b'", '"' + "a" * 61 + '"'])
def test_names_that_no_object_has(rpg: Rpg, compiled: Path, tmp_path: Path, name: str) -> None:
    text = (compiled.parent / "task.yaml").read_text()
    (tmp_path / "task.yaml").write_text(text.replace("A_block", name))
    result = rpg("compile", "--from", tmp_path / "task.yaml", "--tasks", tmp_path / "tasks")
    assert (result.status, "assets[2].name" in result.err) == (2, True)
