"""Every diagnostic about an instruction comes up with its example, and its remedy works."""

from __future__ import annotations

import pytest

from rpg.core.codes import ROOMS, Code
from rpg.pipeline import compile_instruction

SAID = [code for room in ("language", "feasibility") for code in ROOMS[room]]


@pytest.mark.parametrize("code", [code for code in SAID if code.example], ids=lambda code: code.id)
def test_the_example_brings_it_about(code: Code) -> None:
    outcome = compile_instruction(code.example)
    assert code.id in [diagnostic.code for diagnostic in outcome.diagnostics]


@pytest.mark.parametrize("code", [code for code in SAID if code.remedy], ids=lambda code: code.id)
def test_the_remedy_works(code: Code) -> None:
    outcome = compile_instruction(code.remedy)
    assert outcome.status == "admitted", [diagnostic.message for diagnostic in outcome.diagnostics]
    assert code.id not in [diagnostic.code for diagnostic in outcome.diagnostics]
