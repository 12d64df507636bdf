"""What people say whose language is another: "after" for "after that", "without to move", "the big one" by size."""

import pytest

from tests.language.meaning import code_of, means, start_and_end


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("first put blue on red, after put green on blue", "First put blue on red, then put green on blue."),
        ("put red on green without to touch the blue cube", "Put red on green without touching the blue cube."),
        ("change the place of red and blue cube", "Swap the red and the blue cube."),
        ("either red or blue on the mat not both", "Either red or blue on the mat, but not both."),
        ("5 cubes on the mat, no cube on top of other cube", "5 cubes on the mat, no cube on another cube."),
        ("one of the red cubes on the mat, there's 3", "One of the three red cubes must be on the mat."),
        ("each mat gets one cube, 3 mats", "Put one cube on each of three mats."),
        ("i want tower red blue green from bottom", "Build a tower: red, blue, green from bottom to top."),
        ("tower: red blue green from top", "Build a tower: red, blue, green from top to bottom."),
        ("line up 3 cubes by size, big one left", "Line up 3 cubes by size, the largest one on the left."),
    ],
)
def test_it_means_what_others_say(text: str, plain: str) -> None:
    assert means(text) == means(plain)


def test_after_a_clause_is_still_what_is_done_first() -> None:
    assert means("Put blue on red after green is on blue.").endswith(
        "First, the green block must be on the blue block. Then, the blue block must be on the red block."
    )


def test_a_big_one_that_no_size_orders_is_big() -> None:
    assert "The 5 cm red block must be on the 3 cm red block." in means("the big block on the small block")


@pytest.mark.parametrize(
    "text",
    [
        "the tower has red, blue and green from the bottom. take the top one and put it on the mat",
        "tower has 3 blocks red blue green from bottom to top. put the top one on the mat",
        "The tower is red, blue and green from the bottom up. Take the top one and put it on the mat.",
    ],
)
def test_of_a_tower_that_is_there_a_part_is_moved(text: str) -> None:
    begun, end = start_and_end(text)
    assert begun.startswith("At the start, the ")
    assert "from bottom to top in the order red, blue, green" in begun
    assert end == "The green block must be on the gray patch."


def test_it_is_the_tower_where_no_block_is_named() -> None:
    assert means("Move it on the mat. The tower is two red blocks.").endswith(
        "form a tower of exactly two on the gray patch."
    )


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("tower, blue ones down and red ones up, 2 blue 3 red",
         "Build a tower with the blue ones at the bottom and the red ones on top, 2 blue 3 red."),
        ("all on the mat but green stays off. red, blue, green", "All except green on the mat. Red, blue, green."),
        ("red ones on the mat, rest off it. 2 red 3 blue", "Red ones on the mat, the others not. 2 red 3 blue."),
        ("tower of 4 changing colors red blue", "A tower of 4 with alternating colors red and blue."),
        ("red block at the table edge on the left", "The red block must be at the left edge of the table."),
        ("make wall of brick 4 long 2 high", "Build a wall of bricks 4 long and 2 high."),
        ("row of red in front, row of blue at back, 4 each",
         "Row of red blocks in front, row of blue blocks at the back, 4 each."),
        ("cyan on green, green on red, red at the bottom", "Stack red, green and cyan from bottom to top."),
        ("put the bottom block of the tower on top, tower is red blue green",
         "At the start there is a tower of red, blue and green from bottom to top. Put the bottom block on top."),
        ("top block goes to the bottom, tower red green blue from top",
         "There is a tower of red, green and blue from top to bottom. Put the top block at the bottom of the tower."),
        ("move the whole tower on the mat, tower is 2 red blocks",
         "At the start there is a tower of two red blocks. Move the tower onto the mat."),
    ],
)  # fmt: skip
def test_short_words_are_read_in_full(text: str, plain: str) -> None:
    assert means(text) == means(plain)


def test_a_tower_behind_that_nobody_spoke_of_is_no_start() -> None:
    assert code_of("move red and blue to the mat, tower red on blue")
    assert "At the start" not in means("move red and blue to the mat, the tower is red on blue")


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("cubes in 2 groups, 3 and 2", "3 cubes in one group and 2 cubes in another group."),
        ("6 cubes in two piles, 2 and 4", "Six cubes in two groups, one of 2 and one of 4."),
        ("row of red blue green white, red not at the end",
         "A row of red, blue, green and white. Red is not at the end."),
        ("make one big square 3x3 from green cube", "A 3x3 square of green cubes."),
        ("A and C exchange, B no move", "Swap A and C. B does not move."),
        ("blue on red at beginning. at end they are next to each other",
         "At the start blue is on red. At the end they are next to each other."),
        ("biggest number on the mat, 3 8 5", "There are 3, 8 and 5. The biggest number on the mat."),
        ("rotate A 90 degrees to right", "Rotate A 90 degrees to the right."),
    ],
)  # fmt: skip
def test_numbers_and_places_in_few_words(text: str, plain: str) -> None:
    assert means(text) == means(plain)


@pytest.mark.parametrize(
    "text", ["6 cubes in two groups, one of 2 and one of 3", "6 cubes in a group of 2 and a group of 3"]
)
def test_groups_that_do_not_take_all_are_no_sorting(text: str) -> None:
    assert code_of(text)


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("two of three red in tower, third next to it", "Two of three red cubes in a tower, the other one next to it."),
        ("there should not be any cube on the mat, now there are two red",
         "At the start there are two red cubes on the mat. There should not be any cube on the mat."),
        ("Object: red cube. Target: on blue cube.", "Put the red cube on the blue cube."),
        ("Pick: red. Place: green mat.", "Put red on the green mat."),
        ("qty 3 red cubes stacked", "3 red cubes stacked."),
        ("2 pcs red cube in a row", "Two red cubes in a row."),
        ("4 blocks make corners of square", "Four blocks form the corners of a square."),
        ("tower 4 blocks and tower 2 blocks", "A tower of 4 blocks and a tower of 2 blocks."),
        ("one red cube, one blue cube, blue on the mat",
         "There are one red cube and one blue cube. The blue one on the mat."),
    ],
)  # fmt: skip
def test_notes_and_lists_in_few_words(text: str, plain: str) -> None:
    assert means(text) == means(plain)


def test_colors_in_a_list_are_blocks_of_their_own() -> None:
    assert means("red, blue, blue on the mat").startswith("There are a red block and two blue blocks.")
