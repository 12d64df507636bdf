"""What terminates, fails, and is somebody's destination; one thing or another; and towers that must not fall."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means, start_and_end

_DONE = "There are a red block and a blue block. The red block must be on the blue block."


@pytest.mark.parametrize(
    "text",
    [
        "The episode terminates with red on blue.",
        "Terminate when red is on blue.",
        "Stop the episode when red is on blue.",
        "The task fails if red isn't on blue at the end.",
        "No success unless red is on blue.",
        "The target position of the red block is on the blue block.",
    ],
)
def test_the_end_is_told(text: str) -> None:
    assert means(text) == _DONE


@pytest.mark.parametrize("text", ["The destination of the red block is the blue patch.",
                                  "Red's home is the blue patch.",
                                  "The blue patch is the goal for the red block."])  # fmt: skip
def test_where_it_belongs(text: str) -> None:
    assert start_and_end(text) == ("", "The red block must be on the blue patch.")


def test_where_it_is_is_no_destination() -> None:
    begun = "The position of the red block is on the blue patch. Move it to the green patch."
    ends = ("At the start, the red block is on the blue patch", "The red block must be on the green patch.")
    assert start_and_end(begun) == ends


@pytest.mark.parametrize("text", ["It doesn't matter whether red is on blue or blue on red.",
                                  "Red on blue or blue on red, it doesn't matter."])  # fmt: skip
def test_one_or_the_other(text: str) -> None:
    assert means(text) == means("Red is on blue or blue is on red.")


def test_pairs_are_one_to_one() -> None:
    assert means("Pair each red block with a blue one. There are two of each.") == (
        "There are two red blocks and two blue blocks. A red block must be next to a blue block. The other red block "
        "must be next to the other blue block."
    )


@pytest.mark.parametrize(
    "text",
    [
        "Don't let the tower fall while moving green on the patch; the tower is red on blue.",
        "The tower is red on blue. It must not collapse. Move green to the patch.",
        "The tower of red on blue must not fall. Put green on the patch.",
    ],
)
def test_a_tower_that_must_not_fall_is_there(text: str) -> None:
    begun, ends = start_and_end(text)
    assert begun == "At the start, the red and blue blocks are stacked from top to bottom in the order red, blue"
    assert ends == "The blue and red blocks must stay where they are. The green block must be on the gray patch."


@pytest.mark.parametrize("text", ["Build a tower of two red blocks. The tower must not fall.",
                                  "Stack two red blocks on each other; it must not fall over."])  # fmt: skip
def test_one_that_is_built_is_not_there(text: str) -> None:
    assert start_and_end(text)[0] == ""


def test_what_would_be_a_failure_at_any_time() -> None:
    assert code_of("The task fails if green touches the table.") == "misplaced-word"
