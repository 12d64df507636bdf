"""The examples are there to be copied, so they work."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from rpg.cli.main import run
from rpg.pipeline import compile_instruction

ROOT = Path(__file__).resolve().parents[2]
LINES = (ROOT / "examples" / "instructions.txt").read_text().splitlines()
INSTRUCTIONS = [line for line in LINES if line and not line.startswith("#")]
SESSIONS = yaml.safe_load((ROOT / "examples" / "session.yaml").read_text())["sessions"]


@pytest.mark.parametrize("instruction", [*INSTRUCTIONS, *(session["base"] for session in SESSIONS)])
def test_an_example_is_admitted(instruction: str) -> None:
    outcome = compile_instruction(instruction)
    assert outcome.status == "admitted", [diagnostic.message for diagnostic in outcome.diagnostics]
    assert outcome.mutation_score == 1.0


def test_the_session_runs(tmp_path: Path) -> None:
    session = str(ROOT / "examples" / "session.yaml")
    assert run(["session", session, "--no-pictures", "--quiet", "--tasks", str(tmp_path)]) == 0
    assert run(["verify", "--tasks", str(tmp_path)]) == 0
    for example in SESSIONS:
        assert len(list((tmp_path / example["name"]).glob("v*-*"))) > 1
