"""Talk around an instruction: what asks for nothing is left out, and nothing else."""

from __future__ import annotations

import pytest

from rpg.language.formulas import formulas_told
from rpg.language.remarks import without_remarks
from rpg.language.tokens import Token, tokenize
from rpg.passes.schema.frontend import BuiltinFrontEnd

ASKED = "put the red block on the blue one"

LEFT_OUT = (
    # of their own
    "My little brother has his birthday. {}",
    "The train leaves at nine, no rush. {}",
    "It is raining outside. {}",
    "You look strong today! {}",
    "Let us get cracking! {}",
    "{}. If it works I owe you a beer.",
    "{}. We bought them at the flea market.",
    "{}. Love from all of us.",
    # whom it is said to, and how it is asked for
    "good morning dear machine {}",
    "Greetings, earthling, {}",
    "Would you do me a huge favor and {}",
    "It would make my day if you could {}",
    "What we would like you to do is {}",
    "The only thing left for you to do is to {}",
    # settings
    "As part of the demonstration, {}",
    "On behalf of the whole class, {}",
    "According to the manual you should {}",
    "Using your arm, {}",
    # behind a task
    "{} because my back hurts",
    "{} so that my sister has something to laugh about",
    "{} so we do not miss the bus",
    "{} to calibrate the camera",
    "{} for educational purposes",
    "{} while I make a cup of tea",
    "{} until my wife is home",
    "{} if that is not too much trouble",
    "{} unless you are too busy",
    "{} after you have had your coffee",
    "{} with your magic hands",
    "{}, nice and gently, so that nothing falls down",
    "{}, or I will be sad",
)


@pytest.mark.parametrize("talk", LEFT_OUT)
def test_what_asks_for_nothing_is_left_out(talk: str) -> None:
    assert _rest(talk.format(ASKED)).strip(" .") == ASKED


LED_IN = (
    ("The client has requested that {}", "the red block is on the blue one"),
    ("The contract stipulates that {}", "the red block is on the blue one"),
    ("We pass if {}", "the red block is on the blue one"),
    ("The result is accepted as soon as {}", "the red block is on the blue one"),
    ("On the cover of the book there is {}", "a tower of three red blocks"),
    ("The brochure has a photo of {}", "a tower of three red blocks"),
    ("What I need for my lesson is {}", "a tower of three red blocks"),
    ("The kids would love to see {}", "a tower of three red blocks"),
)


@pytest.mark.parametrize(("lead", "wanted"), LED_IN)
def test_what_leads_to_how_it_has_to_be_is_left_out(lead: str, wanted: str) -> None:
    assert _rest(lead.format(wanted)) == wanted


KEPT = (
    # wishes, and what takes them back
    ("{}. Time to swap them!", "swap"),
    ("{}. Let us make it taller!", "taller"),
    ("{}. The children get one each.", "children"),
    ("{}. My wife wants a heart.", "heart"),
    ("{}. My daughter loves symmetry.", "symmetry"),
    ("{}. I was just joking.", "joking"),
    ("{}. My mother changed her mind.", "changed"),
    ("{}. You are not allowed to move the others.", "allowed"),
    ("{}. We do it in reverse today.", "reverse"),
    ("{}. One of them must be yellow.", "yellow"),
    ("{}, one to its right", "right"),
    ("{}, a doll and my phone", "doll"),
    # what would follow for blocks
    ("{} because red must be on top", "top"),
    ("{} so that the green one is free", "free"),
    ("{} so that I can read it from the window", "read"),
    ("{} so I can not see it", "see"),
    ("{} so it leans to the left", "leans"),
    ("{} to match the picture on my desk", "match"),
    ("{} to protect the small one", "protect"),
    ("{} for the red team", "team"),
    ("{} while the others stay put", "others"),
    ("{} until it falls", "until"),
    ("{} if it is red", "if"),
    ("{} when the bell rings", "bell"),
    ("{} once the green block is gone", "once"),
    # lead-ins that deny, or tell of another time
    ("It would be a pity to {}", "pity"),
    ("Nobody wants you to {}", "nobody"),
    ("I stopped asking you to {}", "stopped"),
    ("Yesterday I asked you to {}", "yesterday"),
    ("Without your arm, {}", "without"),
    ("At the beginning of the lesson, {}", "beginning"),
    ("We fail if {}", "fail"),
    ("It is a shame that {}", "shame"),
    ("The opening shot shows {}", "opening"),
    ("My wife will take the other one", "wife"),
    ("The photographer will stand on the left", "photographer"),
    ("{}. My son counts from the right.", "counts"),
)


@pytest.mark.parametrize(("text", "word"), KEPT)
def test_what_may_ask_for_something_is_kept(text: str, word: str) -> None:
    assert word in _rest(text.format(ASKED)).lower().split()


def test_a_picture_is_no_wish_where_more_is_told() -> None:
    told = "The picture shows a tower of red blocks. Take the top block down."
    assert _rest(told).startswith("The picture shows")


def test_a_heading_behind_the_start_is_kept() -> None:
    told = "Setup: red on blue. Goal: green next to blue."
    assert "Goal :" in _rest(told)


@pytest.mark.parametrize("lead", ["All the kids want {}", "Everybody needs {}", "I had {}", "The old photo shows {}"])
def test_what_may_be_one_each_or_gone_is_kept(lead: str) -> None:
    told = lead.format("a tower of three red blocks")
    assert _rest(told) == told


def test_a_question_behind_a_task_is_no_place() -> None:
    plain, asked = (BuiltinFrontEnd().read(f"{ASKED}{end}")[0] for end in (".", ", right?"))
    assert plain is not None and asked is not None
    assert asked.goal == plain.goal


def _rest(text: str) -> str:
    """The words of a text that are not left out, or all of them."""
    tokens = formulas_told(*tokenize(text))[0]
    plain = without_remarks(tokens)
    return _said(plain[0] if plain is not None else tokens)


def _said(tokens: list[Token]) -> str:
    return " ".join(token.raw for token in tokens)
