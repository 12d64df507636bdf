"""Sessions of edits: every turn has the class, the reference and the meaning that a person would expect."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.steer.harness import Mark, Script, play, scripts

SHARE = {"heldout": 0.8, "strangers": 0.8}
"""Of the turns that were not written with the grammar at hand, at least so many are right; none may be wrong."""
EVERY = {"dev": 6, "heldout": 6, "strangers": 72}
"""One in so many of these sessions is played here, all of them by `make corpus`."""
DEV = scripts("dev")[:: EVERY["dev"]]


@pytest.mark.parametrize("script", DEV, ids=[f"{script.file}-{script.number}" for script in DEV])
def test_turns_are_right(script: Script, tmp_path: Path) -> None:
    marks = list(play(script, tmp_path))
    problems = [f"{mark.edit}: {mark.score}: {mark.why}" for mark in marks if mark.score != "right"]
    assert not problems
    assert len(marks) == len(script.turns)


@pytest.mark.parametrize("split", SHARE)
def test_turns_kept_aside(split: str, tmp_path: Path) -> None:
    marks: list[Mark] = []
    played = scripts(split)[:: EVERY[split]]
    for number, script in enumerate(played):
        marks += play(script, tmp_path / str(number))
    wrong = [f"{mark.edit}: {mark.why}" for mark in marks if mark.score == "wrong"]
    total = sum(len(script.turns) for script in played)
    right = sum(mark.score == "right" for mark in marks)
    assert not wrong
    assert right >= SHARE[split] * total, f"{right} of {total}"
