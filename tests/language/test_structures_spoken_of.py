"""Structures as what a clause speaks of: told by where they stand, by what they read, swapped as a whole, there before
anything is done, and with a block on top that is none of theirs."""

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "The tower that is on the patch has three red blocks.",
            "The three red blocks must form a tower of exactly three on the gray patch.",
        ),
        (
            "The row behind the tower of two red blocks has four blue blocks.",
            "The four blue blocks must be behind the tower of the two red blocks.",
        ),
        (
            "What stands on the patch is a tower of three red blocks.",
            "The three red blocks must form a tower of exactly three on the gray patch.",
        ),
        ("A row that reads FOX lies behind the red block.", "The blocks F, O and X must be behind the red block."),
        ("A 2x2 square of blue blocks, the front left one on the patch.", "Blue block 1 must be on the gray patch."),
    ],
)
def test_told_by_where_they_stand(text: str, told: str) -> None:
    assert means(text).endswith(told)


def test_towers_are_swapped_as_wholes() -> None:
    told = means("Swap the tower of two red blocks and the tower of two blue blocks.")
    assert "At the start, the two blue blocks form a tower of exactly two." in told
    assert "The two red blocks and the two blue blocks must swap places." in told
    told = means("There is a tower of A on B and a tower of C on D. Swap the two towers.")
    assert told.endswith("The blocks C and D must be stacked from top to bottom in the order C, D.")
    assert code_of("Swap the tower of two red blocks and the tower of three blue blocks.") == "count-mismatch"


@pytest.mark.parametrize(
    "text",
    [
        "Put a red block on an existing tower of two blue blocks.",
        "Add a red block on top of a tower of two blue ones that is already there.",
    ],
)
def test_it_is_there_at_the_start(text: str) -> None:
    told = means(text)
    assert "At the start, the two blue blocks form a tower of exactly two." in told
    assert told.endswith("The red block must be on the tower of the two blue blocks.")


def test_what_is_done_now_tells_nothing_of_the_start() -> None:
    assert "At the start" not in means("Put a red block on a tower of two blue blocks now.")


def test_a_block_on_a_whole_pyramid() -> None:
    told = means("A pyramid of three blue cubes with a yellow cube on top.")
    assert told.endswith("The yellow block must be on the pyramid.")
    assert "yellow, red and blue" in means("A pyramid of three blocks with a yellow one on top.")


def test_one_block_of_a_tower_has_no_blocks() -> None:
    task, _ = BuiltinFrontEnd().read("The tower on the patch has a red block at the bottom.")
    assert task is None


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "A tower of two red blocks in front of which stands a row of three blue blocks.",
            "The three blue blocks must be in front of the tower of the two red blocks.",
        ),
        (
            "A row of three red blocks, next to which stands a green block.",
            "The green block must be next to the three red blocks.",
        ),
        (
            "The top block of the tower of three red blocks must move next to the patch.",
            "Red block 1 and red block 2 must form a tower of exactly two.",
        ),
    ],
)
def test_what_stands_by_them(text: str, told: str) -> None:
    assert means(text).endswith(told)


@pytest.mark.parametrize(
    "text",
    [
        "Move the left block of the row of three red blocks onto the patch.",
        "Move the bottom block of the tower of three red blocks next to the patch.",
        "The bottom block of the tower of three red blocks moves next to the patch.",
    ],
)
def test_what_is_moved_out_of_them_is_no_longer_in_them(text: str) -> None:
    assert code_of(text) == "ambiguous"
