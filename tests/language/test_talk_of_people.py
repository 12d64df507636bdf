"""What people wish, think and do around a task asks for nothing; what they would do to blocks is not left out."""

from __future__ import annotations

import pytest

from tests.language.meaning import code_of, means

ASKED = "the red block is on the blue block"
LEADS = (
    "The authors should include a task in which {}.",
    "How about a scene where {}?",
    "I would add an episode where {}.",
    "Ideally {}.",
    "I'm no expert but {}.",
    "The red block is chipped. {}.",
    "Toddlers master this at 18 months. {}.",
    "What a lousy Monday. {}.",
)
BEHIND = (
    "{}, grandpa swears by it.",
    "{}, it soothes my toddler.",
    "{}, that always cracks me up.",
    "{}, which my wife prefers.",
    "{}, my wife loves red.",
    "{} because the intern messed it up.",
    "{} or the baby will wake.",
    "{} while I grab a coffee.",
    "{} as a gesture of goodwill.",
    "{} on behalf of the janitor.",
    "{} for old times' sake.",
    "{} for my first graders.",
    "{} (see sketch).",
    "{}. This probes object permanence.",
    "{}. Best, Karl",
    "{}. Kind regards, Dr. Miller",
)
COMMANDS = (
    "For reproducibility the red block must be on the blue block.",
    "Can it put the red block on the blue block?",
    "Aaaand put the red block on the blue block.",
    "Alexa, put the red block on the blue block.",
    "My 4-year-old wants the red block on the blue block.",
    "The patient picks out the red block and puts it on the blue block.",
)
REFUSED = (
    ("The authors should not include a task in which {}.", "unknown-word"),
    ("It would be a shame to have a task in which {}.", "unknown-word"),
    ("{}, grandpa twirls it.", "unknown-word"),
    ("{}, it dangles over my mat.", "unknown-word"),
    ("{}, which my wife will turn.", "misplaced-word"),
    ("{}, my wife hates green.", "unknown-word"),
    ("{}. The client likes it askewly.", "unknown-word"),
    ("{}. This tests whether green is on yellow.", "unknown-word"),
    ("{} or my wife will take the green one.", "misplaced-word"),
)


@pytest.mark.parametrize("talk", (*LEADS, *BEHIND))
def test_talk_is_left_out(talk: str) -> None:
    assert means(talk.format(ASKED)) == means(f"{ASKED}.")


@pytest.mark.parametrize("text", COMMANDS)
def test_who_asks_for_it_and_what_for_is_left_out(text: str) -> None:
    assert means(text) == means(f"{ASKED}.")


@pytest.mark.parametrize(("talk", "code"), REFUSED)
def test_what_may_be_of_blocks_is_kept(talk: str, code: str) -> None:
    assert code_of(talk.format("put the red block on the blue block")) == code


def test_all_clauses_of_talk_are_left_out() -> None:
    told = "Put red on blue, it soothes my toddler. Put green on yellow, grandpa swears by it."
    assert means(told) == means("Put red on blue. Put green on yellow.")


def test_a_liking_is_kept_unless_all_of_it_is_told() -> None:
    row, liking = "4 blocks in a row", "my gripper hates tight gaps"
    assert means(f"{row} with 4 cm of space between each, {liking}") == means(f"{row} with 4 cm of space between each")
    assert code_of(f"{row}, {liking}") == "unknown-word"


def test_for_instance_is_as_good_as_for_short() -> None:
    told = "separate vowels and consonants into two groups, {} with the letters A, E, K, P"
    assert means(told.format("for instance")) == means(told.format("e.g."))
