"""What stands between the two ends of a line: several looks in any order, or in the order of the line."""

from __future__ import annotations

import pytest

from tests.language.meaning import means


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("A tower, blue at the bottom, orange on top, green and yellow in between.",
         "must form a tower of exactly four with the blue block at the bottom and the orange block on top."),
        ("Rainbow tower, blue at the bottom, orange on top, green and yellow in between.",
         "must form a tower of exactly four from top to bottom in rainbow order."),
        ("An alphabetical row, A at the left end, D at the right end, B and C in between.",
         "The blocks A to D must be in a row from left to right in alphabetical order."),
        ("A row with red on the left, blue on the right and green, yellow and pink between them.",
         "The five blocks must be in a row with the red block at the left end and the blue block at the right end."),
        ("Gradient tower, blue at the bottom, orange on top, green and yellow in the proper places in between.",
         "must form a tower of exactly four from top to bottom in rainbow order."),
    ],
)  # fmt: skip
def test_all_of_it_is_one_line(text: str, meant: str) -> None:
    assert means(text).replace("\n", " ").endswith(meant)


def test_one_block_is_between_two() -> None:
    assert "between the red block and the blue block" in means("Put green in between red and blue.")


@pytest.mark.parametrize(
    "text",
    [
        "The result is a symmetric row: red at both ends, a blue beside each red, one yellow in the centre. 5 blocks.",
        "A row of five: red at both ends, blue next to them, yellow in the middle.",
        "A row with a red block at each end, a blue one next to each of them and a yellow one in the middle.",
    ],
)
def test_what_is_next_to_both_ends_is_there_twice(text: str) -> None:
    assert means(text).replace("\n", " ").endswith("from left to right in the order red, blue, yellow, blue, red.")


def test_no_more_blocks_than_are_counted() -> None:
    assert "There are two red blocks and two blue blocks." in means(
        "A row of four: red at both ends, a blue next to each."
    )
