"""Whatever the README says to type works, and prints what it says."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

from .readme import BLOCK, README, ROOT, printed, run_in, surroundings

TEXT = README.read_text()
BLOCKS = BLOCK.findall(TEXT)
COMMANDS = re.findall(r"^\| `(rpg [^`]*)`", TEXT, re.MULTILINE)


@pytest.fixture(scope="module")
def directory(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return surroundings(tmp_path_factory.mktemp("reader"))


@pytest.fixture(scope="module")
def blocks(directory: Path) -> list[str]:
    """What the README's blocks print, one after the other as a reader types them."""
    return [printed(directory, block.splitlines()[0].removeprefix("$ ")) for block in BLOCKS]


def plain(text: str) -> list[str]:
    """The text without what differs between versions: hashes and figures."""
    return [re.sub(r"\b[0-9a-f]{7}\b|\d+(\.\d+)?", "N", line).rstrip() for line in text.splitlines()]


@pytest.mark.parametrize("number", range(len(BLOCKS)))
def test_commands_print_what_is_shown(number: int, blocks: list[str]) -> None:
    assert plain(blocks[number]) == plain(BLOCKS[number]), "python -m tests.project.readme"


@pytest.mark.parametrize("command", COMMANDS)
def test_listed_commands_work(command: str, directory: Path, blocks: list[str]) -> None:
    done = run_in(directory, command)
    assert done.returncode in (0, 1 if command.startswith("rpg check") else 0), done.stdout


def test_the_python_example_runs(directory: Path, blocks: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    (block,) = re.findall(r"```python\n(.*?)```", TEXT, re.DOTALL)
    monkeypatch.chdir(directory)
    exec(compile(block, "README.md", "exec", dont_inherit=True), {})


def test_the_two_commands_are_targets() -> None:
    for target in re.findall(r"^    make (\w+)", TEXT, re.MULTILINE):
        done = subprocess.run(["make", "--dry-run", target], cwd=ROOT, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr


def test_pictures_and_links_are_there() -> None:
    for link in re.findall(r"\]\(([\w./-]+)\)", TEXT):
        assert (ROOT / link).exists(), link
    assert len(TEXT.splitlines()) < 120
