"""How many are where: as many on one mat as on the other, one on each, none on its own, the others elsewhere."""

from __future__ import annotations

import pytest

from tests.language.meaning import assert_means, code_of, means

MATS = {"red_patch": 1, "blue_patch": 1}


def test_as_many_on_one_mat_as_on_the_other() -> None:
    assert_means(
        "Please put all four blocks on the two mats, as many on the red mat as on the blue one.",
        {
            "assets": {"plain": 4, **MATS},
            "hold": ["plain plain at=red_patch pitch=1 ; plain plain at=blue_patch pitch=1"],
            "miss": [
                "plain at=red_patch ; plain plain plain at=blue_patch pitch=1",
                "plain at=red_patch ; plain at=blue_patch ; plain ; plain",
            ],
        },
    )


def test_one_block_on_each_of_three_mats() -> None:
    told = means(
        "There is a red mat, a green mat and a blue mat, and there are three blocks. Put one block on each mat."
    )
    assert all(
        f"Exactly one of the red, blue and green blocks must be on the {c} patch" in told for c in ("red", "blue")
    )


def test_none_on_the_mat_of_its_own_color() -> None:
    assert_means(
        "There are two patches on the table, a red and a blue one, and two blocks of the same colours; I would like "
        "every block to end up on a patch, but none of them on the patch that has its own colour.",
        {
            "assets": {"red": 1, "blue": 1, **MATS},
            "hold": ["red at=blue_patch ; blue at=red_patch"],
            "miss": ["red at=red_patch ; blue at=blue_patch", "red at=blue_patch ; blue"],
        },
    )


def test_so_many_there_and_the_others_elsewhere() -> None:
    told = means("Goal: exactly three cubes inside the yellow patch, the remaining two anywhere else on the table.")
    assert "Exactly three of the red, blue, green, yellow and purple blocks must be on the yellow patch" in told
    open_ = means("put exactly two blocks on the red patch and the other blocks somewhere else")
    assert "There are four red blocks" in open_


@pytest.mark.parametrize(
    "text",
    [
        "Put one block on each of the two patches, a red one and a blue one.",
        "Put one block on each of the two mats, a red one and a green one, please.",
    ],
)
def test_what_is_listed_behind_patches_is_asked_about(text: str) -> None:
    assert code_of(text) == "ambiguous"


def test_one_of_several_lies_apart() -> None:
    told = means("one of the five green blocks is lying apart, the other four are bunched together")
    assert told.count("Green block 1 must be apart from") == 4
    assert "must be in one group" in told
