"""Members of a number of blocks and those that are left, told in short."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "goals"),
    [
        ("Of the five red blocks, three make a row and the other two a tower.",
         "Three red blocks must be in a row. The other two red blocks must be stacked."),
        ("Half of the six blue blocks make a tower, the rest a row.",
         "Three blue blocks must form a tower of exactly three. The other three blue blocks must be in a row."),
        ("Two blocks of the three form a tower, the last one stands left of it.",
         "Red block 3 must be to the left of the tower of red block 1 and red block 2."),
        ("Two of the green blocks are on the patch, the third is off it.",
         "There are three green blocks. There is a gray patch. Green block 1 and green block 2 must be on"),
        ("Two red blocks touch, the third one is far from both.",
         "Red block 3 must be apart from red block 1 and red block 2."),
        ("Two of the blocks in the row of three are red; the third is blue.",
         "The two red blocks and the blue block must be in a row."),
    ],
)  # fmt: skip
def test_members(text: str, goals: str) -> None:
    assert goals in means(text).replace("\n", " ")


def test_ranks_are_no_remainder() -> None:
    assert code_of("Two red blocks are on the first patch, the third block is on the table.") == "no-referent"


def test_one_of_those_that_are_there() -> None:
    told = means("Two red blocks and a blue one: one red is on the blue one and the other red is beside it.")
    assert "There are two red blocks and a blue block." in told
    assert "A red block must be on the blue block. The other red block must be next to the blue block." in told
