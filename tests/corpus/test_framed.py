"""The second and the third reader by themselves, whatever the first one reads: they may refuse, and never misread."""

from __future__ import annotations

import pytest

from tests.corpus.entries import SPLITS, Entry, load
from tests.corpus.framed import scored

EVERY = 150
"""Each 150th sentence is read here, and all of them by `python -m tests.corpus.framed`."""
READ = {"frames": 0.33, "parser": 0.08}
"""The share of them that each reads."""


@pytest.fixture(scope="module")
def sentences() -> list[Entry]:
    return [entry for split in SPLITS for entry in load(split)][::EVERY]


@pytest.mark.parametrize("reader", READ)
def test_no_reader_misreads(reader: str, sentences: list[Entry]) -> None:
    found = [scored(entry, reader) for entry in sentences]
    wrong = [(score.entry.text, told) for score, told in found if score.outcome in ("wrong", "crash")]
    assert not wrong
    read = [score for score, told in found if told and score.outcome == "right"]
    assert len(read) >= READ[reader] * len(found)
