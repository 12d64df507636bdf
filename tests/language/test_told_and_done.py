"""Facts before what is done, and who "it", "they all", "instead" and "no longer" are of."""

from __future__ import annotations

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import code_of, means, start_and_end


@pytest.mark.parametrize(
    ("text", "goal"),
    [
        ("A is on B and C is on D. Put both A and C on the mat.", "The blocks A and C must be on the gray patch"),
        ("A is left of B. Stack them.", "The blocks A and B must be stacked"),
        ("A is between B and C. Stack all three.", "must be stacked"),
        ("The word DOG is on the table. The letters should be stacked instead.", "must be stacked"),
        ("A is on B. Turn A upside down.", "The A block must be upside down"),
        ("A, B and C form a tower on the red mat. Move the tower to the blue mat.", "exactly three on the blue patch"),
        ("A is on B and C is on D. A and C should be stacked.", "The blocks A and C must be stacked"),
    ],
)
def test_facts_before_what_is_done_are_the_start_alone(text: str, goal: str) -> None:
    begun, end = start_and_end(text)
    assert begun
    assert goal in end
    assert end.count(" must ") == 1


@pytest.mark.parametrize(
    ("wish", "goal"),
    [
        ("They should all be on the blue mat.", "The blocks A, B and C must be on the blue patch"),
        ("Put them all in a row.", "The blocks A, B and C must be in a row"),
        ("Stack them all.", "The blocks A, B and C must be stacked"),
    ],
)
def test_they_all_are_all_that_were_told_of(wish: str, goal: str) -> None:
    assert goal in start_and_end(f"A and B are on the red mat. C is on the blue mat. {wish}")[1]


@pytest.mark.parametrize("them", ["they all", "these all"])
def test_they_all_are_more_than_the_two_that_were_told_together(them: str) -> None:
    text = f"Put the red block between the two blue blocks so that {them} touch."
    assert "The red block and the two blue blocks must touch each other" in means(text)


def test_nothing_is_between_two_that_touch() -> None:
    text = "Put the red block between the two blue blocks so that {} touch."
    assert code_of(text.format("they")) == "contradiction"
    assert code_of(text.format("the blue ones")) == "contradiction"


@pytest.mark.parametrize("place", ["behind A", "between A and B", "beside the mat", "on A"])
def test_instead_of_what_is_at_a_place(place: str) -> None:
    begun, end = start_and_end(f"The red block is {place}. The blue block should be {place} instead.")
    assert "the red block is" in begun
    assert "The blue block must be" in end
    assert "The red block must not be" in end


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("The red block is on the left. The blue one should be there instead.", "ambiguous"),
        ("A and B are stacked. The tower should be mixed.", "misplaced"),
        ("The red block is on the blue one and the green one is on the mat. Take the red and the green one off.",
         "ambiguous"),
    ],
)  # fmt: skip
def test_what_is_not_clear_is_asked(text: str, code: str) -> None:
    assert code_of(text) == code


@pytest.mark.parametrize(
    ("who", "goal"),
    [
        ("One of them", "Exactly one of the three red blocks must not be on the gray patch"),
        ("Two of them", "Exactly two of the three red blocks must not be on the gray patch"),
    ],
)
def test_so_many_no_longer(who: str, goal: str) -> None:
    begun, end = start_and_end(f"Three red blocks are on the mat. {who} should no longer be on it.")
    assert "three red blocks are on the gray patch" in begun
    assert end.rstrip(".") == goal


def test_each_is_taken_off_what_it_lies_on() -> None:
    end = start_and_end("A is on B and C is on D. Take A and C off.")[1]
    assert "The A block must not be somewhere above the B block" in end
    assert "The C block must not be somewhere above the D block" in end


def test_so_many_blocks_that_remain_are_of_those_that_are_there() -> None:
    task, notes = BuiltinFrontEnd().read(
        "A tower of four blocks stands on the mat. Only two blocks should remain on it."
    )
    assert task is not None, notes
    assert len(task.blocks) == 4


def test_swapping_only_two_leaves_the_others() -> None:
    assert (
        "The blocks C and D must stay where they are" in start_and_end("There are A, B, C and D. Swap only A and B.")[1]
    )


def test_it_is_the_one_that_was_told_of() -> None:
    assert start_and_end("Two blocks are stacked. The upper one is red. Put it on the mat.")[1].startswith(
        "The red block must be"
    )


def test_a_mat_that_something_is_on_is_emptied_of_it() -> None:
    assert start_and_end("A is on the red mat. Empty it.")[1].rstrip(".") == "The A block must not be on the red patch"


def test_stacks_that_nothing_may_be_on_in_the_end_are_the_start() -> None:
    begun, end = start_and_end(
        "Two stacks of two: red on red, blue on blue. At the end no block may be on another block."
    )
    assert begun.count("stacked") == 2
    assert "stacked" not in end
    assert code_of("Stack A, B and C. No block may be on another one.") == "contradiction"
    assert "Nothing must be on the tower" in means("Build a tower of three red blocks with nothing on top of it.")
