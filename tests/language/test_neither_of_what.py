"""What "neither", "exactly those" and numbers of a stock are told of, where a careless reading takes something else."""

from __future__ import annotations

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import means


@pytest.mark.parametrize(
    "text",
    [
        "Two of the three blue blocks belong on the red patch, the third belongs on the yellow patch, and the white "
        "block on neither.",
        "Put two blue blocks on the red mat, a green block on the yellow mat and the white one on neither of them.",
        "A and B on the red patch, C on the yellow patch, and the white block on neither.",
    ],
)
def test_on_neither_is_on_none_of_the_patches(text: str) -> None:
    told = means(text)
    assert "The white block must not be on the red patch." in told
    assert "The white block must not be on the yellow patch." in told


def test_neither_of_blocks_told_together_is_none_of_these() -> None:
    told = means("Stack red and green, and put white on neither.")
    assert "The white block must not be on the red block." in told
    assert "The white block must not be on the green block." in told


@pytest.mark.parametrize("exactly", ["Exactly", "Precisely", "Only"])
def test_exactly_those_are_there_and_no_others(exactly: str) -> None:
    told = means(f"{exactly} the blue cubes are on the mat. There are two blue cubes and a yellow one.")
    assert "The two blue blocks must be on the gray patch." in told
    assert "The yellow block must not be on the gray patch." in told


def test_exactly_in_the_middle_is_no_count() -> None:
    told = means("Put the red block exactly in the middle of the mat.")
    assert told.startswith("There is a red block. There is a gray patch.")
    assert "The red block must be at most 2 cm from the gray patch." in told


@pytest.mark.parametrize(
    "text",
    [
        "Spell HELLO, but use only one block with an L on it.",
        "Spell HELLO. Use one L block.",
        "There is one O block. Spell NOON.",
        "Spell NOON. There are two N blocks and one O block.",
    ],
)
def test_more_letters_than_there_are_is_refused(text: str) -> None:
    task, notes = BuiltinFrontEnd().read(text)
    assert task is None
    assert notes[0].code == "count-mismatch"


def test_as_many_letters_as_there_are() -> None:
    assert "spell the word NOON" in means("There are two O blocks and two N blocks. Spell NOON.")


@pytest.mark.parametrize(
    ("text", "each"),
    [
        ("Two towers of the same height out of eight blocks, one red, the other blue.", "four"),
        ("Build two towers from eight blocks, the left one red, the right one blue.", "four"),
        ("Build two towers using six blocks, the left one red, the right one blue.", "three"),
        ("Build two towers of four blocks, the left one red, the right one blue.", "four"),
        ("Build two towers using four blocks each, the left one red, the right one blue.", "four"),
    ],
)
def test_from_so_many_blocks_is_the_number_of_all_of_them(text: str, each: str) -> None:
    assert f"There are {each} red blocks and {each} blue blocks." in means(text)


def test_two_towers_from_six_are_of_three() -> None:
    assert means("Build two towers from six red blocks, one on the left and one on the right.").startswith(
        "There are six red blocks."
    )


@pytest.mark.parametrize(
    "text",
    [
        "Put A on the red mat and B on the blue mat. Put C on top of one of them.",
        "A on the red patch, B on the blue patch and C on top of either of them.",
    ],
)
def test_on_top_of_one_of_them_is_not_on_one_of_the_mats(text: str) -> None:
    task, notes = BuiltinFrontEnd().read(text)
    assert task is None
    assert notes[0].code == "ambiguous"


def test_on_top_of_a_mat_is_on_it() -> None:
    assert "The red block must be on the gray patch." in means("There is a mat. Put a red block on top of it.")


@pytest.mark.parametrize("clear", ["First clear the patch", "Clear the patch", "First empty the blue patch"])
def test_what_lies_on_a_patch_that_is_to_be_cleared_starts_there(clear: str) -> None:
    told = means(f"The red block is on the blue patch. {clear}, then put the green block on it.")
    assert "At the start, the red block is on the blue patch." in told
    assert "The red block must be on the blue patch." not in told


def test_none_of_another_one_is_nothing() -> None:
    text = "There are four blocks. Every one of them has to be on another one, none on the table."
    assert BuiltinFrontEnd().read(text)[0] is None


@pytest.mark.parametrize(
    "text",
    [
        "Put A on B. C is only a distractor and must not be moved.",
        "Put A on B. C is a distractor, and it must not be touched.",
        "C is a distractor and must not be moved. Put A on B.",
    ],
)
def test_what_must_not_be_moved_is_the_distractor(text: str) -> None:
    told = means(text)
    assert "The C block must stay where it is." in told
    assert "The A block must stay where it is." not in told


def test_distractors_that_are_counted_and_named_are_no_more_than_counted() -> None:
    told = means("Put red on blue. There are two distractors, one green and one yellow.")
    assert "There are also a green block and a yellow block as distractors." in told


@pytest.mark.parametrize(
    "text",
    [
        "Put red on blue. Add three distractors, one green and one yellow.",
        "Spell the word CAB with letter blocks. Use only the letters A and B.",
    ],
)
def test_numbers_and_letters_that_do_not_add_up_are_refused(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None


def test_a_line_that_begins_with_the_last_that_is_listed_is_in_no_order() -> None:
    told = means("Line up A, B, C and D so that the line begins with D and ends with A.")
    assert "in a row with the D block at the left end and the A block at the right end" in told
