"""Compiles in processes of their own: killed, side by side, and in other surroundings.

RPG_KILLS says how many are killed; a few unless it is set.
"""

from __future__ import annotations

import os
import random
import subprocess
import sys
import time
from pathlib import Path

import pytest

from rpg.cli.main import run

RPG = [sys.executable, "-m", "rpg"]


def source(compiled: Path, directory: Path, instruction: str) -> Path:
    """A task.yaml like the compiled one, with another instruction and so with another hash."""
    text = (compiled.parent / "task.yaml").read_text()
    old = next(line for line in text.splitlines() if line.startswith("instruction:"))
    path = directory / f"{instruction.replace(' ', '-')}.yaml"
    path.write_text(text.replace(old, f"instruction: {instruction}"))
    return path


def compile_in_process(path: Path, tasks: Path, **surroundings: object) -> subprocess.Popen[bytes]:
    command = [*RPG, "compile", "--from", str(path), "--tasks", str(tasks), "--no-pictures", "-q"]
    return subprocess.Popen(command, stdout=subprocess.PIPE, **surroundings)  # type: ignore[call-overload, no-any-return]


def test_killed_compiles_leave_a_sound_workspace(compiled: Path, tmp_path: Path) -> None:
    rng = random.Random(7)
    tasks = tmp_path / "tasks"
    finished = set()
    for attempt in range(int(os.environ.get("RPG_KILLS", "6"))):
        process = compile_in_process(source(compiled, tmp_path, f"attempt {attempt}"), tasks)
        if attempt:
            time.sleep(0.3 + rng.uniform(0.0, 1.0))
            process.kill()
        said, _ = process.communicate()
        if process.returncode == 0:
            finished.add(Path(said.decode().strip()))
        assert run(["verify", "--tasks", str(tasks), "-q"]) == 0
        assert all((path / "snapshot.json").is_file() for path in finished)
    assert finished
    assert run(["compile", "--from", str(source(compiled, tmp_path, "the last")), "--tasks", str(tasks), "-q"]) == 0
    assert not list(tasks.glob(".new-*"))


def test_two_compile_into_one_workspace(compiled: Path, tmp_path: Path) -> None:
    paths = [source(compiled, tmp_path, text) for text in ("one", "two", "one")]
    processes = [compile_in_process(path, tmp_path / "tasks") for path in paths]
    places = [process.communicate(timeout=60)[0].decode().strip() for process in processes]
    assert [process.returncode for process in processes] == [0, 0, 0]
    assert places[0] == places[2] != places[1]
    assert {Path(place).parent.name for place in places} == {"red-on-blue", "red-on-blue-2"}
    assert run(["verify", "--tasks", str(tmp_path / "tasks"), "-q"]) == 0


@pytest.mark.parametrize(
    "instruction",
    [
        "Stack two green blocks on the blue patch and spell the word CAT in front of it",
        "Sort two red, two blue and two green blocks by color, then stack the red ones",
    ],
)
def test_an_instruction_gives_the_same_bytes_in_other_surroundings(instruction: str, tmp_path: Path) -> None:
    written = []
    for seed in ("0", "4711"):
        directory = tmp_path / f"directory-{seed}"
        directory.mkdir()
        done = subprocess.run(
            [*RPG, "compile", instruction, "-q"],
            cwd=directory,
            env={**os.environ, "PYTHONHASHSEED": seed, "LANG": "C", "TZ": "Asia/Tokyo", "MUJOCO_GL": "disable"},
            capture_output=True,
            text=True,
        )
        assert done.returncode == 0, done.stderr
        place = directory / done.stdout.strip()
        written.append({file.name: file.read_bytes() for file in place.iterdir()} | {"": place.name.encode()})
    assert b"paraphrases:" in written[0]["task.yaml"]
    assert {"initial.png", "goal.png", "snapshot.json"} < set(written[0])
    assert written[0] == written[1]


def test_surroundings_change_no_byte(compiled: Path, tmp_path: Path) -> None:
    path = source(compiled, tmp_path, "anywhere")
    written = []
    for seed in ("0", "4711"):
        directory = tmp_path / f"directory-{seed}"
        directory.mkdir()
        process = compile_in_process(
            path,
            directory / "tasks",
            cwd=directory,
            env={**os.environ, "PYTHONHASHSEED": seed, "LANG": "C", "TZ": "Asia/Tokyo"},
        )
        place = Path(process.communicate(timeout=60)[0].decode().strip())
        written.append({file.name: file.read_bytes() for file in place.iterdir()} | {"": place.name.encode()})
    assert written[0] == written[1]
