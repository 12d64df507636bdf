"""What is spoken of again: by what is so of it, by where it is, as one of several."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.compose.test_meanings import told
from tests.language.meaning import assert_means

MEANT: dict[str, dict[str, Any]] = {
    "Three green cubes: one goes on the red patch, one on the blue patch, and the third on top of the one on the red "
    "patch.": {
        "assets": {"green": 3, "red_patch": 1, "blue_patch": 1},
        "hold": ["at=red_patch green^green ; at=blue_patch green"],
        "miss": ["at=red_patch green ; at=blue_patch green^green", "at=red_patch green green ; at=blue_patch green"],
    },
    "There are two gray blocks and two pink blocks. Neither of the gray blocks touches either of the pink blocks.": {
        "assets": {"gray": 2, "pink": 2},
        "hold": ["gray . pink | . . . | gray . pink"],
        "miss": ["pitch=1 gray pink ; gray ; pink", "pitch=1 gray gray pink ; pink"],
    },
    "Stack Q on R and S on T. The stack with the R in it should be behind the other one.": {
        "assets": {"Q": 1, "R": 1, "S": 1, "T": 1},
        "hold": ["R^Q | . | T^S"],
        "miss": ["T^S | . | R^Q", "R^Q . T^S", "Q^R | . | T^S"],
    },
    "Put E on a three-block pink tower and F on a two-block gray tower, with the E tower to the right.": {
        "assets": {"E": 1, "F": 1, "pink": 3, "gray": 2},
        "hold": ["gray^gray^F . pink^pink^pink^E"],
        "miss": ["pink^pink^pink^E . gray^gray^F", "gray^gray^E . pink^pink^pink^F"],
    },
    "Eight brown blocks. Half of them form a row, which lies on the pink mat, and the other half form a tower.": {
        "assets": {"brown": 8, "pink_patch": 1},
        "hold": ["pitch=1 at=pink_patch brown brown brown brown ; brown^brown^brown^brown"],
        "miss": [
            "pitch=1 at=pink_patch brown brown brown ; brown^brown^brown^brown^brown",
            "pitch=1 brown brown brown brown ; at=pink_patch brown^brown^brown^brown",
        ],
    },
    "A white cube goes on the rightmost of the three gray cubes, which form a row, and a black one on the leftmost.": {
        "assets": {"gray": 3, "white": 1, "black": 1},
        "hold": ["gray^black gray gray^white"],
        "miss": ["gray^white gray gray^black", "gray gray^black gray^white"],
    },
    "Behind a tower of two red blocks lies a row of two pink ones, and on the left one of these two stands the 7.": {
        "assets": {"red": 2, "pink": 2, "7": 1},
        "hold": ["at=0,0 red^red ; pitch=1 at=4,0 pink^7 pink"],
        "miss": ["at=0,0 red^red ; pitch=1 at=4,0 pink pink^7", "at=0,0 red^red^7 ; pitch=1 at=4,0 pink pink"],
    },
    "Set the green block on the gray one. Beside the gray goes the red block, and that one has a white one on it.": {
        "assets": {"green": 1, "gray": 1, "red": 1, "white": 1},
        "hold": ["gray^green red^white"],
        "miss": ["gray^green^white red", "gray^green white^red"],
    },
    "Make two towers of three pink blocks each; the gray block stands between them, on neither of them.": {
        "assets": {"pink": 6, "gray": 1},
        "hold": ["pink^pink^pink gray pink^pink^pink"],
        "miss": ["pink^pink^pink^gray . pink^pink^pink", "gray pink^pink^pink pink^pink^pink"],
    },
    "A tower of two white blocks is left of the red patch, on which lies a row of two black blocks.": {
        "assets": {"white": 2, "black": 2, "red_patch": 1},
        "hold": ["pitch=1 at=red_patch black black ; at=red_patch+0,5 white^white"],
        "miss": ["pitch=1 at=red_patch black black ; at=red_patch+0,-5 white^white", "at=red_patch black ; black"],
    },
    "Behind the white block stands the gray block, which carries the pink block.": {
        "assets": {"white": 1, "gray": 1, "pink": 1},
        "hold": ["gray^pink | white"],
        "miss": ["gray | white^pink", "white | gray^pink"],
    },
    "One of the gray blocks stands next to the red one and carries the blue one. The other gray block is on the mat.": {
        "assets": {"gray": 2, "red": 1, "blue": 1, "patch": 1},
        "hold": ["red gray^blue ; at=patch gray"],
        "miss": ["red gray ; at=patch gray^blue", "red^blue gray ; at=patch gray"],
    },
    "Two of the pink blocks form a tower. The other three lie on the blue mat.": {
        "assets": {"pink": 5, "blue_patch": 1},
        "hold": ["pink^pink ; pitch=1 at=blue_patch pink pink pink"],
        "miss": [
            "pink^pink^pink ; pitch=1 at=blue_patch pink pink",
            "pink pink ; pitch=1 at=blue_patch pink pink pink",
        ],
    },
    "7, 8 and 9 sit on the pink, white and gray blocks respectively, and those three blocks form a row in that order "
    "from left to right.": {
        "assets": {"7": 1, "8": 1, "9": 1, "pink": 1, "white": 1, "gray": 1},
        "hold": ["pink^7 white^8 gray^9"],
        "miss": ["gray^9 white^8 pink^7", "pink^8 white^7 gray^9", "pink^7 gray^9 white^8"],
    },
    "There is a green mat and a pink mat. On each mat lies a block of its own color, and on each of these blocks sits "
    "a gray one.": {
        "assets": {"green": 1, "pink": 1, "gray": 2, "green_patch": 1, "pink_patch": 1},
        "hold": ["at=green_patch green^gray ; at=pink_patch pink^gray"],
        "miss": [
            "at=green_patch pink^gray ; at=pink_patch green^gray",
            "at=green_patch green^gray^gray ; at=pink_patch pink",
        ],
    },
    "Everything white is on the blue mat, everything pink on the red mat. The two white blocks are stacked; the three "
    "pink ones form a row.": {
        "assets": {"white": 2, "pink": 3, "blue_patch": 1, "red_patch": 1},
        "hold": ["at=blue_patch white^white ; pitch=1 at=red_patch pink pink pink"],
        "miss": [
            "at=red_patch white^white ; pitch=1 at=blue_patch pink pink pink",
            "pitch=1 at=blue_patch white white ; pitch=1 at=red_patch pink pink pink",
        ],
    },
    "The tower on the red mat reads SUN from bottom to top; the row on the green mat reads FOX.": {
        "assets": {"S": 1, "U": 1, "N": 1, "F": 1, "O": 1, "X": 1, "red_patch": 1, "green_patch": 1},
        "hold": ["at=red_patch S^U^N ; pitch=1 at=green_patch F O X"],
        "miss": [
            "at=red_patch N^U^S ; pitch=1 at=green_patch F O X",
            "at=red_patch S^U^N ; pitch=1 at=green_patch X O F",
        ],
    },
    "Of eight gray blocks, four make up a row and two make up a tower; the rest lie on the red mat.": {
        "assets": {"gray": 8, "red_patch": 1},
        "hold": ["pitch=1 gray gray gray gray ; gray^gray ; pitch=1 at=red_patch gray gray"],
        "miss": [
            "pitch=1 gray gray gray gray ; gray^gray ; gray gray",
            "gray gray ; gray^gray^gray^gray ; at=red_patch gray gray",
        ],
    },
    "Neither of the two gray blocks may be on the red patch, but both pink ones must be, one stacked on the other.": {
        "assets": {"gray": 2, "pink": 2, "red_patch": 1},
        "hold": ["at=red_patch pink^pink ; gray . gray"],
        "miss": [
            "pitch=1 at=red_patch pink^pink gray ; gray",
            "pitch=1 at=red_patch pink pink ; gray . gray",
            "pink^pink ; gray ; gray",
        ],
    },
    "Put the two pink blocks on the brown mat, one on top of the other.": {
        "assets": {"pink": 2, "brown_patch": 1},
        "hold": ["at=brown_patch pink^pink"],
        "miss": ["pitch=1 at=brown_patch pink pink", "pink^pink"],
    },
    "The white block must not be on the mat, but the gray one must.": {
        "assets": {"white": 1, "gray": 1, "patch": 1},
        "hold": ["at=patch gray ; white"],
        "miss": ["pitch=1 at=patch gray white", "gray white", "at=patch white ; gray"],
    },
    "Put the white block on the one in the middle of the row red, gray, red. The pink one goes directly in front of "
    "that same middle block.": {
        "assets": {"white": 1, "red": 2, "gray": 1, "pink": 1},
        "hold": ["red gray^white red | . pink ."],
        "miss": [". pink . | red gray^white red", "red gray^white red | pink . ."],
    },
    "Of the white, the pink and the black mat only the black one is to be empty; the other two each get a tower of two "
    "green blocks.": {
        "assets": {"white_patch": 1, "pink_patch": 1, "black_patch": 1, "green": 4},
        "hold": ["at=white_patch green^green ; at=pink_patch green^green"],
        "miss": [
            "at=white_patch green^green ; at=black_patch green^green",
            "at=white_patch green^green ; at=pink_patch green ; green",
        ],
    },
    "The pink block stands on the gray patch, a white one to its left and another to its right.": {
        "assets": {"pink": 1, "white": 2, "gray_patch": 1},
        "hold": ["at=gray_patch pink ; at=gray_patch+0,4 white ; at=gray_patch+0,-4 white"],
        "miss": [
            "at=gray_patch white ; at=gray_patch+0,4 pink ; at=gray_patch+0,-4 white",
            "at=gray_patch pink ; at=gray_patch+4,0 white ; at=gray_patch+0,-4 white",
        ],
    },
    "A red block in the middle of the table, with one pink block directly to its left, one directly to its right and "
    "one directly behind it.": {
        "assets": {"red": 1, "pink": 3},
        "hold": [". pink . | pink red pink"],
        "miss": ["pink red pink | . pink .", "pink pink . | red pink ."],
    },
    "A white block and next to it two gray ones, one to its left and one to its right.": {
        "assets": {"white": 1, "gray": 2},
        "hold": ["gray white gray"],
        "miss": ["white gray gray", "gray | white | gray"],
    },
}


@pytest.mark.parametrize("text", MEANT)
def test_read(text: str) -> None:
    assert_means(text, MEANT[text])


@pytest.mark.parametrize(
    "text",
    [
        "There are five blocks. Put one on the blue mat.",  # which one
        "Put a blue block behind each of the two white blocks.",  # one for each, or one for both
        "Make a row of two white blocks and a tower of two red ones. Put a pink block behind each.",
        "a row of four white blocks, black on the right",  # at its end, or beside it
        "Stack one of the two white blocks and one of the two pink blocks.",  # on which one
        "Of the four white blocks, exactly three are on the mat, where they form a tower.",  # they: all of them?
        "Put C on D or E, and F on the mat.",  # what does "and" join?
        "Build a 2x2 square of white blocks and put a black block on each corner.",  # of the square, or of each block
        "There are two pink and two black blocks. Stack two of them.",
        "two rows out of six blocks, one white and one black",
        "Any of the two white blocks must be next to the black one.",
        "On each of the two red blocks sits a white one. On each of these blocks sits a pink one.",  # on which ones
        "A is on the red block and B on the blue one. Those two blocks form a row.",
        "The two white blocks and the pink one go left of D and E respectively.",  # which ones
        "There is a row of three white blocks and the row reads PEN.",  # that one, or another
        "There are two red blocks and a blue one. Everything pink goes on the white mat.",
        "Put a white block left of the red one and another behind it.",  # behind which one
        "Line up three white blocks and put a gray block at the right end.",  # at the end, or on it
    ],
)
def test_not_read(text: str) -> None:
    assert told(text) == []
