"""Every diagnostic about an instruction comes up with its example, and its remedy works."""

from __future__ import annotations

import re
from functools import cache

import pytest

from rpg.core.codes import ROOMS, Code
from rpg.pipeline import Outcome, compile_instruction

SAID = [code for room in ("language", "feasibility", "arrange", "starts") for code in ROOMS[room]]
NO_WORDS = {"adapted", "start-unstable"}
"""A note about a task that is made; a chance of physics that no words bring about."""


def test_every_code_about_an_instruction_has_an_example_and_a_remedy() -> None:
    assert {code.id for code in SAID if not (code.example and code.remedy)} == NO_WORDS


@cache
def outcome_of(example: str) -> Outcome:
    """What becomes of an example, which two tests look at."""
    return compile_instruction(example)


@pytest.mark.parametrize("code", [code for code in SAID if code.example], ids=lambda code: code.id)
def test_what_is_refused_says_what_would_work(code: Code) -> None:
    outcome = outcome_of(code.example)
    errors = [diagnostic for diagnostic in outcome.diagnostics if diagnostic.severity == "error"]
    assert all(error.message and error.hint for error in errors)
    for wording in [text for error in errors for text in re.findall(r'"([^"]+\.)"', error.hint or "")]:
        assert compile_instruction(wording).status == "admitted", wording


@pytest.mark.parametrize("code", [code for code in SAID if code.example], ids=lambda code: code.id)
def test_the_example_brings_it_about(code: Code) -> None:
    outcome = outcome_of(code.example)
    assert code.id in [diagnostic.code for diagnostic in outcome.diagnostics]


@pytest.mark.parametrize("code", [code for code in SAID if code.remedy], ids=lambda code: code.id)
def test_the_remedy_works(code: Code) -> None:
    outcome = compile_instruction(code.remedy)
    assert outcome.status == "admitted", [diagnostic.message for diagnostic in outcome.diagnostics]
    assert code.id not in [diagnostic.code for diagnostic in outcome.diagnostics]
