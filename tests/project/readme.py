"""The README's console blocks: the commands in them, and what they print.

`python -m tests.project.readme` runs the commands and writes what they print into the README.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
README = ROOT / "README.md"
BLOCK = re.compile(r"```console\n(.*?)```", re.DOTALL)


def run_in(directory: Path, command: str) -> subprocess.CompletedProcess[str]:
    """Run a command of the README as a reader would, in an empty directory beside the examples."""
    words = [sys.executable, "-m", "rpg", *shlex.split(command)[1:]]
    environment = {**os.environ, "COLUMNS": "88"}
    return subprocess.run(
        words, cwd=directory, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120
    )


def surroundings(directory: Path) -> Path:
    """An empty directory with the examples in it."""
    shutil.copytree(ROOT / "examples", directory / "examples")
    return directory


def printed(directory: Path, command: str) -> str:
    """A console block: the command and what it prints."""
    lines = (line.rstrip() for line in run_in(directory, command).stdout.splitlines())
    return "\n".join([f"$ {command}", *lines]) + "\n"


def main() -> None:
    """Write what the commands print into the README."""
    with tempfile.TemporaryDirectory() as name:
        directory = surroundings(Path(name))
        text = BLOCK.sub(
            lambda match: f"```console\n{printed(directory, match[1].splitlines()[0][2:])}```", README.read_text()
        )
    README.write_text(text)


if __name__ == "__main__":
    main()
