"""What is brought up by one clause and spoken of by the next is the same thing, and what "which" has is had by it."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.meaning import assert_means, code_of, means

_ROW = {"purple": 4, "pink": 1, "green": 1}
_TWO_ROWS = {"blue": 4, "pink": 4}
_BLUE, _PINK = "blue blue blue blue", "pink pink pink pink"


@pytest.mark.parametrize(
    ("text", "assets", "hold", "miss"),
    [
        (
            "The second block from the left in a row of 4 red blocks has a green cube on it and a white one behind it",
            {"red": 4, "green": 1, "white": 1},
            ". white . . | red red^green red red",
            [". . . white | red red^green red red", ". white . . | red^green red red red"],
        ),
        (
            "the top of a tower of three blue blocks has a red block on it and a white block next to it",
            {"blue": 3, "red": 1, "white": 1},
            "blue^blue^blue^red white",
            ["blue^blue^blue^red . . . white", "blue^blue^blue white red"],
        ),
        (
            "place the pink cube left of a row of four purple blocks, which has a green block behind it",
            _ROW,
            "purple purple purple purple at=0,0 ; pink at=0,4 ; green at=2,0",
            ["purple purple purple purple at=0,0 ; pink at=0,4 ; green at=-2,0",
             "purple purple purple purple at=0,0 ; pink at=0,-4 ; green at=2,0"],
        ),
        (
            "Stand the B in front of the red cube, which has the C to its left",
            {"B": 1, "red": 1, "C": 1},
            "C red | . B",
            ["red C | B .", "red | B ; C"],
        ),
        (
            "Put the cube, which has a 5 on it, on the red one",
            {"5": 1, "red": 1},
            "red^5",
            ["5^red", "red 5"],
        ),
        (
            "Put the white block right of a tower of three purple cubes, which has the F on it",
            {"white": 1, "purple": 3, "F": 1},
            "purple^purple^purple^F . white",
            ["purple^purple^purple . white^F", "white . purple^purple^purple^F"],
        ),
        (
            "Two rows of four: the blue one is in front of the pink one",
            _TWO_ROWS,
            f"{_PINK} at=2,0 ; {_BLUE} at=0,0",
            [f"{_PINK} at=-2,0 ; {_BLUE} at=0,0"],
        ),
        (
            "Three towers of two: the blue one is left of the pink one, and the pink one is left of the white one",
            {"blue": 2, "pink": 2, "white": 2},
            "blue^blue . pink^pink . white^white",
            ["pink^pink . blue^blue . white^white", "blue^pink . blue^pink . white^white"],
        ),
        (
            "I want the word KED right of a stack of three red cubes and the letter C behind the red stack",
            {"K": 1, "E": 1, "D": 1, "red": 3, "C": 1},
            "red^red^red at=0,0 ; K E D at=0,-4 ; C at=2,0",
            ["red^red^red^C at=0,0 ; K E D at=0,-4", "red^red^red at=0,0 ; K E D at=0,-4 ; C at=-2,0"],
        ),
        (
            "Line up 2, 4, 6 and 9: the even ones in rising order from the left, then the odd one at the right end.",
            {"2": 1, "4": 1, "6": 1, "9": 1},
            "2 4 6 9",
            ["9 2 4 6", "6 4 2 9", "2 6 4 9"],
        ),
        (
            "Seven brown blocks in a U, with its open side pointing away from me, towards the far edge.",
            {"brown": 7},
            "brown . brown | brown . brown | brown brown brown",
            ["brown brown brown | brown . brown | brown . brown"],
        ),
    ],
)  # fmt: skip
def test_it_is_the_same_thing(text: str, assets: dict[str, int], hold: str, miss: list[str]) -> None:
    assert_means(text, {"assets": assets, "hold": [hold], "miss": miss})


@pytest.mark.parametrize(
    ("text", "code"),
    [
        # which of the two rows?
        ("put a row of three blue blocks behind a row of three red cubes and the X right of the row", "ambiguous"),
        ("Build two towers of two blocks each. Put the red one on the mat.", "ambiguous"),
        # a line of which a part is told by itself, and the rest "then": next in the line, or later?
        ("Line up A, C, E, B: the vowels in alphabetical order from the left, then the consonants in this order",
         "misplaced-word"),
    ],
)  # fmt: skip
def test_what_could_be_another_is_asked(text: str, code: Any) -> None:
    assert code_of(text) == code


def test_each_has_one_of_its_own() -> None:
    told = {"assets": {"brown": 3, "orange": 3}, "hold": ["orange brown ; orange brown ; orange brown"]}
    assert_means("each of the three brown cubes has an orange one to its left", told | {"miss": ["brown*  ; orange*"]})


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("A is left of B and C, and D is left of A.",
         "The A block must be to the left of the blocks B and C. The D block must be to the left of the A block."),
        ("Red should be left of blue, green and white, and yellow left of red.",
         "The red block must be to the left of the blue, green and white blocks. The yellow block must be to the left "
         "of the red block."),
        ("Put A next to B and C, and D in front of all three.",
         "The A block must be next to the B block. The A block must be next to the C block. The D block must be in "
         "front of the blocks A, B and C."),
        ("Build a tower of two reds and a tower of two blues and put a white block next to both towers.",
         "The white block must be next to the tower of the two red blocks. The white block must be next to the tower "
         "of the two blue blocks."),
        ("The green block starts on the red patch. Move it to the blue patch and in its place put the yellow one.",
         "The yellow block must be on the red patch."),
        ("The red and blue blocks go on the white and yellow patches in that order.",
         "The red block must be on the white patch. The blue block must be on the yellow patch."),
        ("lay out a 3x3 grid; the front row is orange, the one behind it green and the back row purple",
         "the three purple blocks, then the three green blocks, then the three orange blocks"),
        ("Two towers, three blocks each. The red one must not touch the blue one.",
         "The three blue blocks must form a tower of exactly three. The three red blocks must not touch the tower of "
         "the three blue blocks."),
        ("Two towers of three blocks. The red one must be left of the blue one.",
         "The tower of the three red blocks must be to the left of the tower of the three blue blocks."),
        ("a row of six blocks alternating between pink and yellow",
         "The three pink blocks and the three yellow blocks must be in a row with alternating colors."),
        ("Put the red block on the green one and keep the three blue blocks from touching it",
         "Blue block 1 must not touch the red block."),
    ],
)  # fmt: skip
def test_a_list_ends_at_its_comma_and_places_are_whose_they_are(text: str, told: str) -> None:
    assert told in means(text)


@pytest.mark.parametrize(
    "text",
    [
        "Make a row of four white blocks and one black block so that the black one is between two white ones.",
        "Make a row of 4 white blocks and 1 black block so that the black one is between two white ones.",
        "Put three green blocks on the patch and a white one between two green ones.",
        "Two towers of two, red and green, in that order from left to right.",
        "Build two towers, one of two and one of three blocks, the first red, the second blue.",
        "Each of the two green blocks sits on a red one, and each of those on a blue one.",
        "Make a row of red, blue and green, with white, black and gray in front of it in that order.",
        "The green block starts on the red patch. Move it to the blue patch; in its old place goes the yellow one",
    ],
)
def test_what_may_be_told_of_either_is_asked(text: str) -> None:
    assert code_of(text) in ("ambiguous", "misplaced", "count-mismatch")
