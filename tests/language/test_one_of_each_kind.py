"""How far each of several is from "a", "some" or "its own" block of another kind: each has one."""

from __future__ import annotations

import pytest

from tests.language.meaning import means

_TWO = " There are two red and two blue blocks."


@pytest.mark.parametrize(
    ("text", "far"),
    [
        ("Each red block must be within 8 cm of a blue block.", "be at most 8 cm from"),
        ("All red blocks must be at least 8 cm from a blue block.", "be at least 8 cm from"),
        ("Every red block is exactly 8 cm from a blue one.", "be 8 cm from"),
        ("Put both red blocks within 8 cm of a blue block.", "be at most 8 cm from"),
        ("Each red block must be within 10 cm of some blue block.", "be at most 10 cm from"),
        ("Each red block must be at least 10 cm away from some blue block.", "be at least 10 cm from"),
        ("Every red block should touch some blue block.", "touch"),
        ("Every red block should touch a blue block.", "touch"),
        ("Each red block must be near some blue block.", "be near"),
    ],
)
def test_each_has_any_of_them(text: str, far: str) -> None:
    told = means(text + _TWO)
    for n in (1, 2):
        assert f"Red block {n} must {far} at least one of the two blue blocks." in told


@pytest.mark.parametrize("own", ["its own", "a different"])
def test_each_has_one_of_its_own(own: str) -> None:
    told = means(f"Put each red block within 6 cm of {own} blue block." + _TWO)
    assert "The other red block must be at most 6 cm from the other blue block." in told


def test_a_side_and_how_far_are_told_of_the_same_one() -> None:
    told = means("Place each red block 6 cm to the right of a blue one." + _TWO)
    assert "right of at least one of the two blue blocks and red block 1 must be 6 cm from the same one" in told


def test_what_is_not_so_is_so_of_none_of_them() -> None:
    told = means("One red block must be within 8 cm of a blue block, the other not." + _TWO)
    for n in (1, 2):
        assert f"Red block 2 must not be at most 8 cm from blue block {n}." in told


def test_one_block_has_one_and_two_that_are_made_up_share_theirs() -> None:
    assert "A red block must be at most 8 cm from a blue block." in means(
        "A red block is within 8 cm of a blue one." + _TWO
    )
    assert "two red blocks and a blue block" in means("Put two red blocks within 8 cm of a blue block.")


@pytest.mark.parametrize(
    "text",
    [
        "Put A and B in the left half, not touching each other or the red block.",
        "Put A and B in the left half, not touching the red block or each other.",
    ],
)
def test_neither_each_other_nor_the_red_one(text: str) -> None:
    told = means(text)
    assert "The A block must not touch the B block." in told
    assert "The A block must not touch the red block. The B block must not touch the red block." in told


def test_so_it_is_of_it_and_where_nothing_is_denied_it_is_one_of_both() -> None:
    told = means("Put A and B near the blue one, but not touching it or each other.")
    assert "The B block must not touch the blue block. The A block must not touch the B block." in told
    assert "Either" in means("Put A and B in the left half, touching each other or the red block.")
