"""That a sentence is read as what it means: its blocks, states that must hold, and near misses that must not."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from tests.corpus.entries import entry
from tests.corpus.judge import judge
from tests.corpus.run import read


def assert_means(text: str, meant: Mapping[str, Any]) -> None:
    """Fail, with the reason, where a sentence is refused or misread. `meant`: as in an entry of the corpus."""
    score = judge(entry("meant", "told", text, dict(meant)), read)
    assert score.outcome == "right", score.why
