"""An order that matters is that of the list; which way a line goes may be told in a sentence behind it."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "same"),
    [
        ("stack A, B and C, order matters", "stack A, B and C in that order"),
        ("A, B and C in a row. The order is important.", "A, B and C in a row, in that order"),
        ("Order matters: red, blue and green in a row.", "Red, blue and green in a row, in that order"),
        ("red on the red mat, blue on the blue mat, order matters",
         "First red on the red mat, then blue on the blue mat"),
        ("Put 3, 1 and 2 in ascending order. The order matters.", "Put 3, 1 and 2 in ascending order"),
        ("Make a row: red, yellow, blue. Lay it out from right to left.",
         "A row from right to left: red, yellow, blue"),
        ("Make a tower: red, yellow, blue. Build it from top to bottom.",
         "Tower from top to bottom: red, yellow, blue"),
        ("We make a pattern: red, blue, red. Can you lay it out from left to right?", "A row: red, blue, red"),
        ("stack blocks a b and c", "stack blocks A, B and C"),
        ("a tower with red at the bottom, then blue, white and green on top",
         "a tower from bottom to top: red, blue, white, green"),
    ],
)  # fmt: skip
def test_the_order_is_that_of_the_list(text: str, same: str) -> None:
    assert _told(text) == _told(same)


def _told(text: str) -> str:
    """What it means, whether other blocks may stand on the tower or not."""
    return means(text).replace("must form a tower of exactly four", "must be stacked").replace(
        "The red, blue, white and green blocks", "The four blocks"
    )  # fmt: skip


def test_an_order_of_blocks_that_are_not_named_is_none() -> None:
    assert code_of("Put three blocks in a row, order matters") == "no-referent"
    assert code_of("A tower of three blocks. The order matters.") == "no-referent"


@pytest.mark.parametrize(
    "text",
    [
        "First put A, B and C in a row. Then put them from back to front.",
        "At the start A, B and C are in a row. Put them from front to back.",
    ],
)
def test_a_way_that_comes_later_changes_no_line_before_it(text: str) -> None:
    told = means(text)
    assert "must be in a row" in told or "At the start, the blocks A, B and C are in a row" in told
    assert "column on the table" in told


def test_an_article_is_no_letter_in_front_of_the_next_block() -> None:
    assert means("put a b and a c in a row") == means("put B and C in a row")
