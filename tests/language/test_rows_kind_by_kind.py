"""Two or three rows of which it is told what each of them has."""

import pytest

from tests.language.meaning import code_of, means

LETTERS = "There are the letters A, B, C and the digits 1, 2, 3. "
COLORS = "There are three red and three blue cubes. "
THREE = (
    "There are two red blocks, three green blocks and four blue blocks. The two red blocks must be in a row. The three "
    "green blocks must be in a row. The four blue blocks must be in a row. The two red blocks must be in front of the "
    "three green blocks. The three green blocks must be in front of the four blue blocks."
)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (LETTERS + "Arrange them in two rows, letters in front, digits behind.",
         "The blocks 1, 2 and 3 must be behind the blocks A, B and C."),
        (LETTERS + "Put the letters in the back row and the digits in the front row.",
         "The blocks 1, 2 and 3 must be in front of the blocks A, B and C."),
        (COLORS + "Red ones in the front row, blue ones in the back row.",
         "The three blue blocks must be behind the three red blocks."),
        ("Six cubes: three red and three blue. Put the blue ones in the back row and the red ones in front of them.",
         "The three red blocks must be in front of the three blue blocks."),
        ("The digits 1 to 6: odd ones in the front row, even ones in the back row.",
         "The blocks 2, 4 and 6 must be behind the blocks 1, 3 and 5."),
    ],
)  # fmt: skip
def test_each_kind_has_a_row(text: str, said: str) -> None:
    task = means(text).replace("\n", " ")
    assert task.endswith(said)
    assert task.count("must be in a row.") == 2


def test_so_many_in_each_row() -> None:
    said = means("The front row is red and the back row is blue. Four cubes in each row.")
    assert "four red blocks and four blue blocks" in said
    assert code_of("The front row is red, the back row is blue, four blocks.")


@pytest.mark.parametrize(
    "text",
    [
        "Three rows from front to back: two red blocks, three green blocks, four blue blocks.",
        "A red row of two. Behind it a green row of three. Behind that a blue row of four.",
        "A row of four blue blocks, in front of it a row of three green ones, in front of that a row of two red ones.",
    ],
)
def test_three_rows_one_behind_the_other(text: str) -> None:
    assert means(text).replace("\n", " ").startswith(THREE)


def test_one_directly_behind_each() -> None:
    said = means("A row of three red cubes. Put a white cube directly in front of each of them.")
    assert "The other white block must be directly in front of red block 3." in said
    assert code_of("Put a green cube to the left of each of three red cubes.") == "ambiguous"


def test_ends_of_the_last_line_or_the_two_lines() -> None:
    assert code_of("A row of three and a row of four, left red, right white.") == "ambiguous"
