"""What does not belong in a repository: places on one machine, promises."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FORBIDDEN = re.compile(r"(?<![\w.])/(?:work|root|home)/\w|\bTODO\b|\bFIXME\b|\bXXX\b|for now\b")


def tracked() -> list[Path]:
    names = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    return [ROOT / name for name in names.splitlines() if (ROOT / name).is_file()]


def test_no_places_of_one_machine_and_no_promises() -> None:
    for path in tracked():
        if path in (Path(__file__).resolve(), ROOT / "LICENSE") or path.suffix in (".png",):
            continue
        for number, line in enumerate(path.read_text(errors="replace").splitlines(), start=1):
            found = FORBIDDEN.search(line)
            assert found is None, f"{path.relative_to(ROOT)}:{number}: {found[0] if found else ''}"


def test_every_file_ends_as_text_should() -> None:
    for path in tracked():
        if path.suffix in (".py", ".md", ".yaml", ".toml"):
            text = path.read_text()
            assert not text or text.endswith("\n"), f"{path} has no newline at its end"
            assert "\r" not in text or path.parts[-2] == "corpus", f"{path} has carriage returns"
