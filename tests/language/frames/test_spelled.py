"""Words told part by part, in whatever order and syntax."""

from __future__ import annotations

import pytest

from tests.language.frames.told import told


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("Spell the word HELLO with the letter blocks in a row from left to right.", "Spell HELLO."),
        ("Write CAT downwards in a tower, with C on top.", "Spell CAT in a tower from top to bottom."),
        (
            "Spell out SUN in a row. The S is yellow, the U is orange and the N is red.",
            "Spell SUN. The S is yellow. The U is orange. The N is red.",
        ),
        ("make it say HI on the green mat", "Spell HI. The word is on the green mat."),
        (
            "TREE in a line, both Es green and the rest brown",
            "Spell TREE. The T is brown. The R is brown. The E blocks are green.",
        ),
        (
            "word FISH, vowels red, consonants blue",
            "Spell FISH. The F is blue. The I is red. The S is blue. The H is blue.",
        ),
        ("put the letters so they read LOVE, 2 cm gap between each", "Spell LOVE. The gaps are 2 cm."),
        ("letter blocks: P, A, R, K. arrange so that they spell PARK", "Spell PARK."),
        (
            "Using letter cubes write the name ANNA with no gaps between the letters",
            "Spell ANNA. The letters touch each other.",
        ),
        ("The word SNOW is to be formed by white letter cubes.", "Spell SNOW. The letters are white."),
        (
            "spell me CAKE, with the C red and the rest white",
            "Spell CAKE. The C is red. The A is white. The K is white. The E is white.",
        ),
        ("In a vertical stack, spell the word TOP, T being the topmost.", "Spell TOP in a tower."),
        (
            "Spell S-U-N",
            "Spell SUN.",
        ),
        (
            "Lay out the word C A T",
            "Spell CAT.",
        ),
        ("Spell TOT with a red T.", "Spell TOT. 1 of the T blocks is red."),
        (
            "Spell NOON with both Ns red but one O blue",
            "Spell NOON. The N blocks are red. 1 of the O blocks is blue.",
        ),
        ("Spell TREE with a green E", "Spell TREE. 1 of the E blocks is green."),
        (
            "Spell TREE with green Es",
            "Spell TREE. The E blocks are green.",
        ),
        (
            "Would be nice if you wrote HELLO on the table with the letter cubes.",
            "Spell HELLO.",
        ),
        (
            "Could you spell my cat's name, MOLLY?",
            "Spell MOLLY.",
        ),
    ],
)
def test_parts_are_put_together(text: str, plain: str) -> None:
    assert told(text) == plain


@pytest.mark.parametrize(
    "text",
    [
        "an RGB tower",
        "Spell CAT or DOG.",
        "Spell CAT but not with a red A.",
        "Spell CAT, then turn it into COT.",
        "Spell a word with the letters A, C and T.",
        "Do not spell CAT.",
        "Spell CAT backwards.",
        "Spell HELLO with the red L at the beginning.",
        "Spell CAT to the left of DOG.",
        "Spell CAT without the A.",
        "Write CAT in a tower from bottom to top with C on top.",
        "Spell CAT with the letters C, A and R.",
        "It should say DOG.",
        "Spell ONE with 2 letters.",
        "Spell THANK YOU",
        "Spell TREE with three green Es",
        "Spell NOON with one O blue and the rest red",
    ],
)
def test_what_is_not_clear_is_not_told(text: str) -> None:
    assert told(text) is None
