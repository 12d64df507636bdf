"""No word of a sentence is passed over: with another one in its place it is another task, or refused."""

from __future__ import annotations

import pytest

from tests.corpus.mutations import mutants, reason, sample, unread

SAMPLE = 200
"""Of sentences that no longer change."""
EVERY = 5
"""Each fifth of them is read here."""


@pytest.mark.parametrize("text", sample(SAMPLE, 5, ("heldout", "fresh"))[::EVERY])
def test_another_word_is_another_task(text: str) -> None:
    assert not unread(text)


def test_changes_are_marked() -> None:
    changed = dict(mutants("step 1: put Red on the left"))
    assert changed["step 2: put Red on the left"] == "step [1>2]: put red on the left"
    assert changed["step 1: put Red on the right"] == "step 1: put red on the [left>right]"
    assert [reason(marked) is None for marked in changed.values()] == [False, True, True, True]
