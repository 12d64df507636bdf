"""What is added to be sure, what is said in more words than it takes, and whom "none of them" speaks of."""

from __future__ import annotations

import pytest

from rpg.blocks.english import describe
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        ("Build a tower of three red blocks only.", "Build a tower of exactly three red blocks."),
        ("Do put A on B.", "Put A on B."),
        ("Put A left of B. Nothing sits on top of anything.", "Put A left of B. Nothing must be on A and B."),
        ("Three things have to be true. A is on B. B is on the patch.", "A is on B. B is on the patch."),
        ("The goal holds if A is on B.", "A is on B."),
        ("Make an L of 5 red blocks. Put A on the corner of the L.",
         "Make an L of 5 red blocks. Put A on the corner block."),
        ("3 towers, each 2 high, one red, one white, in that order left to right".replace("3", "2"),
         "Build two towers, one of two red blocks and one of two white blocks. "
         "The red tower is to the left of the white tower."),
        ("Put a red block on each side of the word CAT.", "Put a red block on both sides of the word CAT."),
        ("The robot starts with a tower of A and B. Put A on the patch.",
         "At the start there is a tower of A and B. Put A on the patch."),
        ("Put a red block on each of the two towers of two blue blocks.",
         "Build two towers of two blue blocks and put a red block on each."),
        ("Given the row X Y Z: reverse it.", "At the start there is a row of X, Y, Z. Reverse it."),
        ("Put the one with the 3 on the one with A.", "Put the block 3 on the block A."),
        ("A, B and C are stacked and stand on the patch.", "A, B and C are stacked on the patch."),
        ("A and C carry a red and a blue block respectively.", "Put a red and a blue block on A and C respectively."),
        ("The initial tower is A, B, C from the bottom; reverse it.",
         "At the start the tower is A, B, C from the bottom; reverse it."),
        ("Put the 3 in between the 7 and the 8.", "Put the block 3 between the block 7 and the block 8."),
    ],
)  # fmt: skip
def test_the_same_in_fewer_words(said: str, plain: str) -> None:
    assert means(said) == means(plain)


@pytest.mark.parametrize("none", ["with none of them touching", "so that no two of them touch"])
def test_of_none_of_more_than_two(none: str) -> None:
    found = means(f"Put the red block between the green and the blue block {none}.")
    for pair in ("red block must not touch the green", "red block must not touch the blue", "green block must not"):
        assert pair in found


def test_lengths_are_still_in_inches() -> None:
    assert "gap of 5.08 cm" in means("Leave 2 in between the red and the blue block.")


def test_a_part_of_one_of_two_figures_is_asked_for() -> None:
    assert code_of("Make an L of 5 yellow blocks and a plus of five red ones, and put A on the corner of the L.")


def test_a_block_put_on_a_tower_of_look_alikes() -> None:
    assert code_of("There is a tower of two red blocks. Put a block on top of it.")
    found = means("There is a tower of two blue blocks. Put the red block on its top block.")
    assert "The two blue blocks must be stacked." in found


def test_the_lowest_layer_of_a_pyramid_is_as_wide_as_it_is_told() -> None:
    told = "A brown pyramid that is three blocks wide at the bottom, two in the middle and one at the top."
    assert "six brown blocks" in means(told)


@pytest.mark.parametrize("beside", ["on top of", "to the left of", "between"])
def test_both_of_two_towers_are_towers(beside: str) -> None:
    task, _ = BuiltinFrontEnd().read(f"A red block is {beside} a blue and a green tower.")
    assert task is None or "three blue blocks" in describe(task)


def test_exactly_so_many_are_there_whatever_is_said_of_them_behind() -> None:
    found = means("Exactly three of the four yellow cubes are on the green patch, the other one does not touch them.")
    assert "Yellow block 4 must not be on the green patch." in found
    assert "Yellow block 4 must not touch yellow block 3." in found


def test_a_wall_has_several_blocks_on_top() -> None:
    told = "Build a wall of white blocks two high and three wide and put a black block on top of it."
    assert "on at least one of the six white blocks" in means(told)


def test_what_is_denied_is_not_insisted_on() -> None:
    assert "must not be on the gray patch" in means("Don't put A on the patch, but do put B there.")
