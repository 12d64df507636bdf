"""What is told of one block of a row, and of its neighbours and the others."""

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "order"),
    [
        ("In a row of five, the middle one is red and its neighbours are blue. The outer ones are green.",
         "green, blue, red, blue, green"),
        ("Make a row of 7: middle cube purple, its direct neighbours pink, the rest gray.",
         "gray, gray, pink, purple, pink, gray, gray"),
        ("The second block from the left is yellow, the other four in the row are gray.",
         "gray, yellow, gray, gray, gray"),
        ("The leftmost block of the row is blue, the other three are red.", "blue, red, red, red"),
        ("Row: the two ends are white, the other three are red.", "white, red, red, red, white"),
    ],
)  # fmt: skip
def test_the_others_are_so_many(text: str, order: str) -> None:
    assert means(text).replace("\n", " ").endswith(f"must be in a row from left to right in the order {order}.")


@pytest.mark.parametrize(
    "text",
    [
        "In a row of five, the leftmost one is red and its neighbors are blue. The outer ones are green.",
        "The leftmost block of the row is blue and the rightmost is red.",
        "There are three orange blocks in a row, white on the left, the other two are blue.",
    ],
)
def test_what_leaves_the_row_open(text: str) -> None:
    assert code_of(text)


def test_a_neighbour_on_either_side() -> None:
    said = means("The blue cube has a red neighbour on either side.").replace("\n", " ")
    assert "A red block must be next to the blue block. The other red block must be next to the blue block." in said


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Every letter in the row K, L, M must be upside down.",
         "The K block must be upside down. The L block must be upside down. The M block must be upside down."),
        ("In the row A, B, C the letter B must be upside down.", "The B block must be upside down."),
    ],
)  # fmt: skip
def test_said_of_a_row_that_is_named_by_its_blocks(text: str, said: str) -> None:
    told = means(text).replace("\n", " ")
    assert "The three blocks must be in a row from left to right in the order" in told
    assert told.endswith(f". {said}")


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            "Put a red, a green and a blue cube in a row in the order in which they are listed.",
            "row from left to right",
        ),
        (
            "Put the letters B, D, A in a row exactly in the order I say them, rightmost first.",
            "row from right to left",
        ),
        ("Line up red, yellow and blue in the order listed, closest first.", "column on the table from front to back"),
    ],
)
def test_the_order_in_which_they_are_listed(text: str, said: str) -> None:
    assert f"must be in a {said} in the order" in means(text)


def test_lined_up_at_an_edge() -> None:
    assert "must be in a line" in means("Line up 3 cubes at the far edge of the table.")
