"""The commands themselves, killed at any moment: what is there can be trusted, and what was finished is there."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.steer.kills import KINDS, kills

TIMES = 4
"""`make kills` does 200."""


@pytest.mark.parametrize("kind", sorted(KINDS))
def test_a_killed_command_leaves_a_sound_workspace(kind: str, tmp_path: Path) -> None:
    found = kills(kind, TIMES, tmp_path)
    assert found.problems == []
    assert found.kills + found.outlived == TIMES
    assert found.begun > 0
