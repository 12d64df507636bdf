"""The compositional reader: what a text is told again as, and what it does not read."""

from __future__ import annotations

import pytest

from rpg.language.compose import meanings
from rpg.language.spelling import read_words
from rpg.language.tokens import tokenize

_THERE = ("There is", "There are")


def told(text: str) -> list[str]:
    """All that a text can mean, without the sentences of what there is."""
    words, _, _ = read_words(tokenize(text)[0])
    return [" ".join(s for s in meaning.split(". ") if not s.startswith(_THERE)) for meaning in meanings(words)]


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        (
            "A tower of three brown blocks goes directly behind the middle block of a row of three gray blocks.",
            "Brown block 1, brown block 2 and brown block 3 must form a tower of exactly three "
            "Gray block 1, gray block 2 and gray block 3 must be in a row in the order gray block 1, gray block 2, "
            "gray block 3 in either direction The tower of brown block 1, brown block 2 and brown block 3 must be "
            "directly behind gray block 2.",
        ),
        (
            "Place exactly one of the three purple blocks on the gray patch; the remaining two form a stack.",
            "Purple block 2 and purple block 3 must form a tower of exactly two "
            "Purple block 1 must be on the gray patch Purple block 2 must not be on the gray patch "
            "Purple block 3 must not be on the gray patch.",
        ),
        (
            "Build a two-block tower, blue over red, and a second one, green over yellow; "
            "the former must stand left of the latter.",
            "The red block and the blue block must form a tower of exactly two from bottom to top in the order the red "
            "block, the blue block The yellow block and the green block must form a tower of exactly two from "
            "bottom to top in the order the yellow block, the green block The tower of the red block and the "
            "blue block must be "
            "to the left of the tower of the yellow block and the green block.",
        ),
        (
            "Lay four orange blocks out as a square, and put a black block on the one at the far right corner.",
            "Orange block 1, orange block 2, orange block 3 and orange block 4 must form a grid of two rows and two "
            "columns row by row in the order orange block 1, orange block 2, orange block 3, orange block 4 "
            "The black block must be on orange block 2.",
        ),
        (
            "The tower of P and Q, with Q on top, has to be left of the digit 0.",
            "The P block and the Q block must form a tower of exactly two from bottom to top in the order the P block, "
            "the Q block The tower of the P block and the Q block must be to the left of the 0 block.",
        ),
        (
            "At the start, a red tower of three is on the blue patch. Move its top block onto the gray patch.",
            "At the start, red block 1, red block 2 and red block 3 must form a tower of exactly three from "
            "bottom to top in the order red block 1, red block 2, red block 3 At the start, red block 1, red "
            "block 2 and red block 3 "
            "must be on the blue patch Red block 3 must be on the gray patch.",
        ),
        (
            "First put the green cube on the pink mat, then put a white cube next to the green cube.",
            "First, the green block must be on the pink patch Then, the white block must be next to the green block.",
        ),
        (
            "Make a back row of three red blocks and a front row of two blue blocks.",
            "Red block 1, red block 2 and red block 3 must be in a row Blue block 1 and blue block 2 must be in a row "
            "Red block 1, red block 2 and red block 3 must be behind blue block 1 and blue block 2.",
        ),
    ],
)
def test_told_again(text: str, meaning: str) -> None:
    assert told(text) == [meaning]


@pytest.mark.parametrize(
    "text",
    [
        "Put the red block on the frobnicated patch.",  # a word of no class
        "All three red blocks are not on the green patch.",  # none, or not all
        "Build a red tower of two and a green tower of two. The blue one is on the mat.",  # a tower or a block
        "Red is on blue. Afterwards blue should be on red.",  # so at the start, or done first
        "Make a tower of A and B and a tower of C and D next to E.",  # both next to it, or the last one
        "Put a row of four green blocks on the mat; on each of its ends is a pink block.",  # on top, or in line
        "Red is not on the patch and next to blue.",  # what else is denied
        "Put red on the blue mat and green on orange.",  # a block or a mat
        "At the start there is a tower of three red blocks. A blue block has to go on top of the tower.",
        "Two blue blocks and a white one stand in a row. Put it on the mat.",  # what "it" is
        "A 2x3 grid: its far row is green, its near one orange.",  # "its" is no block
    ],
)
def test_not_told_again(text: str) -> None:
    assert told(text) == []


def test_a_chain_grows_to_one_tower() -> None:
    meaning = told("I want red over blue over green, with a white block next to the tower.")[0]
    assert meaning.endswith("next to the tower of the green block, the blue block and the red block.")


def test_more_blocks_than_have_a_word_are_told() -> None:
    words, _, _ = read_words(tokenize("25 blocks in one row")[0])
    assert meanings(words)[0].startswith("There are 25 red blocks.")


@pytest.mark.parametrize(
    "text",
    [
        "Build a row of three pink blocks in the left half and three cyan blocks in the right half.",  # one row, or two
        "There are three red blocks. Each red block must be on the blue patch or the green patch.",  # all on one?
        "two red blocks next to two blue blocks, touching",  # one another, or the blue ones
        "Two stacks, blue over green.",  # each of them, or what is one of two
        "The H may be next to the I.",  # allowed, not asked for
        "M and N stand on opposite sides of the brown block.",  # which one on which side
    ],
)
def test_what_may_be_meant_otherwise_is_not_parsed(text: str) -> None:
    assert told(text) == []


@pytest.mark.parametrize(
    ("text", "meaning"),
    [
        (
            "Put the yellow and the purple block beside the blue block, one on its left and one on its right.",
            "The yellow block and the purple block must be next to the blue block Either the yellow block must be"
            " to the left of the blue block and the purple block must be to the right of the blue block, or the "
            "purple block must be to the left of the blue block and the yellow block must be to the right of the "
            "blue block.",
        ),
        (
            "Put the orange or the pink cube on the green mat, but not both, and leave the white cube where it is.",
            "The white block must stay where it is Either the orange block must be on the green patch and the "
            "pink block must not be on the green patch, or the pink block must be on the green patch and the "
            "orange block must not be on the green patch.",
        ),
        (
            "Three towers of two orange blocks each are to be built, of which exactly one is on the pink patch.",
            "Orange block 1 and orange block 2 must form a tower of exactly two Orange block 3 and orange block 4"
            " must form a tower of exactly two Orange block 5 and orange block 6 must form a tower of exactly two"
            " Orange block 1 and orange block 2 must be on the pink patch Orange block 3 must not be on the pink "
            "patch Orange block 4 must not be on the pink patch Orange block 5 must not be on the pink patch "
            "Orange block 6 must not be on the pink patch.",
        ),
        (
            "Put the 7 and the 8 next to each other, the 8 on the right.",
            "The 7 block must be next to the 8 block The 8 block must be to the right of the 7 block.",
        ),
    ],
)
def test_choices_and_shares(text: str, meaning: str) -> None:
    assert told(text) == [meaning]
