"""So many on each, each of those that are known, so many of several colours together."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "there"),
    [
        ("Put the red blocks on the two patches, two on each.", "There are four red blocks."),
        ("Put the red blocks on the three patches, two on each.", "There are six red blocks."),
        ("Put two of the red blocks on each of the two patches.", "There are four red blocks."),
        ("Put two red blocks on each of the two patches.", "There are four red blocks."),
        ("There are four red blocks and two patches. Put the red blocks on the patches, two on each.", "four red"),
    ],
)
def test_so_many_on_each_patch_takes_as_many_blocks(text: str, there: str) -> None:
    assert there in means(text)


def test_of_how_many_patches_is_asked() -> None:
    assert code_of("Put the red blocks on the patches, two on each.") == "ambiguous"


@pytest.mark.parametrize("last", ["two on each", "two each", "two of them on each", "three on each"])
def test_a_block_carries_one_other(last: str) -> None:
    assert code_of(f"Put the red blocks on the blue ones, {last}.") == "ambiguous"


def test_one_on_each_is_one_on_each() -> None:
    for text in ("Put the red blocks on the blue ones, one on each.",
                 "Put the two red blocks on the two blue ones, one on each."):  # fmt: skip
        told = means(text)
        assert "A red block must be on a blue block. The other red block must be on the other blue block." in told


@pytest.mark.parametrize("each", ["each red one", "every red one", "each of the red ones"])
def test_each_one_is_a_patch_where_only_patches_look_so(each: str) -> None:
    told = means(f"There are two red patches and a blue one. Put a yellow block on {each}.")
    assert "There are two yellow blocks. There are a red patch, a red patch and a blue patch." in told
    assert "red block" not in told


def test_each_one_is_a_block_where_blocks_look_so() -> None:
    told = means("There are two red blocks and a blue patch. Put a yellow block on each red one.")
    assert "A yellow block must be on a red block." in told


def test_a_tower_on_each_of_several_blocks_is_asked() -> None:
    for text in ("Put a tower of two red blocks on each blue block.",
                 "There are two blue blocks. Stack two red blocks on each of them."):  # fmt: skip
        assert code_of(text) == "ambiguous"
    told = means("Build two towers, each with a blue block at the bottom and two red ones on top.")
    assert "in the order blue, red, red." in told
