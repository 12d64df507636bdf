"""A choice between two mats that other parts of the text lean on, and numbers of blocks on mats compared."""

from __future__ import annotations

import pytest

from tests.language.meaning import assert_means, code_of, means

MATS = {"red_patch": 1, "blue_patch": 1}


@pytest.mark.parametrize(
    "text",
    [
        "One mat stays empty, the other gets all three gray blocks. The mats are red and blue.",
        "There is a red mat and a blue one. Put the three gray blocks on one of them and leave the other empty.",
        "All three gray blocks go on one patch, nothing on the other one. One patch is red and one is blue.",
    ],
)
def test_one_of_two_mats_and_the_other(text: str) -> None:
    assert_means(
        text,
        {
            "assets": {"gray": 3, **MATS},
            "hold": ["gray gray | gray . pitch=1.1 at=red_patch", "gray gray | gray . pitch=1.1 at=blue_patch"],
            "miss": ["gray gray pitch=1.1 at=red_patch ; gray at=blue_patch", "gray gray pitch=1.1 at=red_patch"],
        },
    )


def test_look_alikes_on_either_mat() -> None:
    assert_means(
        "There is a red mat and a blue mat. Put one green block on one mat and two on the other.",
        {
            "assets": {"green": 3, **MATS},
            "hold": ["green#2 at=red_patch ; green#1 green#3 pitch=1.1 at=blue_patch",
                     "green#1 green#2 pitch=1.1 at=red_patch ; green#3 at=blue_patch"],
            "miss": ["green green green pitch=1.1 at=red_patch", "green at=red_patch ; green at=blue_patch"],
        },
    )  # fmt: skip


@pytest.mark.parametrize(
    "text",
    [
        "There are a red and a blue mat. Put the white block and the black block on the same mat.",
        "Put the white block and the black block on the red patch or the blue patch. They have to share one.",
        "The white and the black cube share one mat, either the red or the blue one.",
        "The white block goes either on the red or on the blue mat. The black one goes on the same mat.",
    ],
)
def test_the_same_mat_whichever(text: str) -> None:
    assert_means(
        text,
        {
            "assets": {"white": 1, "black": 1, **MATS},
            "hold": ["white black pitch=1.1 at=red_patch", "white black pitch=1.1 at=blue_patch"],
            "miss": ["white at=red_patch ; black at=blue_patch", "white at=red_patch"],
        },
    )


def test_a_tower_on_one_of_two_mats_is_one_on_either() -> None:
    told = means(
        "I have a red and a blue mat. Build a tower of A, B and C on one of the mats. The other should hold D."
    )
    assert told.count("must form a tower of exactly three") == 2


@pytest.mark.parametrize(
    "text",
    [
        "put the two red blocks on different patches, one patch is green and one is blue",
        "There is a green patch and a blue one. Put both red blocks on a patch, but not on the same one.",
    ],
)
def test_each_on_a_mat_but_not_on_the_same(text: str) -> None:
    told = means(text)
    assert all(f"Exactly one of the two red blocks must be on the {c} patch." in told for c in ("green", "blue"))


@pytest.mark.parametrize(
    "text",
    [
        "There are a red mat and a blue mat. Not both white blocks may be on one mat.",
        "There are a red mat and a blue mat, and three blocks. Each of them must be on one mat, none on the other.",
        "Two mats. Put on one mat the red and the blue one, on the other the green cube.",
    ],
)
def test_what_is_no_plain_choice_is_not_made(text: str) -> None:
    assert code_of(text) in ("ambiguous", "misplaced-word", "misplaced", "incomplete")


@pytest.mark.parametrize(
    ("text", "numbers"),
    [
        ("The red mat holds twice as many blocks as the blue mat, six in total.", ("four", "two")),
        ("Seven white cubes: three more on the red patch than on the blue patch.", ("five", "two")),
        ("Let all six cubes lie on the red or the blue patch, so that the red patch holds exactly twice as many cubes "
         "as the blue one.", ("four", "two")),
    ],
)  # fmt: skip
def test_numbers_that_make_up_all_blocks(text: str, numbers: tuple[str, str]) -> None:
    told = means(text)
    assert all(f"Exactly {n} of the" in told for n in numbers)
    assert told.count("xactly") == len(numbers)


def test_a_part_of_them_is_asked_about() -> None:
    assert code_of("There are six cubes. Put twice as many of them on the red mat as on the blue mat.") == "ambiguous"


def test_blocks_are_counted_and_not_the_mats_before_them() -> None:
    told = means("Put the three white blocks on the red or the blue patch. At most two of them may be on the red one.")
    assert told.count("or white block") == len(("one", "two", "three"))
    assert "At most two of the three white blocks must be on the red patch." in told
