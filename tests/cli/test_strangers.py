"""Directories from strangers: whatever their files and hashes say, their code runs confined or not at all."""

from __future__ import annotations

from pathlib import Path

import pytest

from rpg.store import Content, Workspace, resolve, write_base

from .conftest import Rpg

ENDLESS = "        endless = [0 for a in range(10000000) for b in range(10000000) if a < 0]\n"
LARGE = "        large = [0] * 10000000000\n"
STATES = (
    '{"objects": {"red_block": {"position": [0.5, 0, 0.97]}, "blue_block": {"position": [0.5, 0.1, 0.97]}, '
    '"A_block": {"position": [0.5, 0.2, 0.97]}}}\n'
)


def forged(compiled: Path, tasks: Path, line: str) -> Path:
    """A version with hashes that fit, said to be written by a model, whose goal begins with `line`."""
    version = resolve(Workspace(compiled), "red-on-blue")
    files = {name: (version.directory / name).read_bytes() for name in version.snapshot.files}
    head = b"    def _success(self) -> Verdict:\n"
    assert head in files["code.py"]
    files["code.py"] = files["code.py"].replace(head, head + line.encode())
    content = Content(files, "forged", version.snapshot.snapshot.assets_used, "forged", {}, backend="llm")
    return write_base(Workspace(tasks), "forged", content).version.directory


@pytest.mark.parametrize("command", ["check", "show"])
@pytest.mark.parametrize("line", [LARGE, ENDLESS])
def test_code_with_a_forged_origin_is_tried_confined(
    rpg: Rpg, compiled: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: str, line: str
) -> None:
    from rpg.core import isolate
    from rpg.passes.validate import runner

    monkeypatch.setattr(runner, "Limits", lambda: isolate.Limits(seconds=2.0))
    (tmp_path / "states.jsonl").write_text(STATES)
    task = forged(compiled, tmp_path / "tasks", line)
    result = rpg(command, task, *(("--states", tmp_path / "states.jsonl") if command == "check" else ()))
    assert (result.status, "is not run" in result.err) == (2, True)


def test_the_hint_about_a_changed_file_works(rpg: Rpg, tasks: Path) -> None:
    directory = resolve(Workspace(tasks), "red-on-blue").directory
    with (directory / "code.py").open("a") as file:
        file.write("import os\n")
    said = rpg("show", directory)
    command = said.err.partition("; rpg ")[2].partition(" says more")[0].split()
    found = rpg(*command)
    assert (said.status, found.status) == (2, 1)
    assert "code.py differs" in found.out
