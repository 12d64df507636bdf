"""What moves, comes off or leaves, said as if it went by itself, and what stays; the start that is told of it."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means, start_and_end

_TOWER = "At the start, the three blocks are stacked from bottom to top in the order red, green, blue"
_ROW = "At the start, the three blocks are in a row from left to right in the order red, green, blue"


@pytest.mark.parametrize(
    ("text", "start", "end"),
    [
        ("A tower of red, green and blue, from bottom to top, stands on the table. The top block goes on the patch.",
         _TOWER, "The blue block must be on the gray patch."),
        ("Red, green and blue are in a row from left to right. The two outer ones go on the mat, the middle one stays.",
         _ROW, "The red and blue blocks must be on the gray patch. The green block must stay where it is."),
        ("Red, green and blue stand in a row from left to right. The red one moves to the patch.",
         _ROW, "The red block must be on the gray patch."),
        ("Two reds and a yellow are on the mat. The yellow one leaves, the reds stay.",
         "At the start, the two red blocks and the yellow block are on the gray patch",
         "The yellow block must not be on the gray patch. The two red blocks must stay where they are."),
        ("White is on top of black. The top one comes down and the bottom one stays.",
         "At the start, the white block is on the black block",
         "The white block must not be somewhere above the black block. The black block must stay where it is."),
        ("Three red blocks are on the white patch. Take off all but one.",
         "At the start, the three red blocks are on the white patch",
         "Exactly two of the three red blocks must not be on the white patch."),
        ("There is a tower of red, green and blue from bottom to top. Take away the middle one.", _TOWER,
         "The green block must not be somewhere above the red block. The red and blue blocks must form a tower of "
         "exactly two from bottom to top in the order red, blue."),
        ("There is a row of red, green and blue from left to right. Take away the green one.", _ROW,
         "The green block must be apart from the red block. The green block must be apart from the blue block. "
         "The red and blue blocks must stay where they are."),
    ],
)  # fmt: skip
def test_what_is_told_first_is_the_start(text: str, start: str, end: str) -> None:
    assert start_and_end(text) == (start, end)


@pytest.mark.parametrize(
    "text",
    [
        "Red, green and blue stand in a row from left to right. Red goes on the left.",
        "Red, green and blue stand in a row from left to right. Yellow goes on the patch.",
    ],
)
def test_what_tells_more_of_the_end_keeps_it_there(text: str) -> None:
    assert "At the start" not in means(text)


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("There are a red, a green and a blue block. Only the red one may be moved. It has to be left of the blue one.",
         "The green and blue blocks must stay where they are. The red block must be to the left of the blue block."),
        ("Only the white block may be moved. Put it to the left of the black one.",
         "The white block must be to the left of the black block. The black block must stay where it is."),
        ("There are red, green and blue. Only red moves, it goes on blue.",
         "The green and blue blocks must stay where they are. The red block must be moved by at least 5 cm. "
         "The red block must be on the blue block."),
        ("There are a red and a blue block. Red moves, blue stays.",
         "The red block must be moved by at least 5 cm. The blue block must stay where it is."),
    ],
)  # fmt: skip
def test_what_alone_is_moved(text: str, end: str) -> None:
    assert start_and_end(text)[1] == end


@pytest.mark.parametrize(
    "text",
    ["There are a red and a blue block. Red may move.", "The red block leaves.", "Take the red block away."],
)
def test_what_says_too_little(text: str) -> None:
    assert code_of(text) in ("incomplete", "no-referent")
