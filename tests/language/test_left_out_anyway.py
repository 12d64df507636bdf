"""Clauses that can only be talk, whatever words are in them, and clauses that follow from the rest: a text is read
without them, but not without a word that could be meant of blocks, or where the rest does not say it."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.language.clauses_left_out import only_talk
from rpg.language.tokens import tokenize
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

Meant = dict[str, Any]

RED_ON_BLUE: Meant = {"assets": {"red": 1, "blue": 1}, "hold": ["blue^red"], "miss": ["red^blue", "blue red"]}
TWO_OF_THREE: Meant = {
    "assets": {"A": 1, "B": 1, "C": 1, "patch": 1},
    "hold": ["A B pitch=1 at=patch ; C", "A ; B C pitch=1 at=patch"],
    "miss": ["A B C pitch=1 at=patch", "A at=patch ; B ; C"],
}
BETWEEN: Meant = {
    "assets": {"yellow": 4, "patch": 1},
    "hold": ["yellow yellow pitch=1 at=patch ; yellow ; yellow"],
    "miss": ["yellow yellow yellow pitch=1 at=patch ; yellow", "yellow at=patch"],
}


@pytest.mark.parametrize(
    "talk",
    [
        "this is the first scenario in my evaluation",
        "so that I can verify position tracking",
        "to see how the policy does",
        "to test grasping",
        "before the timer runs out",
        "like a little chocolate bar",
        "as fast as possible",
        "in as few moves as possible",
        "without knocking anything over",
        "in the simulator",
        "this should be easy",
        "for my pilot study on grasping",
        "the end",
        "have fun",
        "if that makes sense",
        "in a single episode",
    ],
)
def test_what_is_said_around_a_task_is_left_out(talk: str) -> None:
    assert_means(f"Put the red block on the blue block, {talk}.", RED_ON_BLUE)


@pytest.mark.parametrize(
    "lead",
    [
        "As a warehouse operator, I want you to",
        "As a quality engineer I want the robot to",
        "As a line worker, I'd like to",
        "The objective of this level is to",
        "The trick is to",
        "Time to",
        "To complete the level,",
        "In order to win,",
        "For a pilot study on grasping,",
        "He has to",
    ],
)
def test_what_leads_to_a_task_is_left_out(lead: str) -> None:
    assert_means(f"{lead} put the red block on the blue block.", RED_ON_BLUE)


@pytest.mark.parametrize("lead", ["It would be so cute if", "It would be quite satisfying if", "It'd be lovely if"])
def test_it_may_be_thought_of_in_any_word(lead: str) -> None:
    assert_means(f"{lead} the red block sat on the blue block.", RED_ON_BLUE)


@pytest.mark.parametrize(
    "clause",
    [
        "so that the green block is visible",
        "to see whether three of them fit",
        "this is not the task",
        "diagonally placed",
        "like the tower in the corner",
        "because it must not touch B",
        "to keep them apart",
        "this is my other plan",
    ],
)
def test_words_that_may_be_meant_of_blocks_are_no_talk(clause: str) -> None:
    assert not only_talk(tokenize(clause)[0])


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Put any two of the blocks A, B and C on the mat and keep the third off it.", TWO_OF_THREE),
        ("Put any two of the letters A, B and C on the mat, not all three.", TWO_OF_THREE),
        ("Just two of the four yellow blocks on the mat, not three.", BETWEEN),
        ("Put two of the four yellow blocks on the mat and leave two off it.", BETWEEN),
        (
            "Put the four red blocks in one row, nothing on top of anything.",
            {"assets": {"red": 4}, "hold": ["red red red red"], "miss": ["red red red^red", "red^red^red^red"]},
        ),
        (
            "Circle of eight, red and white in turn, so four of each.",
            {"assets": {"red": 4, "white": 4}, "hold": [], "miss": ["red red red red white white white white"]},
        ),
        ("Put A on B, not the other way round. A touching C is not wanted.", None),
        (
            "First stack the red block on the blue one. Then put the green one beside them, not on top.",
            {
                "assets": {"red": 1, "blue": 1, "green": 1},
                "hold": [["blue red green", "blue^red ; green", "blue^red green"]],
                "miss": ["blue^red^green"],
            },
        ),
        (
            "Write SEA downwards, one letter on top of the other.",
            {"assets": {"S": 1, "E": 1, "A": 1}, "hold": ["A^E^S"], "miss": ["S E A", "S^E^A"]},
        ),
        (
            "Stack blue on yellow on black, black being the bottom one.",
            {
                "assets": {"blue": 1, "yellow": 1, "black": 1},
                "hold": ["black^yellow^blue"],
                "miss": ["blue^yellow^black"],
            },
        ),
    ],
)
def test_what_follows_from_the_rest_is_said_by_it(text: str, meant: Meant | None) -> None:
    if meant is None:
        assert BuiltinFrontEnd().read(text)[0] is None
    else:
        assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "Put at least two of the blocks A, B and C on the mat, not three of them in a row.",
        "Stack red on blue. So five in total.",
        "Stack blue on yellow on black, blue being the bottom one.",
        "The white block is next to the red one, not behind.",
    ],
)
def test_what_does_not_follow_is_asked_for(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None
