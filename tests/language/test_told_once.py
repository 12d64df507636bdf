"""Colors and nouns told once for all of a list, what is said of some only, and a row told by what ends it."""

from __future__ import annotations

import pytest

from tests.language.meaning import means


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("Put the letters A, B and C in red in a row.", "a red A block, a red B block and a red C block"),
        ("Stack the letters A, B and C in red.", "a red A block, a red B block and a red C block"),
        ("Line up the vowels A, E and I in yellow.", "a yellow A block, a yellow E block and a yellow I block"),
        ("Put the digits 1 and 2 in blue on the mat.", "a blue 1 block and a blue 2 block"),
        ("Put A, B and C in red, blue and green in a row.", "a red A block, a blue B block and a green C block"),
        ("Stack the letters A, B and C in red, blue and green.", "a red A block, a blue B block and a green C block"),
        ("Put the letters A in red, B in blue and C in green in a row.", "a red A block, a blue B block and a green C"),
        ("Put the letter A in red on the mat.", "There is a red A block."),
        ("Two blocks in red and one in blue in a row.", "There are two red blocks and a blue block."),
        ("Put the letters A, B and a red C in a row.", "an A block, a B block and a red C block"),
        ("Put A, B in blue, and C in red in a row.", "an A block, a blue B block and a red C block"),
    ],
)
def test_colors_behind_letters_that_are_listed_are_those_of_all(text: str, told: str) -> None:
    assert told in means(text)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "Spell TIGER with only the vowels in red.",
            "a T block, a red I block, a G block, a red E block and an R block",
        ),
        ("Spell LION with only the consonants in red.", "a red L block, an I block, an O block and a red N block"),
        ("Spell TIGER with the vowels only in red.", "a T block, a red I block, a G block, a red E block"),
        ("Spell LION with only red blocks.", "a red L block, a red I block, a red O block and a red N block"),
    ],
)
def test_only_some_letters_of_a_word_have_a_color(text: str, told: str) -> None:
    assert told in means(text)


@pytest.mark.parametrize(
    "text",
    [
        "A mat for each of the three red blocks.",
        "A mat for each letter: A, B, C.",
        "A mat for each block: red, green, blue.",
    ],
)
def test_a_mat_for_each_is_one_of_its_own(text: str) -> None:
    told = means(text)
    assert "a gray patch, a blue patch and a yellow patch" in told
    assert told.count("Exactly one of") == 3


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("A on a red, B on a blue and C on a green mat.", "a red patch, a blue patch and a green patch"),
        ("Put A on a red and B on a blue mat.", "a red patch and a blue patch"),
        ("Place A onto a red and place B onto a blue zone.", "a red patch and a blue patch"),
        ("Put A on a red and B on a blue block.", "an A block, a red block, a B block and a blue block"),
        ("Put A on a red block and B on a blue mat.", "an A block, a red block and a B block"),
    ],
)
def test_a_noun_at_the_end_is_that_of_all_colors(text: str, told: str) -> None:
    assert told in means(text)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("The red block should be the rightmost of three blocks in a row.", "in a row with the red block at the right"),
        ("A should be the leftmost of the letters A, B, C in a row.", "in a row with the A block at the left end"),
        ("The blue block must be the nearest of four blocks in a column.", "with the blue block at the front end"),
    ],
)
def test_the_utmost_of_a_row_asks_for_the_row(text: str, told: str) -> None:
    assert told in means(text)
    assert "At the start" not in means(text)


def test_the_utmost_of_the_row_that_is_there_is_so_beyond_the_others() -> None:
    told = means("The red block should be the rightmost of the three blocks in the row.")
    assert "At the start, the red, blue and green blocks are in a row." in told
    told = means("A should be the leftmost of the letters A, B, C.")
    assert "in a row" not in told


def test_all_but_one_in_a_color_takes_nothing_out_of_what_is_built() -> None:
    for text in ("Make a row of A to E with all but C in red.", "Make a row of A to E. All but C are red."):
        told = means(text)
        assert "a red A block, a red B block, a C block, a red D block and a red E block" in told
    assert "The blocks 1, 2, 4 and 5 must be in a row." in means("The digits 1 to 5 but 3 in a row.")
    assert "The blocks A, B, D and E must be in a row." in means("A row of A to E with all but C.")
