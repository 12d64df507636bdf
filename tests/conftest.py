"""The order of the test files, the long ones first, so that no worker is left with one at the end; and the garbage
collector, which need not look again and again through what is there for good."""

from __future__ import annotations

import gc
from pathlib import Path

import pytest

from rpg.cli import SELDOM

HERE = Path(__file__).parent
LONG = (
    "blocks/test_random_goals.py",
    "steer/test_sessions.py",
    "corpus/test_corpus.py",
    "steer/test_kills.py",
    "project/test_readme.py",
    "language/test_one_of_many_words.py",
    "cli/test_errors.py",
    "cli/test_processes.py",
    "batch/test_processes.py",
    "steer/test_processes.py",
    "batch/test_ci_examples.py",
)
"""Files that take half a minute or more, the longest first."""

gc.set_threshold(SELDOM)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Put the long files first."""
    rank = {HERE / name: number for number, name in enumerate(LONG)}
    items.sort(key=lambda item: rank.get(item.path, len(LONG)))
