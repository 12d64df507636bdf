"""Bad instructions are refused with exit status 3 and a diagnostic that helps; no traceback, nothing written."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from rpg.core.codes import CODES
from tests.cli.conftest import Rpg

BAD: list[tuple[str, str, str]] = yaml.safe_load(Path(__file__).with_name("bad_instructions.yaml").read_text())
LONG = "put the red block on the blue block " * 280


def test_there_are_enough_of_them() -> None:
    assert len({text for text, _, _ in BAD}) >= 40
    assert len({code for _, code, _ in BAD}) >= 25
    assert len(LONG) > 10_000


@pytest.mark.parametrize(("text", "code", "words"), [*BAD, (LONG, "too-long", "")], ids=lambda value: str(value)[:40])
def test_it_is_refused_with_its_reason(text: str, code: str, words: str, rpg: Rpg, tmp_path: Path) -> None:
    result = rpg("compile", text, "--json", "--tasks", tmp_path / "tasks")
    assert result.status == 3
    assert result.json["status"] == "refused"
    assert "Traceback" not in result.err
    errors = [found for found in result.json["diagnostics"] if found["severity"] == "error"]
    assert code in [found["code"] for found in errors], errors
    for found in errors:
        assert found["code"] in CODES
        assert found["message"]
        assert found["hint"] or found["span"]
    if words:
        spans = [found["span"] for found in errors if found["code"] == code and found["span"]]
        assert words in [text[start:end] for start, end in spans]


def test_people_see_the_words_that_matter_underlined(rpg: Rpg, tmp_path: Path) -> None:
    result = rpg("compile", "put the red block on the florb", "--tasks", tmp_path / "tasks")
    assert result.status == 3
    quoted, marks = (line for line in result.err.splitlines() if line.startswith("  │"))
    assert quoted[marks.index("^") : marks.rindex("^") + 1] == "florb"
    assert "hint" in result.err


def test_words_without_quotes_are_told_to_have_some(rpg: Rpg, tmp_path: Path) -> None:
    result = rpg("compile", "put", "the", "red", "block", "down", "--tasks", tmp_path / "tasks")
    assert result.status == 2
    assert 'rpg compile "put the red block down"' in result.err
