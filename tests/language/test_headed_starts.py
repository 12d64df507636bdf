"""A start told in several notes under one heading, and what goes from one block to another; counts told in short."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means, start_and_end


@pytest.mark.parametrize(
    "text",
    [
        "Start: red on blue; green on yellow. Goal: red on green.",
        "Initially: red on blue. Green on yellow. Finally: red on green.",
        "Start: red on blue; green on yellow. Put red on green.",
    ],
)
def test_all_notes_under_a_heading_are_of_the_start(text: str) -> None:
    assert means(text) == (
        "There are a red block, a blue block, a green block and a yellow block. At the start, the red block is on the "
        "blue block. At the start, the green block is on the yellow block. The red block must be on the green block."
    )


def test_what_follows_a_heading_without_an_end_is_a_goal() -> None:
    text = "Start: red on blue. Green on red. Then blue on green."
    assert start_and_end(text)[0] == "At the start, the red block is on the blue block"


def test_a_command_is_no_note() -> None:
    assert code_of("Start: red on blue; build a row. Goal: green on blue.") == "ambiguous"


def test_the_order_of_a_row_that_is_there() -> None:
    text = "The blocks are in a row at first: red, green, blue. Put red on blue."
    assert start_and_end(text)[0] == (
        "At the start, the three blocks are in a row from left to right in the order red, green, blue"
    )


@pytest.mark.parametrize("text", ["Move red from blue to green.", "The red block goes from the blue block to the green "
                                  "one."])  # fmt: skip
def test_from_one_block_to_another(text: str) -> None:
    begun = ("At the start, the red block is on the blue block", "The red block must be on the green block.")
    assert start_and_end(text) == begun


_ELSEWHERE = ("Put red on blue. Then move red from blue to green.",
              "There are a red, a blue and a green patch. Move the cube from red to blue.")  # fmt: skip


@pytest.mark.parametrize("text", _ELSEWHERE)
def test_where_it_is_put_first_or_mats_have_colors(text: str) -> None:
    assert code_of(text) != ""


def test_one_and_the_others_of_a_number() -> None:
    told = means("Four blocks: one on the patch, the others in a row.")
    assert told == means("Put one of the four blocks on the patch and the others in a row.")


def test_equally_many() -> None:
    told = means("Equally many blocks on the red patch and the blue patch, four blocks.")
    assert told == means("As many blocks on the red patch as on the blue patch; there are four blocks.")


@pytest.mark.parametrize("text", ["At some point red must be on blue. In the end green is on blue.",
                                  "Red is briefly on blue, then green is on blue."])  # fmt: skip
def test_what_is_so_on_the_way_is_a_step(text: str) -> None:
    assert start_and_end(text)[1] == (
        "First, the red block must be on the blue block. Then, the green block must be on the blue block."
    )


def test_what_comes_off_a_mat_was_there() -> None:
    assert start_and_end("Red stays on the patch, blue comes off it.")[0].endswith(
        "the blue block is on the gray patch"
    )


def test_not_one_but_the_other() -> None:
    assert means("Not red but blue on the patch.") == means("Blue must be on the patch. Red must not be on the patch.")


def test_how_it_starts() -> None:
    plain = "At the start red is on green on blue; reverse the stack."
    assert means("Red on green on blue is how it starts; reverse the stack.") == means(plain)
