"""Blocks as people: a character makes no other block of one, what they do tells where they are, and a wish what must
hold; what only tells two blocks apart, or an order of its own, is asked about."""

from __future__ import annotations

import pytest

from rpg.language.stories.character import TELLING_NOTHING
from rpg.language.telling import may_tell
from tests.language.meaning import code_of, means

RED_ON_BLUE = means("Put the red block on the blue block.")


def test_no_word_of_character_could_tell_of_blocks() -> None:
    assert not [word for word in TELLING_NOTHING if may_tell(word)]


@pytest.mark.parametrize(
    "text",
    [
        "Put the brave red cube on the grumpy blue cube.",
        "Sleepy red lies on sleepy blue.",
        "The red block sits proudly on the blue one.",
        "The red block takes a nap on the blue one.",
        "The red block is asleep on the blue one.",
        "The red block keeps watch on top of the blue one.",
        "The red block has climbed onto the blue one.",
        "Help the red block climb onto the blue block.",
        "The red block is tired and wants to sleep on the blue block.",
        "King Red sits on Queen Blue.",
        "Give the blue block a red hat.",
        "The blue block wears a red crown.",
        "Put a red block on the blue block as its roof.",
        "Put the red block on the blue one so that it can see everything.",
        "The hero cube is red. Put the hero cube on the blue cube.",
        "Put the hero cube, a red one, on the blue cube.",
        "The red block is afraid of heights, so put it on the blue block.",
        "The blue block would like some company: put the red one on it.",
    ],
)
def test_a_story_is_what_it_says_of_the_blocks(text: str) -> None:
    assert means(text).removeprefix("There are a blue block and a red block.") in (
        RED_ON_BLUE,
        RED_ON_BLUE.removeprefix("There are a red block and a blue block."),
    )


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("Red guards blue from the left.", "Red is to the left of blue."),
        ("Two gray blocks guard the red one on both sides.", "The red block is between two gray blocks."),
        ("Load up the green mat with a red box and a blue box.", "Put a red box and a blue box on the green mat."),
        ("Stack red, yellow and green like a traffic light.",
         "Stack red, yellow and green, red on top, yellow in the middle, green at the bottom."),
        ("Stack red on green. Blue does not want to touch anybody.",
         "Stack red on green. Blue must not touch anything."),
        ("Line up five red blocks like ducks in a row.", "Line up five red blocks."),
        ("The black block wants to be left alone, so keep it 20 cm from the white block.",
         "Put the black block 20 cm from the white block."),
        ("A row of three white cubes and a black one at the end.",
         "A row of three white cubes with a black one at the end."),
        ("An elegant tower of four slender red cubes.", "A tower of four red cubes."),
    ],
)  # fmt: skip
def test_plain_words_mean_the_same(text: str, plain: str) -> None:
    assert means(text) == means(plain)


@pytest.mark.parametrize(
    "text",
    [
        "Put the brave cube on the grumpy cube.",
        "Put the brave red cube on the shy red cube.",
        "Put the happy one on the sad one.",
        "Put the ochre cube, a big one, on the red mat.",
        "The ochre cube is big. Put the ochre cube on the red mat.",
        "Red, yellow and green in a row like a traffic light.",
        "Stack three yellow and three black blocks like a bee.",
        "A red block guarded by two white blocks.",
        "The red block likes being next to the blue one.",
        "Build a staircase of three steps. It must not climb to the left.",
        "Put the red block next to the blue one so they can see each other.",
        "Put a red roof on top of two white blocks.",
    ],
)
def test_what_may_tell_more_is_asked_about(text: str) -> None:
    assert code_of(text)


def test_a_load_is_all_that_is_listed() -> None:
    said = means("Load the green mat with a red box, a blue box and a yellow box, none touching.")
    assert "The red, blue and yellow blocks must be on the green patch." in said


def test_what_is_told_to_be_alone_starts_so() -> None:
    text = "The cyan block sits on the brown one, the pink one is alone. Put the pink block on top of the cyan block."
    assert "At the start, the pink block is on the table." in means(text)
