"""Texts of several parts: a figure and what is beside it, a figure that is there already, sizes told apart."""

from __future__ import annotations

import pytest

from rpg.language.frames import retold
from rpg.language.frames.around.attached import without_attached
from rpg.language.frames.around.changed import changes
from rpg.language.frames.around.given import with_given
from rpg.language.frames.around.measured import without_measures
from rpg.language.frames.around.paired import pairs
from rpg.language.frames.retelling import plainly
from tests.language.frames.told import words


def changed(text: str) -> list[str]:
    tokens = words(text)
    given = [(start, aim) for start, _, aim in with_given(tokens, plainly)]
    return list(dict.fromkeys(changes(tokens, plainly, given)))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("A tower of three blue blocks, and in front a white block.", "Put a white block in front of the tower."),
        ("tower of red and green. blue next to it", "Put blue next to the tower."),
        (
            "Build a tower of five blocks in rainbow colors and next to it one of two white blocks.",
            "Build a tower of 2 white blocks next to the tower.",
        ),
        (
            "Build one tower out of two red blocks and one row of two yellow blocks in front.",
            "Build one row of 2 yellow blocks in front of the tower.",
        ),
    ],
)
def test_what_is_beside_a_figure_is_told_apart(text: str, told: str) -> None:
    assert [said for _, _, said in without_attached(words(text))][:1] == [told]


@pytest.mark.parametrize(
    "text",
    [
        "Build a tower of three red blocks, but do not put a blue block next to it.",
        "Build a tower of two red blocks or put a blue block next to it.",
        "Three red blocks in a row, blue on the left.",  # it may be the end of the row
        "Stack two yellow cubes and, to the left of them, two gray cubes.",  # these may be stacked, too
        "Use four blocks. Build a tower of red blocks and put a blue one behind it.",  # one of the four
        "Stack yellow on black. Beside the stack place white, and on it purple.",
        "Build a tower of two red blocks. Put the red block behind it.",
        "a 2x2 square with a red block in front",
    ],
)
def test_what_may_be_of_the_figure_is_left_alone(text: str) -> None:
    assert not list(without_attached(words(text)))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "A wall three blocks wide and two high in brown stands behind a row of three green blocks",
            "Build a wall 3 blocks wide and 2 blocks high from 6 brown blocks. Lay 3 green blocks in a row. "
            "The wall must be behind the row.",
        ),
        (
            "a tower of two red blocks and behind it a row of three yellow",
            "Lay 3 yellow blocks in a row. Build a tower from 2 red blocks. The row must be behind the tower.",
        ),
        (
            "a row of three green blocks, to the left of which stands a tower of two red blocks",
            "Build a tower from 2 red blocks. Lay 3 green blocks in a row. The tower must be to the left of the row.",
        ),
        (
            "a tower of two red blocks to the left of a tower of three blue blocks",
            "Build a tower from 2 red blocks. Build a tower from 3 blue blocks. "
            "The tower of the 2 red blocks must be to the left of the tower of the 3 blue blocks.",
        ),
    ],
)
def test_two_figures_are_told_with_how_one_stands_to_the_other(text: str, told: str) -> None:
    assert set(pairs(words(text), plainly)) == {told}


@pytest.mark.parametrize(
    "text",
    [
        "a tower of two red blocks next to a tower of two red blocks",
        "a tower of two red blocks is not next to a row of three blue blocks",
        "There is a tower of two red blocks. Build a row of three blue blocks behind it.",
        "put a tower of two green blocks, topped by a purple block, behind a row of three yellow blocks",
        "First build a tower of two red blocks, then a row of three blue blocks behind it.",
    ],
)
def test_figures_that_are_told_in_another_way_are_no_pair(text: str) -> None:
    assert not list(pairs(words(text), plainly))


def test_a_question_is_not_told_again() -> None:
    assert not list(retold(words("Is a tower of two red blocks next to a row of three blue blocks?")))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("Edge length 6 cm for both blocks; the red one goes on the blue one", "All blocks are 6 cm."),
        ("Blocks are 5 cm. Build a tower of three red blocks.", "All blocks are 5 cm."),
        ("The scene contains two blocks with an edge length of 6 cm. Put red on blue.", "All blocks are 6 cm."),
        ("Build a tower of two red blocks on the blue mat. The mat measures 15 cm.", "The mat is 15 cm wide."),
    ],
)
def test_sizes_are_told_in_a_sentence_of_their_own(text: str, told: str) -> None:
    assert [said for _, _, said in without_measures(words(text))] == [told]


