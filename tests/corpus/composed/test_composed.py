"""Composed sentences: none may be misread, few refused."""

from __future__ import annotations

from collections import Counter

import pytest

from tests.corpus.composed.run import FAMILIES, drawn, scored

DRAWN = 60
REFUSED = 0.1
"""Of those drawn, at most this share may be refused."""
AROUND = {"talk": 0.3}
"""Of what people say around a task there is no end: more of it may be refused."""


@pytest.mark.parametrize("family", FAMILIES)
def test_none_is_misread_and_few_are_refused(family: str) -> None:
    scores = [scored(drawn(family, seed)) for seed in range(DRAWN)]
    wrong = [(s.entry.text, s.why) for s in scores if s.outcome in ("wrong", "crash")]
    assert not wrong
    outcomes = Counter(s.outcome for s in scores)
    most = AROUND.get(family, REFUSED) * DRAWN
    assert outcomes["refused"] <= most, [s.entry.text for s in scores if s.outcome == "refused"]
