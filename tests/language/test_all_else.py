"""What "anything else" is: all that the clauses do not act on, landmarks of what is done among them."""

from __future__ import annotations

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import means

_THERE = "There are a red, a green, a blue and a yellow block. "


@pytest.mark.parametrize(
    "text",
    [
        "Put red on the mat and green on blue without touching anything else.",
        "Put red on the mat and put green on blue without moving anything else.",
        "Put red on the mat and green on blue. Don't move anything else.",
        "Put red on the mat and green on blue and move nothing else.",
        "Put red on the mat and green on blue. Leave all the others where they are.",
    ],
)
def test_what_another_is_put_on_is_not_moved_and_what_is_put_is(text: str) -> None:
    told = means(_THERE + text)
    assert "The blue and yellow blocks must stay where they are." in told
    assert "At the start" not in told
    assert "must not touch" not in told


def test_where_no_others_are_told_of_the_landmark_is_not_moved_either() -> None:
    told = means("Put the red block on the blue block. Don't move anything else.")
    assert "The blue, green, yellow and purple blocks must stay where they are." in told


def test_what_it_is_next_to_is_none_of_what_it_must_not_touch() -> None:
    for text in ("The red block should be next to the green one without touching anything else.",
                 "The red block is next to the green one and touches nothing else."):  # fmt: skip
        told = means(text + " There is a blue block.")
        assert "The red block must not touch the blue block." in told
        assert "must not touch the green" not in told


def test_what_rests_on_a_block_touches_it() -> None:
    task, notes = BuiltinFrontEnd().read("Put red on blue so that it does not touch blue.")
    assert task is None
    assert notes[0].code == "contradiction"


def test_a_small_u_before_shape_is_a_letter() -> None:
    assert "must form a U shape" in means("u shape with 7 orange cubes, flat on the table")


def test_what_is_built_is_said() -> None:
    task, notes = BuiltinFrontEnd().read("Build from 7 orange cubes, flat on the table.")
    assert task is None
    assert notes[0].code == "no-goal"


@pytest.mark.parametrize("behind", ["A", "it"])
def test_a_landmark_that_is_not_touched_is_not_touched_at_the_end(behind: str) -> None:
    told = means(f"Put the red block next to A without touching {behind}.")
    assert "The red block must not touch the A block." in told
    assert "stay" not in told


def test_no_landmark_of_several_is_touched_and_each_of_what_is_put_touches_none() -> None:
    told = means("Place the red block between A and B without touching either of them.")
    assert "must not touch the A block. The red block must not touch the B block." in told
    told = means("Put A and B next to C without touching C.")
    assert "The A block must not touch the C block. The B block must not touch the C block." in told


def test_a_block_that_is_no_landmark_and_is_not_touched_is_left_where_it_is() -> None:
    assert "The C block must stay where it is." in means("Put A near B without touching C.")
