"""Several blocks told by where they are in a line of the start: "the two on the left", "the two at the ends"."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, start_and_end

_ROW = "There is a row of red, green, blue and white from left to right. "
_TOWER = "There is a tower of red, green, blue and white from bottom to top. "


@pytest.mark.parametrize(
    ("text", "end"),
    [
        (f"{_ROW}Put the two on the left on the patch.", "The red and green blocks must be on the gray patch."),
        (f"{_ROW}The three on the right go on the patch, the red one stays.",
         "The white, blue and green blocks must be on the gray patch. The red block must stay where it is."),
        (f"{_ROW}Put the two at the ends on the patch.", "The red and white blocks must be on the gray patch."),
        (f"{_ROW}The outer two must go on the patch.", "The red and white blocks must be on the gray patch."),
        (f"{_ROW}Put the two in the middle on the patch.", "The green and blue blocks must be on the gray patch."),
        (f"{_TOWER}Put the two on top on the patch.", "The white and blue blocks must be on the gray patch."),
        (f"{_TOWER}Put the one at the very bottom on the patch.", "The red block must be on the gray patch."),
        ("There is a tower of four red blocks. The top two go on the patch.",
         "Red block 3 and red block 4 must be on the gray patch. Red block 1 and red block 2 must form a tower of "
         "exactly two."),
        ("There are two red blocks. Put the two on the left.",
         "The two red blocks must be in the left half of the table."),
    ],
)  # fmt: skip
def test_which_they_are(text: str, end: str) -> None:
    assert start_and_end(text)[1] == end


@pytest.mark.parametrize(
    "text",
    [
        "There is a row of four red blocks. Put the two on the left on the patch.",
        "There are a red, a green and a blue block. Put the two on the left on the patch.",
        "There is a row of four red blocks. The two on the left go on the patch, the others stay.",
    ],
)
def test_those_that_nothing_tells_apart(text: str) -> None:
    assert code_of(text) == "ambiguous"
