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
        (
            "blue and green next to each other red on top of blue",
            "There are a blue block, a green block and a red block. The blue block and the green block must be "
            "next to each other. The red block must be on top of the blue block.",
        ),
        (
            "got 4 blue blocks, all but one go on the patch",
            "There are 4 blue blocks and a patch. Exactly 3 of the 4 blue blocks must be on the patch.",
        ),
        (
            "all four red blocks on the patch except one",
            "There are 4 red blocks and a patch. Exactly 3 of the 4 red blocks must be on the patch.",
        ),
        (
            "Between cyan box and orange box must be gap of 6 centimeter.",
            "There are a cyan block and an orange block. There must be a gap of 6 cm between the cyan block and "
            "the orange block.",
        ),
        (
            "The white block stays within 1 cm of its starting position while the red block is moved onto the patch.",
            "There are a white block, a red block and a patch. The white block must not be moved by more than 1 "
            "cm. The red block must be on the patch.",
        ),
        (
            "White target of circle shape should have red block and blue block on it, and black block should be "
            "outside of it.",
            "There are a red block, a blue block, a round white patch and a black block. The red block and the "
            "blue block must be on the round white patch. The black block must not be on the round white patch.",
        ),
        (
            "one of three purple boxes must be on top of gray box, other two are on table",
            "There are 3 purple blocks and a gray block. 1 of the 3 purple blocks must be on top of the gray "
            "block. The other 2 purple blocks must be on the table.",
        ),
        (
            "Only the yellow block should be on the mat, the red and the green block are elsewhere on the table.",
            "There are a yellow block, a patch, a red block and a green block. Only the yellow block must be on "
            "the patch. The red block and the green block must not be on the patch.",
        ),
        (
            "red blocks 2 pieces on patch red, blue block 1 piece on patch blue",
            "There are 2 red blocks, a red patch, a blue block and a blue patch. The 2 red blocks must be on the "
            "red patch. The blue block must be on the blue patch.",
        ),
        (
            "the mat should be clear, the red block and the blue block next to it",
            "There are a patch, a red block and a blue block. The patch must be empty. The red block and the blue"
            " block must be next to the patch.",
        ),
        (
            "mat: red, blue. table: green.",
            "There are a red block, a blue block, a patch and a green block. The red block and the blue block "
            "must be on the patch. The green block must be on the table.",
        ),
        (
            "Make it so the brown block isn't on the gray block any more but next to it.",
            "There are a brown block and a gray block. At the start, the brown block is on top of the gray block."
            " The brown block must not be on top of the gray block. The brown block must be next to the gray "
            "block.",
        ),
        (
            "please take the two orange blocks and put one on the red mat and one on the blue mat",
            "There are 2 orange blocks, a red patch and a blue patch. 1 of the 2 orange blocks must be on the red"
            " patch. The other orange block must be on the blue patch.",
        ),
        (
            "put red left of blue with 10 cm between them",
            "There are a red block and a blue block. The red block must be to the left of the blue block. There "
            "must be a gap of 10 cm between the red block and the blue block.",
        ),
        (
            "Both of the cyan blocks must touch the brown block, but the cyan blocks must not touch each other.",
            "There are 2 cyan blocks and a brown block. The 2 cyan blocks must touch the brown block. The 2 cyan "
            "blocks must not touch each other.",
        ),
        (
            "the cyan one above the red one, not necessarily touching",
            "There are a cyan block and a red block. The cyan block must be above the red block.",
        ),
        (
            "Move the small black block from on top of the big white block to the table in front of it.",
            "There are a small black block and a big white block. At the start, the small black block is on top "
            "of the big white block. The small black block must be on the table. The small black block must be in"
            " front of the big white block.",
        ),
        (
            "i have three blocks red blue green i want red to be between blue and green",
            "There are a red block, a blue block and a green block. The red block must be between the blue "
            "block and the green block.",
        ),
        (
            "red next to blue and leave everything else alone",
            "The red block must be next to the blue block. All other blocks must stay where they are.",
        ),
        (
            "There are a red block, a blue block and a green block. Swap red and blue. Leave everything else alone.",
            "There are a red block, a blue block and a green block. The red block and the blue block must "
            "swap places. The green block must stay where it is.",
        ),
        (
            "There are a red and a blue block. The former must be on the latter.",
            "There are a red block and a blue block. The red block must be on top of the blue block.",
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
        "Put three red blocks on the mat except one.",  # of how many?
        "All but four of the three red blocks on the patch.",
        "red on blue, and red to the left",  # of the table, or of the blue block?
        "Three white cubes on the purple patch. The orange one must stay empty.",  # a patch
        "The mat must be clear and the red one on the blue one, the blue one clear.",
        "Half of the five red blocks on the mat.",
        "There are a red block, a blue block and a mat. The latter must be next to the red block.",
        "The red block must never be within 5 cm of its starting position.",
        "mat: not red. table: red",
        "Leave the red block on the mat except one.",
        "The red block may only be on the mat if the blue block is too.",
        "the red block must be on the blue block red",
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
