"""What is left out of "all but the O in blue", and letters and digits "in red", which are no inches."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    "text",
    [
        "Spell DOG with all letters but the O in blue.",
        "Spell DOG with every letter except the O in blue.",
        "Write DOG, each letter but O blue.",
        "Spell DOG with all letters apart from the O in blue.",
        "Spell DOG with all blocks other than the O in blue.",
        "Spell DOG with all letters in blue except the O.",
        "Spell DOG with all letters but the vowels in blue.",
    ],
)
def test_the_letters_that_are_left_out_are_of_no_color(text: str) -> None:
    assert "There are a blue D block, an O block and a blue G block." in means(text)


def test_several_letters_and_a_place_behind_the_color() -> None:
    assert 'a red E block, two blocks labelled "L"' in means("Spell HELLO with all letters but the Ls in red.")
    told = means("Spell CAT with all letters but the C and the A in red on the mat.")
    assert "There are a C block, an A block and a red T block." in told
    assert "must be on the gray patch" in told


@pytest.mark.parametrize(
    "text",
    [
        "A tower of five blocks with all but the top one in red.",
        "A row of five blocks with all except the middle one in red.",
        "A wall of six blocks with all but the top left one in green.",
        "Make a pyramid of six with all but the top one in red.",
        "Spell DOG with all but the second letter in blue.",
    ],
)
def test_how_a_part_looks_that_is_left_out_is_asked(text: str) -> None:
    assert code_of(text) == "ambiguous"


def test_a_part_of_a_color_and_the_others_of_another() -> None:
    assert "red, red, red, red, blue" in means("A tower of five blocks with the top one in blue and the others red.")


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("Put the digit 2 in red on the mat.", "There is a red 2 block."),
        ("Put the letter A in red on the mat.", "There is a red A block."),
        ("Put the number 3 in green in the corner.", "There is a green 3 block."),
        ("A row of the digits 1, 2 and 3 in red.", "There are a red 1 block, a red 2 block and a red 3 block."),
        ("Put the letters A and B in red next to C.", "There are a red A block, a red B block and a C block."),
        ("Put the blocks A and B in red on the mat.", "There are a red A block and a red B block."),
        ("Stack a 1 in red on a 2 in blue.", "The red 1 block must be on the blue 2 block."),
    ],
)
def test_symbols_in_a_color(text: str, found: str) -> None:
    assert found in means(text)


def test_inches_in_front_of_a_block() -> None:
    assert "a 5.08 cm red block" in means("Put a 2 in red block on the mat.")
    assert "a 5.08 cm red block and a 5.08 cm blue block" in means("A row of 2 in red and blue cubes.")


def test_several_symbols_in_several_colors() -> None:
    assert code_of("Put the digits 4 and 5 in blue and yellow on the mat.") == "misplaced"
