"""No sentence is passed over that follows others: the task is another one by it, or it is refused."""

from __future__ import annotations

import pytest

from tests.corpus.followed import passed_over, texts

EVERY = 10
"""Each tenth of them is read here, and all of them by `python -m tests.corpus.followed`."""


@pytest.mark.parametrize(("text", "more"), list(texts(EVERY)))
def test_one_more_sentence_is_another_task(text: str, more: str) -> None:
    assert not passed_over(text, more)
