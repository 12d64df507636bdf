"""The second reader by itself, whatever the first one reads: it may refuse, and never misreads."""

from __future__ import annotations

import pytest

from tests.corpus.entries import SPLITS, Entry, load
from tests.corpus.framed import scored

EVERY = 150
"""Each 150th sentence is read here, and all of them by `python -m tests.corpus.framed`."""
READ = 0.33
"""The share of them that it reads."""


@pytest.fixture(scope="module")
def sentences() -> list[Entry]:
    return [entry for split in SPLITS for entry in load(split)][::EVERY]


def test_the_second_reader_never_misreads(sentences: list[Entry]) -> None:
    found = [scored(entry) for entry in sentences]
    wrong = [(score.entry.text, told) for score, told in found if score.outcome in ("wrong", "crash")]
    assert not wrong
    read = [score for score, told in found if told and score.outcome == "right"]
    assert len(read) >= READ * len(found)
