"""Relations between single blocks, small lots and patches, told in many ways."""

from __future__ import annotations

import pytest

from tests.language.frames.told import told


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        (
            "cyan goes left of brown but not right next to it",
            "There are a cyan block and a brown block. The cyan block must be to the left of the brown "
            "block. The cyan block must not be right next to the brown block.",
        ),
        (
            "The small pink cube perches on the big gray cube.",
            "There are a small pink block and a big gray block. The small pink block must be on top of the "
            "big gray block.",
        ),
        (
            "On the white mat goes the red block, and on the black mat goes the blue block.",
            "There are a white patch, a red block, a black patch and a blue block. The red block must be on "
            "the white patch. The blue block must be on the black patch.",
        ),
        (
            "first the gray block goes on the red mat, then the orange block goes on top of the gray one",
            "There are a gray block, a red patch and an orange block. First, the gray block must be on the "
            "red patch. Then, the orange block must be on top of the gray block.",
        ),
        (
            "Neither the red nor the blue block may be on the patch.",
            "There are a red block, a blue block and a patch. The red block must not be on the patch. The "
            "blue block must not be on the patch.",
        ),
        (
            "A red block has a green block on its left and a yellow block on its right.",
            "There are a green block, a red block and a yellow block. The green block must be to the left of "
            "the red block. The yellow block must be to the right of the red block.",
        ),
        (
            "Put one of the two yellow blocks on the red block and the other one on the blue block.",
            "There are 2 yellow blocks, a red block and a blue block. 1 of the 2 yellow blocks must be on "
            "top of the red block. The other yellow block must be on top of the blue block.",
        ),
        (
            "You see a black block and a yellow block side by side. Put the yellow one onto the black one.",
            "There are a black block and a yellow block. At the start, the black block and the yellow block "
            "are next to each other. The yellow block must be on top of the black block.",
        ),
        (
            "Move the white cube from the red mat to the blue mat.",
            "There are a white block, a red patch and a blue patch. At the start, the white block is on the "
            "red patch. The white block must be on the blue patch.",
        ),
        (
            "the green one sits to the right of the yellow one with a gap of 5 cm between them",
            "There are a green block and a yellow block. The green block must be to the right of the yellow "
            "block. There must be a gap of 5 cm between the green block and the yellow block.",
        ),
        (
            "The cyan block, which carries the pink block, stands on the white patch.",
            "There are a cyan block, a pink block and a white patch. The pink block must be on top of the "
            "cyan block. The cyan block must be on the white patch.",
        ),
        (
            "The white block must never touch the black block; put the gray block on the black one.",
            "There are a white block, a black block and a gray block. The white block must never touch the "
            "black block. The gray block must be on top of the black block.",
        ),
        (
            "Exchange the positions of the orange and the purple block.",
            "There are an orange block and a purple block. The orange block and the purple block must swap places.",
        ),
        (
            "The cube A must stay in place while the cube B is put on it.",
            "There are a letter A and a letter B. The letter A must stay where it is. The letter B must be "
            "on top of the letter A.",
        ),
        (
            "Put a red block to the left and a green block to the right of the yellow one.",
            "There are a red block, a yellow block and a green block. The red block must be to the left of "
            "the yellow block. The green block must be to the right of the yellow block.",
        ),
        (
            "put the blue block left of the orange one, 8 cm away",
            "There are a blue block and an orange block. The blue block must be to the left of the orange "
            "block. The blue block must be 8 cm from the orange block.",
        ),
        (
            "Three of the five blue blocks belong on the gray mat, the other two belong in the right half of "
            "the table.",
            "There are 5 blue blocks and a gray patch. 3 of the 5 blue blocks must be on the gray patch. The "
            "other 2 blue blocks must be in the right half of the table.",
        ),
    ],
)
def test_relations_are_told_plainly(text: str, plain: str) -> None:
    assert told(text) == plain


@pytest.mark.parametrize(
    "text",
    [
        "There are a red block and a blue block. It must be on the patch.",  # which of them?
        "Put A on the red and B on the blue patch.",  # a red block, or a red patch?
        "Put the red block on the blue block. Green is on the mat.",  # now, or in the end?
        "red on blue and green on yellow, in the left half of the table",  # both, or the last?
        "Put two blue blocks on the mat and one on the green block.",  # one of them, or another?
        "Put the red block next to the blue block or the green one.",
        "The red block may be on the blue block.",
        "Is the red block on the blue block?",
        "Should pink be on cyan, put brown on pink.",
        "Put both of the three green blocks on the mat.",
        "Exactly one of the two cyan and two brown blocks is on the pink mat.",
        "The red block touches the blue block and they are 20 cm apart.",
        "Leave the red block where it is and put it on the blue block.",
        "Put the red block left of the blue block, with a white one on top.",  # on which?
        "Stack three red blocks on the mat.",  # one on the other
        "red isn't on blue and green on yellow",
        "There is a red block on the table.",  # it is so at the start
        "Put the red block on the left side of the mat.",  # inside of it?
        "The brown block is next to the black one, the black one carrying the letter A.",  # a label?
        "1) Put white on black 2) put yellow on white",  # one after the other
    ],
)
def test_what_is_not_clear_is_not_told(text: str) -> None:
    assert told(text) is None
