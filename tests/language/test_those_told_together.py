"""What stands for things that were told together: "those three cubes", "each of the two", "that row", words that stand
side by side."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

_ON_MAT = "The red, green and blue blocks must be on the gray patch."
_WHITE = (
    "A white block must be on the red block. Another white block must be on the green block. The other white block "
    "must be on the blue block."
)
_CAT, _DOG = "The blocks C, A and T must spell the word CAT.", "The blocks D, O and G must spell the word DOG."
_TOWERS = (
    "The blue and red blocks must form a tower of exactly two from bottom to top in the order blue, red. The yellow "
    "and green blocks must form a tower of exactly two from bottom to top in the order yellow, green."
)


@pytest.mark.parametrize(
    ("text", "end"),
    [
        ("The red, green and blue cube go on the mat and each of those three cubes gets a white cube on top.",
         f"{_ON_MAT} {_WHITE}"),
        ("The red, green and blue cubes are on the mat and each of the three has a white cube on top.",
         f"{_ON_MAT} {_WHITE}"),
        ("There are two mats. A is on one of them. Each of the two has a white block on it.",
         "The A block must be on the gray patch or the A block must be on the blue patch. A white block must be on the "
         "gray patch. The other white block must be on the blue patch."),
        ("The word OK stands in a row and the red block is behind that row.",
         "The blocks O and K must spell the word OK. The red block must be behind the blocks O and K."),
        ("The word CAT and the word DOG are side by side.",
         f"{_CAT} {_DOG} The blocks C, A and T must be next to the blocks D, O and G."),
        ("Write the words CAT and DOG 10 cm apart.",
         f"{_CAT} {_DOG} The blocks C, A and T must be 10 cm from the blocks D, O and G."),
        ("Two towers, red on blue and green on yellow, and the one with the red block stands to the left of the other "
         "one.", f"{_TOWERS} The blue block must be to the left of the yellow block."),
    ],
)  # fmt: skip
def test_they_are_those(text: str, end: str) -> None:
    assert means(text).endswith(end)


@pytest.mark.parametrize(
    "text",
    [
        "The letters P and Q lie on the pink mat. The first one is nearest to me.",
        "Put a red block on the green mat and a blue block on the pink mat. The first one is nearest to me.",
        "A row of the letters P, Q and R is on the left and the number 61 on the right.",
        "Spell CAT and DOG. The red block is to the left of the row.",
        "The word CAT and the word DOG touch each other.",  # as words, or each of its letters the next one
    ],
)
def test_it_is_asked_which(text: str) -> None:
    assert code_of(text)


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("One tower for each colour, please; I count three red, two blue and two black blocks.",
         "There are three red, two blue and two black blocks. Build one tower for each colour."),
        ("I need everything on the yellow patch - that's the red, the blue and the green cube.",
         "The red, the blue and the green cube must be on the yellow patch."),
        ("The cubes A, B and C are all behind both digit cubes, the 1 and the 2.",
         "The cubes A, B and C are behind 1 and 2."),
        ("Line up the four teal blocks, about 8 cm from the centre of one to the centre of the next.",
         "Line up the four teal blocks with 8 cm between their centres."),
        ("The table has four corners, put a red block in each of them.",
         "Put a red block in each corner of the table."),
        ("Order the letters Q, D and M alphabetically in a column, the first one farthest from me.",
         "The letters Q, D and M are in a column in alphabetical order, farthest first."),
        ("E should be somewhere to the left of F, I don't care which one is nearer to me.",
         "E should be somewhere to the left of F."),
        ("Either A is on B or C is on D; if both are true that's fine too.", "Either A is on B or C is on D."),
        ("The K should lie with its letter turned a quarter turn clockwise when seen from above.",
         "The K must be turned by 90 degrees clockwise."),
    ],
)  # fmt: skip
def test_it_means_the_same(text: str, plain: str) -> None:
    assert means(text) == means(plain)
