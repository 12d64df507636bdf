"""Sentences of people who speak English in an unusual way: doings told by nouns, places and participles first, blocks
singled out by what they share, and words that are typed in a hurry."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

READ = {
    # doings told by nouns
    "The task is the placement of the blue cube behind the yellow cube.":
        "There are a blue block and a yellow block. The blue block must be behind the yellow block.",
    "Stacking of the red block on the blue block, followed by placement of the green block next to the tower.":
        "There are a red block, a blue block and a green block. First, the red block must be on the blue block. "
        "Then, the green block must be next to the blue block.",
    "Stacking of three yellow blocks and the alignment of four red blocks in a row.":
        "There are three yellow blocks and four red blocks. The three yellow blocks must be stacked. The four red "
        "blocks must be in a row.",
    "The objective is the spelling of the word DOG.":
        "There are a D block, an O block and a G block. The blocks D, O and G must spell the word DOG.",
    # what stands last elsewhere
    "Standing on the mat should be a tower of two green blocks.":
        "There are two green blocks. There is a gray patch. The two green blocks must form a tower of exactly two "
        "on the gray patch.",
    "To the left of the red cube the green one is to be placed, to the right of it the yellow one.":
        "There are a green block, a red block and a yellow block. The green block must be to the left of the red "
        "block. The yellow block must be to the right of the red block.",
    "To be stacked: the A, the B and the C, the A being on top.":
        "There are an A block, a B block and a C block. The three blocks must be stacked with the A block on top.",
    "The red and the blue cube shall be placed so that the two are touching themselves.":
        "There are a red block and a blue block. The red block must touch the blue block.",
    # who is meant
    "There are the letters A, B, E, and K. Could those that are vowels form a row, while the ones that aren't are "
    "stacked?":
        "There are an A block, a B block, an E block and a K block. The blocks A and E must be in a row. The blocks"
        " B and K must be stacked.",
    "Could you put the letter that comes first in the alphabet on the one that comes last? The letters are C, M and T.":
        "There are a C block and a T block. There is also an M block as a distractor. The C block must be on the T "
        "block.",
    "There are two red blocks and a green one; the two that share a colour should stand next to each other.":
        "There are two red blocks. There is also a green block as a distractor. The two red blocks must be next to "
        "each other.",
    "There are a red, a blue and a green cube. Could you place the cube which is neither red nor blue onto the mat?":
        "There is a green block. There is a gray patch. There are also a red block and a blue block as distractors."
        " The green block must be on the gray patch.",
    # not quite idiomatic
    "A row is to be made out of the numbers 1 to 3, beginning at the left with the biggest.":
        "There are a 1 block, a 2 block and a 3 block. The blocks 1, 2 and 3 must be in a row from left to right in"
        " descending numerical order.",
    "The stack shall contain exactly two cubes, of which the lowest shall be brown.":
        "There are a brown block and a red block. The brown and red blocks must form a tower of exactly two from "
        "bottom to top in the order brown, red.",
    "Three cubes in a row: red, green, blue. Forbidden: red touching blue.":
        "There are a red block, a green block and a blue block. The three blocks must be in a row from left to "
        "right in the order red, green, blue. The red block must never touch the blue block.",
    "We have a couple of black cubes and a white one; set the white one between 'em.":
        "There are two black blocks and a white block. The white block must be between the two black blocks.",
    "There ought to be two stacks of two, each one of a single colour.":
        "There are two red blocks and two blue blocks. The two red blocks and the two blue blocks must form two "
        "towers of two, each of a different color.",
    "One places the blue cube behind the yellow cube.":
        "There are a blue block and a yellow block. The blue block must be behind the yellow block.",
    "As for the A, put it on the B; as for the C, put it behind the D.":
        "There are an A block, a B block, a C block and a D block. The A block must be on the B block. The C block "
        "must be behind the D block.",
    "Whatever is red must be stacked, whatever is blue must be lined up. There are 3 red blocks and 2 blue ones.":
        "There are three red blocks and two blue blocks. The three red blocks must be stacked. The two blue blocks "
        "must be in a line.",
    "The order, from front to back, shall be: 1, 2, 3.":
        "There are a 1 block, a 2 block and a 3 block. The three blocks must be in a column on the table from front"
        " to back in the order 1, 2, 3.",
    "It should not be that the red cube is touching the green one. They both lie on the mat.":
        "There are a red block and a green block. There is a gray patch. The red block must not touch the green "
        "block. The red and green blocks must be on the gray patch.",
    "With respect to the green block, the blue block is located in front and the red block behind.":
        "There are a blue block, a green block and a red block. The blue block must be in front of the green block. "
        "The red block must be behind the green block.",
    "The two blocks of the colour orange are to be separated by a distance of at least 15 cm.":
        "There are two orange blocks. The two orange blocks must be at least 15 cm apart.",
    "The block that is on the red mat must be the blue one.":
        "There is a blue block. There is a red patch. The blue block must be on the red patch.",
    # typed in a hurry
    "left 2 right: red, blue, green":
        "There are a red block, a blue block and a green block. The three blocks must be in a row from left to "
        "right in the order red, blue, green.",
    "row of 2 red blks w/out gaps":
        "There are two red blocks. The two red blocks must be in a row without gaps.",
    "two stacks 3 each, one red one blue":
        "There are three red blocks and three blue blocks. The three red blocks must form a tower of exactly three."
        " The three blue blocks must form a tower of exactly three.",
}  # fmt: skip
REFUSED = {
    "Stack 3 red/blue.": "count-mismatch",
    "There are two red blocks and two green ones. The two that share a colour are stacked.": "ambiguous",
}


@pytest.mark.parametrize("text", READ)
def test_it_is_read(text: str) -> None:
    assert means(text) == READ[text]


@pytest.mark.parametrize("text", REFUSED)
def test_it_is_asked(text: str) -> None:
    assert code_of(text) == REFUSED[text]