@pytest.mark.parametrize(
    "text",
    [
        "Put purple on white. Put red on blue, both 5 cm.",  # not all four
        "A big red block with a 6 cm edge, and on it a normal blue one",
        "Blocks are 5 cm. Build a tower of three 3 cm red blocks.",
        "The cubes are not 5 cm wide. Put red on blue.",
        "All blocks but the red one are 5 cm. Put red on blue.",
        "Blocks are 5 cm apart. Put red next to blue.",
    ],
)
def test_sizes_of_some_blocks_are_left_alone(text: str) -> None:
    assert not list(without_measures(words(text)))


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "The episode starts from a six-block tower alternating red and black, red at the bottom. "
            "It ends with one tower per color",
            "At the start, there is a tower of alternating colors from 3 red blocks and 3 black blocks. "
            "At the start, a red block is at the bottom.",
        ),
        (
            "There is a tower with red at the bottom, green in the middle and blue on top. Turn it upside down.",
            "At the start, there is a tower from 1 red block and 1 green block and 1 blue block, "
            "from bottom to top: red, green, blue.",
        ),
        (
            "There are three blocks in a row, white, black, white. Swap the first two",
            "At the start, 2 white blocks and 1 black block are in a row from left to right: white, black, white.",
        ),
    ],
)
def test_a_figure_that_is_there_is_told_of_the_start(text: str, told: str) -> None:
    assert [start for start, _, _ in with_given(words(text), plainly)] == [told]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            "Take the top block off the tower of three green blocks and put it on the table to the left of it",
            "Build a tower from 2 green blocks. Put another green block to the left of the tower. "
            "At the start, all blocks form a tower.",
        ),
        (
            "There is a tower of three red blocks. Move the top one in front of the tower.",
            "Build a tower from 2 red blocks. Put another red block in front of the tower. "
            "At the start, all blocks form a tower.",
        ),
        (
            "The scene has a tower of five gray blocks. Remove the top two blocks and put them next to the tower.",
            "Build a tower from 3 gray blocks. Put another gray block next to the tower. "
            "Put another gray block next to the tower. At the start, all blocks form a tower.",
        ),
        (
            "Insert one black cube between the two green cubes of the existing tower, "
            "so that the tower reads green, black, green",
            "At the start, there is a tower from 2 green blocks. "
            "Build a tower from 2 green blocks and 1 black block, from bottom to top: green, black, green.",
        ),
        (
            "Replace the top block of the red tower of three with a green one.",
            "At the start, there is a tower from 3 red blocks. "
            "Build a tower from 2 red blocks and 1 green block, from bottom to top: red, red, green.",
        ),
        (
            "Start with a tower of two red blocks. Put a blue block underneath.",
            "At the start, there is a tower from 2 red blocks. "
            "Build a tower from 1 blue block and 2 red blocks, from bottom to top: blue, red, red.",
        ),
    ],
)
def test_a_change_to_a_tower_is_told_as_what_comes_out(text: str, told: str) -> None:
    assert changed(text) == [told]


@pytest.mark.parametrize(
    "text",
    [
        "There is a tower of three red blocks. Do not move the top one in front of the tower.",
        "There is a tower of three red blocks. Move all but the top one in front of the tower.",
        "There are two towers of three red blocks. Move the top one in front of the tower.",
        "Insert a black cube between the two green cubes of the existing tower, so that it reads black, green, green.",
        "There is a tower of two green blocks. Replace the top block with a green one.",
        "Remove the top block of each tower of three red blocks and put it next to the tower.",
        "Build a tower of three red blocks and take the top block off the tower and put it to the left of the tower.",
        "Take the top red block off the tower of three green blocks and put it next to it.",
        "Remove the top block from the tower of two red blocks and put it beside it.",
        "Take the bottom block out of the tower of three red blocks and put it next to it.",
        "First take the top block off the tower of three red blocks and put it next to the tower, then put it back.",
    ],
)
def test_other_changes_are_left_alone(text: str) -> None:
    assert not changed(text)


def test_an_existing_tower_is_told_of_the_start() -> None:
    text = "Make a tower of three yellow cubes next to the existing tower of two purple cubes."
    assert next(said for _, said in retold(words(text))).startswith("At the start, there is a tower from 2 purple")


def test_distractors_may_have_to_stay() -> None:
    text = "Stack four green blocks. A red block and a blue block lie around as distractors and must not be touched."
    assert "The red block and the blue block must stay where they are." in next(said for _, said in retold(words(text)))
