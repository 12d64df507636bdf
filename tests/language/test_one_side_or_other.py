"""A block on one side of another or on the other: how close is meant of both, and "next to it" in any case."""

from __future__ import annotations

import pytest

from tests.language.meaning import means

_TWO = "There are a purple block and a cyan block. "


@pytest.mark.parametrize(
    "side",
    ["either directly left or directly right of", "directly left or right of", "directly to the left or right of"],
)
def test_directly_is_meant_of_both_sides(side: str) -> None:
    assert means(f"The purple block must be {side} the cyan block.") == (
        f"{_TWO}The purple block must be directly to the left of the cyan block or the purple block must be directly "
        "to the right of the cyan block."
    )


def test_what_is_not_so_may_be_meant_more_closely() -> None:
    told = means("The purple block must be left of the cyan block but not directly behind it.")
    assert told.endswith("must be to the left of the cyan block. The purple block must not be directly behind the cyan "
                         "block.")  # fmt: skip


def test_next_to_it_on_one_side_or_the_other() -> None:
    either = "The purple block must be to the left of the cyan block or the purple block must be to the right of it."
    told = means("The purple block is right next to the cyan block, on its left or on its right.")
    assert told == _TWO + "The purple block must be adjacent to the cyan block. " + either.replace(
        "of it.", "of the cyan block."
    )
    told = means("The purple block is on the cyan block, on the green block or on the white block.")
    assert told.count("or the purple block") == 2
