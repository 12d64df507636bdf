"""The corpus as a regression test: nothing is misread, and the share that is right does not fall.

Of its large parts a share is read here, evenly over all phenomena, and all of them by `make corpus`.
"""

from __future__ import annotations

import pytest

from tests.corpus.entries import SPLITS, load
from tests.corpus.fuzz import outcome
from tests.corpus.judge import Score
from tests.corpus.run import score, table
from tests.corpus.templates import case

FLOOR = {"dev": 0.98, "heldout": 0.89, "fresh": 0.93, "strangers": 0.88, "hunters": 0.68}
"""The least share of each split that must be right."""
EVERY = {"dev": 90, "heldout": 2, "strangers": 180, "hunters": 45}


@pytest.fixture(scope="module", params=SPLITS)
def scores(request: pytest.FixtureRequest) -> list[Score]:
    return score(request.param, every=EVERY.get(request.param, 1))


def test_nothing_is_misread(scores: list[Score]) -> None:
    misread = [f"{s.outcome}: {s.entry.text!r}: {s.why}" for s in scores if s.outcome in ("wrong", "crash")]
    assert not misread, "\n".join(misread)


def test_enough_is_right(scores: list[Score]) -> None:
    share = sum(s.outcome == "right" for s in scores) / len(scores)
    assert share >= FLOOR[scores[0].entry.split], table(scores)


def test_the_corpus_is_large_and_its_refusals_are_many() -> None:
    entries = [entry for split in SPLITS for entry in load(split)]
    assert len(entries) >= 400
    assert sum(bool(entry.refuse) for entry in entries) >= 80
    assert len({entry.text for entry in entries}) == len(entries)


@pytest.mark.parametrize("start", range(0, 300, 50))
def test_sentences_from_templates_are_never_misread(start: int) -> None:
    misread = [
        f"{one.text}: {why}"
        for one, (found, why) in ((case(seed), outcome(case(seed))) for seed in range(start, start + 50))
        if found in ("wrong", "crash")
    ]
    assert not misread, "\n".join(misread)
