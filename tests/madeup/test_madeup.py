"""Made-up sentences: most are read, and none is read wrong."""

from __future__ import annotations

from collections import Counter

from tests.madeup import made_up
from tests.madeup.judged import judged

SENTENCES = 80
READ = 0.7
"""At least so many are read right."""


def test_no_made_up_sentence_is_read_wrong() -> None:
    scores = [(sentence.text, judged(sentence)) for sentence in made_up(1, SENTENCES)]
    wrong = [f"{text}: {score.why}" for text, score in scores if score.outcome in ("wrong", "crash")]
    assert wrong == []
    assert Counter(score.outcome for _, score in scores)["right"] >= READ * SENTENCES


def test_they_depend_on_the_seed_alone() -> None:
    assert [*made_up(3, 30)] == [*made_up(3, 30)]
    assert [x.text for x in made_up(3, 30)] != [x.text for x in made_up(4, 30)]


def test_a_wrong_reading_would_be_found() -> None:
    """Each sentence has near misses, so that a task that everything solves is not taken for right."""
    assert all(sentence.hold for sentence in made_up(2, 60))
    assert sum(bool(sentence.miss) for sentence in made_up(2, 60)) > 45
