"""How people ask for something who think of no command: what they imagine or are doing, what a task has, small talk."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("I'm imagining a big U from 7 blue blocks with the opening towards me.",
         "A U of 7 blue blocks with the opening towards me."),
        ("hi, first day here :) can i just have a red cube on a green cube?", "A red cube on a green cube."),
        ("need smth simple, 3 cubes in a row, any colors", "3 cubes in a row."),
        ("We're stacking the red block on the blue block", "Put the red block on the blue block."),
        ("Can you help my son make a row of four red blocks?", "Make a row of four red blocks."),
        ("Do you think you could manage a tower of six red blocks?", "A tower of six red blocks."),
        ("I'd like a stacking task with three cubes, red, green and blue; success when they form a tower.",
         "There are three cubes, red, green and blue. They form a tower."),
        ("I need a task where the red cube goes on the blue patch", "The red cube goes on the blue patch."),
        ("simple pick and place baseline: red cube onto the blue target", "Red cube onto the blue target."),
        ("My daughter wants her name ANNA spelled with the blocks.", "Spell ANNA."),
        ("We sit in a circle! Put eight white blocks in a row.", "Put eight white blocks in a row."),
        ("The letters A to F want to stand in two rows today. A B C in the back row, D E F in the front row.",
         "The letters A to F in two rows: A B C in the back row, D E F in the front row."),
        ("Precondition: 5 red blocks in a heap. Postcondition: the 5 red blocks are one tower.",
         "At the start 5 red blocks are in a heap. At the end the 5 red blocks form one tower."),
        ("temporal order: A on the mat, B on A", "First A on the mat, then B on A."),
        ("The demo starts with six blocks thrown into a heap, three each of red and blue. It ends with one pile per "
         "colour, and the piles are clearly separated.",
         "There are three red and three blue blocks in a heap. Sort them into piles by colour; the piles are apart."),
        ("Put the two red cubes together, i.e. touching.", "Put the two red cubes together, touching."),
        ("A must be alone on the mat, which means B and C are off it.",
         "A must be alone on the mat. B and C are off it."),
        ("one red block each in front of and behind the blue block",
         "a red block in front of the blue block and another red block behind the blue block"),
        ("Put red on blue, and the green cube must stay not moved.", "Put red on blue, green must not be moved."),
        ("Build a rainbow tower! Red at the bottom, then orange, yellow and green on the very top.",
         "Build a rainbow tower: red at the bottom, then orange, yellow and green on top."),
        ("The grid I want is 2x3 and red.", "The grid is 2x3 and red."),
    ],
)  # fmt: skip
def test_it_is_the_plain_task(text: str, plain: str) -> None:
    assert means(text) == means(plain)


def test_a_heap_in_front_of_an_end_is_the_start() -> None:
    told = means("Three red cubes are in a heap; at the end no two touch.")
    assert "At the start, the three red blocks lie in a heap" in told
    assert "group" not in told


@pytest.mark.parametrize(
    "text",
    [
        "I'm not imagining a tower of four red blocks",
        "We aren't stacking A on B.",
        "I don't want a task where red is on blue.",
        "I only want the red block on the mat",
        "We are putting on a show. Put red on blue.",
    ],
)
def test_what_is_not_wished_for_is_not_asked_for(text: str) -> None:
    assert code_of(text)
