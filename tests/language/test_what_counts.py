"""What counts, said of a task that was told already, is left out where the task says so, and nowhere else."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

EITHER = "Either the red block is on the green block or the green block is on the red block"
CORNERS = "One block in each of the four corners of the table"


@pytest.mark.parametrize(
    ("text", "clause"),
    [
        (EITHER, ". Both outcomes should pass."),
        (EITHER, "; both count as success."),
        ("Put red on green or on blue", ". Each of the two outcomes is okay."),
        (CORNERS, ", success is only counted when all four are there."),
        (CORNERS, "; it only counts if all four corners are filled."),
        ("A, B and C on the mat", ". The task is done once all three are in place."),
        ("First A on the mat, then B on A", ". The episode is successful when everything is in place."),
    ],
)
def test_what_counts_anyway_changes_nothing(text: str, clause: str) -> None:
    assert means(text + clause) == means(text + ".")


@pytest.mark.parametrize(
    "text",
    [
        f"{EITHER}. Only the first outcome counts.",
        f"{EITHER}. No outcome counts.",
        "Red on green and blue on yellow. Both are correct.",
        f"{CORNERS}. Success only when all three are there.",
        f"{CORNERS}, success when none of them is there.",
        "Red on blue or green on blue. Success when both are there.",
        "Put A on the mat. All blocks must be in place.",
    ],
)
def test_what_would_change_the_task_is_refused(text: str) -> None:
    assert code_of(text)


def test_either_of_two_sums() -> None:
    told = means("Both 2+3=5 and 5=2+3 are acceptable, one cube each for 2, 3, 5, plus and equals.")
    assert "Either the blocks 2, +, 3, = and 5 must form the equation 2+3=5, or" in told
