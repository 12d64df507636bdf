"""Groups told part by part, in whatever order and syntax."""

from __future__ import annotations

import pytest

from tests.language.frames.told import told


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        (
            "Form three groups: one consisting of two red cubes, one of two green cubes, and one of two yellow cubes.",
            "Make 3 groups, one of 2 red blocks, one of 2 green blocks and one of 2 yellow blocks.",
        ),
        (
            "put all the reds together and all the blues together, 3 each, two piles",
            "Make 2 groups, one of 3 red blocks and one of 3 blue blocks.",
        ),
        (
            "There are four white and four black blocks; every colour shall make up a heap of its own.",
            "Group 4 white blocks and 4 black blocks by color.",
        ),
        (
            "make two bunches, one with A B C and the other with 1 2 3",
            "Make 2 groups, one of the blocks A, B and C and one of the blocks 1, 2 and 3.",
        ),
        (
            "Sort these letters into vowels and consonants: A, B, E, F, I.",
            "Group the blocks A, B, E, F and I by vowels and consonants.",
        ),
        (
            "Blocks with 1, 2, 3, 4, 5, 6. Odd ones go in one group, even ones in another group.",
            "Make 2 groups, one of the blocks 1, 3 and 5 and one of the blocks 2, 4 and 6.",
        ),
        (
            "Every group should have exactly one odd one out: 4 red, 4 blue cubes, group by color",
            "Group 4 red blocks and 4 blue blocks by color with exactly 1 outlier in each group.",
        ),
        ("Split 8 brown blocks into four equal piles", "Split 8 brown blocks into 4 groups of 2."),
        (
            "Two groups of blocks. First: red, red, green. Second: blue, blue, yellow.",
            "Make 2 groups, one of 2 red blocks and 1 green block and one of 2 blue blocks and 1 yellow block.",
        ),
        (
            "We have three red and three blue. Separate by color, groups at least 15 cm apart.",
            "Group 3 red blocks and 3 blue blocks by color. The groups are at least 15 cm apart.",
        ),
        (
            "I'd like you to organise the number cubes 1, 3, 4, 6 and 8 in an odd pile and an even pile",
            "Group the blocks 1, 3, 4, 6 and 8 by odd and even.",
        ),
        (
            "letters go with letters, numbers with numbers: A, B, 1, 2, two groups",
            "Group the blocks A, B, 1 and 2 by kind.",
        ),
        (
            "Put all of the green cubes in a single bunch; there are five of them.",
            "Make one group of 5 green blocks.",
        ),
        (
            "numbers one through six in two groups odd ones and even ones",
            "Group the blocks 1, 2, 3, 4, 5 and 6 by odd and even.",
        ),
        (
            "Sort three red and three blue blocks into two groups by colour, with the red group to the left of "
            "the blue group.",
            "Group 3 red blocks and 3 blue blocks by color. The red group is left of the blue group.",
        ),
        (
            "the even digits go left pile, odd digits right pile: 1 2 3 4",
            "Make 2 groups, one of the blocks 2 and 4 and one of the blocks 1 and 3. The group of the 2 is left "
            "of the group of the 1.",
        ),
        (
            "greens and purples dont mix, 3 of each, make 2 piles",
            "Group 3 green blocks and 3 purple blocks by color.",
        ),
        (
            "pink ones over here, gray ones over there, 3 pink and 3 gray, so two heaps",
            "Make 2 groups, one of 3 pink blocks and one of 3 gray blocks.",
        ),
        (
            "make two pile, red cube in first, black cube in second, 3 cube each",
            "Make 2 groups, one of 3 red blocks and one of 3 black blocks.",
        ),
        (
            "make red group and green group, in every group 4 cube",
            "Make 2 groups, one of 4 red blocks and one of 4 green blocks.",
        ),
        (
            "i have six blocks three of them are red and three are blue and i want them sorted into two piles by color",
            "Group 3 red blocks and 3 blue blocks by color.",
        ),
        (
            "Partition nine blocks, three red, three green and three blue, into colour-homogeneous clusters.",
            "Group 3 red blocks, 3 green blocks and 3 blue blocks by color.",
        ),
        (
            "Blocks 1 through 6 are to be split by parity, with the odd numbers forming a group on the left and "
            "the even numbers a group on the right.",
            "Make 2 groups, one of the blocks 1, 3 and 5 and one of the blocks 2, 4 and 6. The group of the 1 is "
            "left of the group of the 2.",
        ),
        (
            "two piles, the big blocks in one, the small blocks in the other; 3 big blue ones, 3 small blue ones",
            "Group 3 big blue blocks and 3 small blue blocks by size.",
        ),
        (
            "could you make two little piles for me? One with the letters M, N, O and one with the numbers 4, 5, 6.",
            "Make 2 groups, one of the blocks M, N and O and one of the blocks 4, 5 and 6.",
        ),
        (
            "three piles, one red, one yellow, one blue, with three blocks in each pile",
            "Group 3 red blocks, 3 yellow blocks and 3 blue blocks by color.",
        ),
    ],
)
def test_parts_are_put_together(text: str, plain: str) -> None:
    assert told(text) == plain


@pytest.mark.parametrize(
    "text",
    [
        "Group three red and three blue blocks, but not by color.",
        "Make two groups of red or blue blocks, three each.",
        "Make three groups, one of two red blocks and one of two blue blocks.",
        "Divide seven green blocks into two groups of three.",
        "Divide six blocks into two groups.",
        "Sort 3 red and 3 blue by color except the last one.",
        "Each group must have two strangers or none: 4 red, 4 blue.",
        "One group has a stranger; group 4 red and 4 blue blocks by color.",
        "Sort 1, 2, 3, 4 into odd and even, but leave 3 where it is.",
        "Make a group of three red blocks around a blue one.",
        "Five yellow blocks are lying in a heap.",
        "gather the four red cubes in the middle",
        "Two groups: red, blue and green.",
        "4 red, 4 blue: reds in one pile, two blues in another.",
        "Reds in one pile, blues in another, 3 red and 3 blue and 3 green.",
        "Put the odd numbers 1, 3 in a group without the 5.",
        "First group the reds, 3 of them, then group the 3 blues.",
        "three red and three blue blocks in two piles, but not by colour",
        "everything but the red ones in one pile: 2 red, 2 blue",
        "odd digits 1, 2 and 3 in one pile, even digits 4 and 6 in another",
        "four letters A, B and C in one pile, the digits 1 and 2 in another",
        "red blocks in one pile and a blue block in the other, three blocks each, one red",
    ],
)
def test_what_is_not_clear_is_not_told(text: str) -> None:
    assert told(text) is None
