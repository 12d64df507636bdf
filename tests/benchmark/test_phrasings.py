"""Every base instruction of the suites in other people's words: at least five phrasings of each mean the same."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import yaml

from rpg.benchmark.suites import SUITES, read_suite
from rpg.pipeline import CompileOptions, compile_instruction
from tests.corpus.entries import Entry, entry
from tests.corpus.judge import judge

HERE = Path(__file__).parent
MEANINGS: dict[str, dict[str, Any]] = yaml.safe_load((HERE / "listed.yaml").read_text())
PHRASINGS: dict[str, list[str]] = yaml.safe_load((HERE / "phrasings.yaml").read_text())
LISTED = {f"{suite}/{one.name}": one.instruction for suite in SUITES for one in read_suite(suite)}
ENOUGH = 5


def test_there_are_enough_phrasings_of_each_and_all_of_them_differ() -> None:
    assert set(PHRASINGS) == set(LISTED)
    for key, texts in PHRASINGS.items():
        words = {_words(text) for text in (LISTED[key], *texts)}
        assert len(words) == len(texts) + 1 > ENOUGH, key


@pytest.mark.parametrize("key", PHRASINGS)
def test_every_phrasing_is_admitted_and_means_the_same(key: str) -> None:
    for text in PHRASINGS[key]:
        outcome = compile_instruction(text, CompileOptions(paraphrases=0))
        assert outcome.status == "admitted", (text, [found.message for found in outcome.diagnostics])
        assert outcome.mutation_score == 1.0
        score = judge(_entry(key, text), lambda _, found=outcome: (found.schema, ()))
        assert score.outcome == "right", (text, score.why)


def _entry(key: str, text: str) -> Entry:
    return entry("dev", key, text, {**MEANINGS[key], "say": [text]})


def _words(text: str) -> str:
    return "".join(char for char in text.lower() if char.isalnum() or char == " ")
