"""What people say who think in another language, where the meaning is plain."""

from __future__ import annotations

import pytest

from tests.language.meaning import means


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        (
            "In the table there are a yellow tower of two cubes and a white tower of two cubes; build with them only "
            "one tower of four with the colours alternated.",
            "There are a yellow tower of two cubes and a white tower of two cubes. Build one tower of four with "
            "alternating colours from them.",
        ),
        ("Put the red cube in top of the blue cube.", "Put the red cube on top of the blue cube."),
        ("Put all of blocks on the mat. There is 2 red and 2 white.", "There are 2 red and 2 white blocks. Put all "
         "the blocks on the mat."),
        ("Place a block yellow and a block green at the two sides of the red block.",
         "Place a yellow block and a green block on both sides of the red block."),
        ("A tower with height of three cubes, all in red.", "A tower of three red cubes."),
        ("The red block is necessary to put on the blue one.", "Put the red block on the blue one."),
        ("Lay the blue stone between the two orange stones.", "Put the blue cube between the two orange cubes."),
        ("tower of 4, letters only", "A tower of 4 letters."),
        ("Rotate the cube labelled F by 90 degrees clockwise and leave it at its position.",
         "Rotate the cube F by 90 degrees clockwise. Leave it where it is."),
        ("Put two cubes yellows on the blue mat.", "Put two yellow cubes on the blue mat."),
    ],
)  # fmt: skip
def test_it_is_read_as_in_plain_words(said: str, meant: str) -> None:
    """The same blocks, the same goal."""
    assert means(said) == means(meant)
