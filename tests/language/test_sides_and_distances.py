"""On which side of one thing others are, and how far from it, in more words: each of several beside it, the side away
from me, one on each side, as far from one as from the other, gaps as wide as a block."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


def _said(text: str) -> str:
    return means(text).replace("\n", " ").partition(". ")[2]


_D = (
    "The D block must be to the left of the red block. The D block must touch the red block. The E block must be to "
    "the right of the red block. The E block must touch the red block."
)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        # what is told last is told of each
        ("Put D to the left of the red block and E to the right of it, both touching it.", _D),
        ("Put D to the left of the red block and E to the right of the red block, each touching it.", _D),
        ("Build a tower of A on B on C, and put D to the left of it and E to the right of it, each touching it.",
         "The blocks A, B and C must be stacked from top to bottom in the order A, B, C. The D block must be to the "
         "left of the C block. The D block must touch the C block. The E block must be to the right of the C block. "
         "The E block must touch the C block."),
        # sides
        ("Put the red block beside the blue one, but on the side away from me.",
         "The red block must be behind the blue block. The red block must be next to the blue block."),
        ("Put the red block on the side of the blue block nearest to me.", "The red block must be in front of the blue "
         "block."),
        ("Push the red block up against the blue block from the left.",
         "The red block must be to the left of the blue block. The red block must touch the blue block."),
        ("The red block must touch the blue one on the near side.",
         "The red block must be in front of the blue block. The red block must touch the blue block."),
        ("Put A next to B and C on the other side of it.",
         "The A block must be next to the B block. The B block must be between the A block and the C block."),
        ("The letter X should be on the red block's left and the letter Y on its right.",
         "The X block must be to the left of the red block. The Y block must be to the right of the red block."),
        ("Put the brown block in line with the red and the blue block, to the right of both.",
         "The brown, red and blue blocks must be in a line. The brown block must be to the right of the red and blue "
         "blocks."),
        ("Put one blue block to the left of the red block and another two to its right.",
         "A blue block must be to the left of the red block. The other two blue blocks must be to the right of the red "
         "block."),
        ("A red block. Behind it a green block. Behind that one a blue block.",
         "The green block must be behind the red block. The blue block must be behind the green block."),
        ("Stack the red block on the blue block and put the yellow block next to the lower one.",
         "The red block must be on the blue block. The yellow block must be next to the blue block."),
        # how far
        ("Place the red cube such that it is equally far from the blue cube and from the green cube.",
         "The red block must be at the same distance from the blue and green blocks."),
        ("Put the green block between the red block and the blue block, which are 20 cm apart.",
         "The green block must be between the red block and the blue block. The red block must be 20 cm from the blue "
         "block."),
        ("Make sure that there is at least one block's width between the red and the blue block.",
         "There must be a gap of at least 4 cm between the red block and the blue block."),
        ("Place the orange block behind the green block, with no space between the two.",
         "The orange block must be behind the green block. The orange block must touch the green block."),
        ("Put the blue cube close to the red cube, but not so close that they touch.",
         "The blue block must be near the red block. The blue block must not touch the red block."),
        ("The blocks must not be in a row: red, blue, green.",
         "At the start, the red, blue and green blocks are in a row. The red, blue and green blocks must not be in a "
         "row."),
        ("Put the red block 10 cm left of the blue block and the green one 12 cm behind the blue one, both distances "
         "being measured between the centres.",
         "The red block must be to the left of the blue block. The red block must be 10 cm from the blue block. The "
         "green block must be behind the blue block. The green block must be 12 cm from the blue block."),
        ("Put block C behind both A and B, which are next to each other.",
         "The C block must be behind the blocks A and B. The A block must be next to the B block."),
        ("There must be exactly 6 cm between the left side of the red block and the right side of the blue block.",
         "The red block must be to the right of the blue block. There must be a gap of 6 cm between the red block and "
         "the blue block."),
        ("The brown block must neither touch the red block nor be behind it.",
         "At the start, the brown block touches the red block. The brown block must not touch the red block. The brown "
         "block must not be behind the red block."),
        # what there should be
        ("There should be a red block that is left of the blue block and touches it.",
         "The red block must be to the left of the blue block. The red block must touch the blue block."),
        ("Build a tower of two blue blocks and put a red block that touches it next to it.",
         "The two blue blocks must form a tower of exactly two. The red block must touch the tower of the two blue "
         "blocks. The red block must be next to the tower of the two blue blocks."),
    ],
)  # fmt: skip
def test_what_is_read(text: str, said: str) -> None:
    assert _said(text) == said


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("Put D in front of the red block and E behind the white block, both touching it.", "ambiguous"),
        ("Put D on the red block and E to the right of it, both touching it.", "ambiguous"),
        ("Put a green block behind the red one, and a blue block behind that one.", "ambiguous"),
        ("Put A next to B and C on the other side of D.", "ambiguous"),
        ("put the red block on one side of the blue block and the green block on the other", "misplaced-word"),
        ("The orange block touches the brown block on its left side.", "incomplete"),
        ("Put a red block next to a blue block and two more behind it.", "ambiguous"),
        ("Put the two red blocks left of the two blue ones, with no gap between the two.", "ambiguous"),
        ("I want a red block that is left of the blue block and a green block that is right of it.", "ambiguous"),
    ],
)
def test_what_could_be_meant_of_several_is_asked(text: str, code: str) -> None:
    assert code_of(text) == code
