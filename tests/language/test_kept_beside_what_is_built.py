"""What is kept beside a tower that is only built, and what is off a mat and anywhere else."""

from __future__ import annotations

import pytest

from tests.language.meaning import assert_means, means, start_and_end


@pytest.mark.parametrize(
    "text",
    [
        "Stack the two red blocks and keep the blue one next to the stack.",
        "Make a tower of two red blocks and keep the blue block beside the tower.",
    ],
)
def test_kept_beside_a_tower_to_be(text: str) -> None:
    start, end = start_and_end(text)
    assert start == ""
    assert "always" not in end
    assert "next to the tower of the two red blocks" in end


def test_kept_beside_a_tower_that_is_there() -> None:
    start, end = start_and_end(
        "There is a tower of red and blue. Keep the green block next to the tower and move the yellow one to the patch."
    )
    assert "the green block is next to the tower" in start
    assert "must always be next to the tower" in end


def test_off_the_mat_is_elsewhere() -> None:
    told = means("Clear the black patch: the two white blocks lying on it should end up off it, anywhere else.")
    assert "White block 2 must not be on the black patch" in told
    assert "moved" not in told


def test_elsewhere_alone_is_moved() -> None:
    assert "must be moved by at least 5 cm" in means("Move the red block somewhere else.")


def test_put_on_a_step_is_no_step() -> None:
    text = "Build a staircase of gray blocks, one, two and three high, and put the red block on its lowest step."
    hold, miss = (
        ["gray^red gray^gray gray^gray^gray"],
        ["gray gray^gray gray^gray^gray^red", "red gray^gray gray^gray^gray"],
    )
    assert_means(text, {"assets": {"gray": 6, "red": 1}, "hold": hold, "miss": miss})
