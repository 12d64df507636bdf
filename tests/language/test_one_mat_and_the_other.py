"""Two patches of which no look is told: what is on the one and on the other holds either way round."""

from __future__ import annotations

import pytest

from tests.language.meaning import assert_means, code_of, means

MATS = {"gray_patch": 1, "blue_patch": 1}


@pytest.mark.parametrize(
    "text",
    [
        "One patch has two red blocks, the other one blue block.",
        "Two red blocks on the one mat, and a blue block on the other.",
        "One mat holds the blue block, the other must hold both red blocks.",
    ],
)
def test_either_way_round(text: str) -> None:
    assert_means(
        text,
        {
            "assets": {"red": 2, "blue": 1, **MATS},
            "hold": ["red red pitch=1.1 at=gray_patch ; blue at=blue_patch",
                     "red red pitch=1.1 at=blue_patch ; blue at=gray_patch"],
            "miss": ["red blue pitch=1.1 at=gray_patch ; red at=blue_patch", "red red pitch=1.1 at=gray_patch ; blue"],
        },
    )  # fmt: skip


@pytest.mark.parametrize(
    "text", ["One patch stays empty, A and B are on the other.", "Leave one mat empty and put A and B on the other."]
)
def test_one_is_empty(text: str) -> None:
    told = means(text)
    assert "Either the gray patch must be empty and the blocks A and B must be on the blue patch, or the blue" in told


def test_mats_on_different_sides_are_told_apart() -> None:
    told = means("The left patch is empty; the other holds the red block.")
    assert "The gray patch must be empty. The red block must be on the blue patch." in told


def test_what_is_told_of_look_alikes_is_told_once() -> None:
    told = means("Put two red blocks on one patch and two on the other.")
    assert "Two red blocks must be on the gray patch. The other two red blocks must be on the blue patch." in told


def test_the_other_may_be_a_block() -> None:
    assert "A red block must be on the other red block." in means(
        "Two red blocks are on the table. One patch is empty, one red block is on the other."
    )
    assert code_of("One red block is on the left mat, the other has a blue block on it.") == "no-referent"
