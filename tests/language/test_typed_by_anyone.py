"""How people type who are in a hurry or speak another language: words left out, in another order, or more than it
takes; and asides that carry nothing."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

ON = "The red block must be on the blue block."
STAYS = "The green block must stay where it is."
READ = {
    "Need put red cube on blue cube. Green cube must be on table, not on other cube.": (
        f"{ON} The green block must be on the table. The green block must not be on the red block. "
        "The green block must not be on the blue block."
    ),
    "There shall be a blue cube of 6 cm, and on it a red cube of the normal size.": (
        "The red block must be on the 6 cm blue block."
    ),
    "I want that the letters A, B and C are in a column, the A most near to me, the B in the middle and the C most "
    "far.": "The three blocks must be in a column on the table from front to back in the order A, B, C.",
    "The red block starts on the blue one. First it goes down on the table, then it goes back onto the blue one.": (
        "At the start, the red block is on the blue block. First, the red block must be on the table. "
        "Then, the red block must be on the blue block."
    ),
    "On the blue block the red block put.": ON,
    "Take the red block and put on top of the blue block.": ON,
    "Stack red on blue but don't you dare move the green one": f"{ON} {STAYS}",
    "Put red on blue, the green one please leave alone.": f"{ON} {STAYS}",
    "no touch the green block. red on blue": f"{STAYS} {ON}",
    "Two towers, all gray: height two on the red mat, three high on the blue mat.": (
        "Two gray blocks must form a tower of exactly two on the red patch. "
        "The other three gray blocks must form a tower of exactly three on the blue patch."
    ),
    "rainbow row pls: green red blue yellow blocks, red leftmost": (
        "The green, red, blue and yellow blocks must be in a row from left to right in rainbow order."
    ),
    "the red one should rest on both green blocks at once, like a little bridge": (
        "The two green blocks and the red block must form a pyramid with a base of two blocks from top to bottom in "
        "the order the red block, then the two green blocks."
    ),
    "S U N in a row, and all of that in the far half of the table": (
        "The blocks S, U and N must be in a row. The blocks S, U and N must be in the far half of the table."
    ),
    "Put the letters A to F into two rows of three, so one reads them in order like on a page.": (
        "The blocks A to F must form a grid of two rows and three columns row by row in alphabetical order."
    ),
    "Turn the F so that top of letter is pointing right, how I see it from above.": (
        "The F block must lie with its top pointing to the right."
    ),
}


@pytest.mark.parametrize("text", READ)
def test_what_is_meant_is_read(text: str) -> None:
    assert means(text).replace("\n", " ").endswith(READ[text])


@pytest.mark.parametrize(
    "aside",
    ["{}, mind you", "{}, careful not to break anything", "{}, if you catch my drift", "{}, as my boss wants it",
     "do the needful and {}", "{}, I can't reach it myself"],
)  # fmt: skip
def test_asides_are_left_out(aside: str) -> None:
    assert means(aside.format("put the red block on the blue block")).replace("\n", " ").endswith(ON)


def test_what_has_a_meaning_is_no_aside() -> None:
    assert "The green block must stay" in means("Put red on blue, careful not to touch the green one.")
    assert code_of("Put A and B in the corners, I don't care which is where.") == "ambiguous"


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("row: position 1 red, position 2 blue, position 3 green", "from left to right in the order red, blue, green."),
        ("position 1 red, position 2 blue, in a row", "from left to right in the order red, blue."),
        ("A to the left, B to the right, in between C, and D on C.",
         "The C block must be between the A block and the B block. The D block must be on the C block. "
         "The A block must be to the left of the B block."),
        ("yellow, on it pink, on it green", "must be stacked from bottom to top in the order yellow, pink, green."),
        ("A in front, B behind A, C behind B",
         "The B block must be behind the A block. The C block must be behind the B block."),
        ("red is 10 cm away from blue, at least", "The red block must be at least 10 cm from the blue block."),
        ("3x3 square, checkers black and white", "three rows and three columns in a checkerboard pattern."),
    ],
)  # fmt: skip
def test_told_in_few_words(text: str, meant: str) -> None:
    assert means(text).replace("\n", " ").endswith(meant)


def test_places_alone_tell_no_tower() -> None:
    assert code_of("position 1 red, position 2 blue, position 3 green") == "no-goal"
    assert code_of("the tower must not be higher than 3. red, blue, green, yellow") == "ambiguous"


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("put the balck cube between the withe ones", "between the two white blocks."),
        ("stack the thre bule cubes", "There are three blue blocks. The three blue blocks must be stacked."),
        ("a column of tree blocks: red gren blu, red nearst", "with the red block at the front end."),
        ("first stack red on blue. when its done put green on the mat", "the green block must be on the gray patch."),
    ],
)
def test_slips_are_mended(text: str, meant: str) -> None:
    assert means(text).replace("\n", " ").endswith(meant)
