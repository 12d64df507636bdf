"""What mats may hold, blocks that are all on some mat, parts of the table that are cleared, kinds told with "if"."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, start_and_end

_EITHER = "The {0} block must be on the gray patch or the {0} block must be on the blue patch."
_SORTED = "The two red blocks must be on the gray patch. The two blue blocks must be on the blue patch."


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("There are two mats and two blocks. Every block must be on a mat.",
         f"{_EITHER.format('red')} {_EITHER.format('blue')}"),
        ("No mat may hold more than two blocks. There are two mats and three blocks.",
         "At most two of the red, blue and green blocks must be on the gray patch. At most two of the red, blue and "
         "green blocks must be on the blue patch."),
        ("The patch must not be empty, and it must not hold more than two of the three cubes.",
         "The gray patch must not be empty. At most two of the red, blue and green blocks must be on the gray patch."),
        ("If a cube is red, it goes on the left mat; if it's blue, it goes on the right mat. Two of each.", _SORTED),
        ("If a block is red, put it on the left mat, and if it is blue, put it on the right mat. There are two red and "
         "two blue blocks.", _SORTED),
        ("Clear the table's middle.",
         "The red block must not be in the middle of the table. The blue block must not be in the middle of the "
         "table."),
        ("The near half of the table should be free of blocks. There is a red block.",
         "The red block must not be in the near half of the table."),
        ("Two mats and four blocks. Put at least two of the blocks on each mat.",
         "At least two of the red, blue, green and yellow blocks must be on the gray patch. At least two of the red, "
         "blue, green and yellow blocks must be on the blue patch."),
    ],
)  # fmt: skip
def test_what_must_be(text: str, end: str) -> None:
    assert start_and_end(text)[1] == end


def test_a_condition_of_one_block_is_none_of_a_kind() -> None:
    assert code_of("If the red block is on the mat, it must be on the left mat.") == "conditional"
