"""What people say whose language is another: "after" for "after that", "without to move", "the big one" by size."""

import pytest

from tests.language.meaning import means, start_and_end


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
