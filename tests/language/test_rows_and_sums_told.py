"""Rows, grids, spelled words and equations in ordinary sentences: what they must mean, and near ones that differ."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


def test_a_mirrored_row_with_one_in_the_middle() -> None:
    text = means("Row of five. Mirror symmetric. White in centre, two red, two blue.")
    assert text.endswith("must be in a row with mirrored colors.")
    assert "two red blocks, two blue blocks and a white block" in text
    assert code_of("Row of four. Mirror symmetric. White in centre, two red, two blue.") == "ambiguous"


@pytest.mark.parametrize(
    ("text", "way"),
    [
        ("A rainbow row, please! Seven blocks in seven colours, red first on the left.", "left to right"),
        ("A rainbow row, please! Seven blocks in seven colours, red at the right end.", "right to left"),
        ("Put a rainbow in a row, one block for each colour from red to purple, red on the left.", "left to right"),
    ],
)
def test_rainbows_of_so_many_colors(text: str, way: str) -> None:
    end = f"The red, orange, yellow, green, cyan, blue and purple blocks must be in a row from {way} in rainbow order."
    assert means(text).endswith(end)


def test_rainbows_that_are_not_clear() -> None:
    assert code_of("A rainbow row, please! Seven blocks in six colours, red first on the left.") == "misplaced-word"
    assert code_of("A rainbow row, two blocks for each colour from red to purple.") == "misplaced-word"


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("Three cubes in a line, between one and the next there is a gap of 2 cm.", "in a line with gaps of 2 cm."),
        ("Three cubes in a line, between one and the next there is no gap.", "in a line without gaps."),
        (
            "column, digits 9 down to 5, 9 at far end",
            "in a column on the table from back to front in descending numerical order.",
        ),
        (
            "Put the numbers 1 to 3 in order in a row, with a red brick after the last one.",
            "from left to right in the order the 1 block, the 2 block, the 3 block, the red block.",
        ),
        ("abcde in a row, left to right", "in a row from left to right in the order A, B, C, D, E."),
        ("line up the letters as PAPER", "must spell the word PAPER."),
        (
            "the letters start in a pile and the robot has to line them up as P A P E R",
            "in a row from left to right in the order P, A, P, E, R.",
        ),
    ],
)
def test_rows_in_order(text: str, end: str) -> None:
    assert means(text).endswith(end)


def test_orders_that_contradict() -> None:
    assert code_of("column, digits 9 down to 5, 7 at the far end") == "order-conflict"
    assert code_of("Line up the blocks as RGB.") == "incomplete"
    assert code_of("numbers 1 to 5 in a row, with a green cube after the last one") == "no-referent"


@pytest.mark.parametrize(
    "text",
    [
        "spell CAT in the back and DOG in front of it",
        "Two rows of letters: the first row reads CAT and the row below it reads DOG.",
        "The front row reads DOG and the row behind it reads CAT.",
    ],
)
def test_words_told_row_by_row(text: str) -> None:
    assert means(text).endswith("The blocks D, O and G must be in front of the blocks C, A and T.")


def test_two_rows_told_one_by_one() -> None:
    text = means("Two rows of four: the letters W, X, Y, Z in that order from left to right, and a row of plain cubes "
                 "in front of them.")  # fmt: skip
    assert "The blocks W to Z must be in a row from left to right in the order W, X, Y, Z." in text
    assert text.endswith("The red, blue, green and yellow blocks must be in front of the blocks W to Z.")
    told = "Two rows of three: a row of letters A, B and C, and a row of digits 1 and 2 in front of it."
    assert code_of(told) == "ambiguous"


def test_a_row_beside_a_row() -> None:
    text = means("Row of letters: B, E, A, R. Below it a second row: C, O, T, S.")
    assert "from left to right in the order C, O, T, S." in text
    assert text.endswith("The blocks C, O, T and S must be in front of the blocks B, E, A and R.")


def test_plain_blocks_are_none_of_the_letters() -> None:
    text = means("There are two digit cubes 1 and 2 and two plain cubes on the table. Move the plain ones to the left "
                 "half and leave the digits where they are.")  # fmt: skip
    assert text.startswith("There are a 1 block, a 2 block, a red block and a blue block.")
    assert text.endswith("The blocks 1 and 2 must stay where they are.")


def test_what_cubes_show_and_what_is_tidied() -> None:
    text = means("All cubes with number are in the left half of the table and the cubes with letter in the right half.")
    assert "The blocks 1, 2 and 3 must be in the left half of the table." in text
    text = means("Could you tidy up the letters A, B and E for us? The vowels go in the left half of the table.")
    assert text.endswith("The blocks A and E must be in the left half of the table.")


def test_one_color_per_line() -> None:
    text = means("grid 2 rows x 4 cols, one color per column, all columns different")
    assert text.endswith("must form a grid of two rows and four columns where each column has a different color.")
    assert code_of("a 2x4 grid, one color per column, all rows different") == "incomplete"
    text = means("2 rows x 3 columns, checkerboard of red and black, the far left cell is red")
    assert text.endswith("row by row in the order red, black, red, black, red, black.")


def test_what_is_laid_out_like_something_is_no_talk() -> None:
    text = means("the numbers 1 to 9 in a 3x3 grid like on a phone keypad")
    assert text.endswith("row by row in ascending numerical order.")
    assert code_of("the numbers 1 to 9 in a 3x3 grid like on a calculator") == "misplaced-word"


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("What is 3 plus 4? Let the robot lay out the whole equation with the right answer.", "the equation 3+4=7."),
        ("What is two plus three? Show it with the number blocks: 2 + 3 = 5.", "the equation 2+3=5."),
        ("Build an equation from two numbers, a minus and an equals sign with the result 4.", "the equation 5-1=4."),
        (
            "make a sum with two digits, a plus, an equals sign and an 8 as the result. which numbers is up to you",
            "The blocks 3, +, 5, = and 8 must form a true equation.",
        ),
        (
            "Digit cubes available: 3, 4, 6 and 9. The sum of the two digits on the green mat must be 10.",
            "The blocks 4 and 6 must be on the green patch.",
        ),
    ],
)
def test_sums(text: str, end: str) -> None:
    assert means(text).endswith(end)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("What is two plus three? Show it: 2 + 3 = 6.", "false-equation"),
        ("How much is 8 minus 5? Lay out the whole sum with the plus sign and the answer.", "misplaced-word"),
        ("What is 3 plus 4? Lay out the whole equation with the answer on the left.", "incomplete"),
        ("Make a multiplication with the result 7.", "bad-equation"),
    ],
)
def test_sums_that_are_none(text: str, code: str) -> None:
    assert code_of(text) == code


def test_the_word_of_which_letters_are_told() -> None:
    text = means("Take the letters of the word GARDEN, write the word in a row that runs from left to right, and then, "
                 "once the word is complete, put the plain green block right behind the letter D.")  # fmt: skip
    assert text.endswith(
        "First, the blocks G, A, R, D, E and N must spell the word GARDEN. "
        "Then, the green block must be immediately behind the D block."
    )
    assert "spell the word LISA" in means("Put the letters of my name, LISA, in a row so that you can read it.")


def test_digits_of_which_the_sum_is_told_in_one_sentence() -> None:
    stock = "There are the digits 1, 2, 3 and 4. "
    told = means(f"{stock}Put two of them on the mat so that their sum is 5.")
    assert means("Put two of the digits 1, 2, 3 and 4 on the mat so that their sum is 5.") == told
    assert means("Put exactly two of the cubes 1, 2, 3 and 4 on the mat. Their sum is 5.") == told


@pytest.mark.parametrize(
    "text",
    [
        "The letters A and B are on the mat and their sum is 5.",
        "Put two of the digits 1 to 4 on the mat so that their sum is 9.",
    ],
)
def test_a_sum_of_unknown_numbers_is_no_label(text: str) -> None:
    assert code_of(text) == "incomplete"


def test_who_is_named_ahead_of_a_pronoun_is_meant_by_it() -> None:
    text = "Put the red cube to the left of the blue one, and the green cube, it must be on the blue one."
    assert means(text) == means(
        "Put the red cube to the left of the blue one, and the green cube must be on the blue one."
    )
