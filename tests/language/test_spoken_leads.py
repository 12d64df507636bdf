"""Leads of any words in front of a task are left out; with what bends them more is said, and they are kept."""

from __future__ import annotations

import pytest

from rpg.blocks.english import describe
from rpg.passes.schema.frontend import BuiltinFrontEnd
from rpg.pipeline import prepared

STATE = "the red block is on the blue block"
PLAIN = "The red block must be on the blue block."
FIGURE = "a row of three red blocks"

OF_STATES = (
    "Parity benchmark: {}",
    "Orientation drill 12 - {}",
    "Grandpa's birthday surprise: {}",
    "Simple stacking: {}",
    "One thing at a time: {}",
    "I hope this is not too hard: {}",
    "Please help, I cannot reach: {}",
    "Reward 1 if {}, otherwise 0",
    "Give full marks when {} and zero marks otherwise",
    "Agent receives +1 when {}, 0 otherwise",
    "Under this protocol a trial passes if {}",
    "It would mean the world to me if {}",
    "Put simply, {}",
    "Not to be picky but {}",
    "Whatever happens, {}",
    "Soooo {}",
)
OF_FIGURES = (
    "My idea for the display is {}",
    "The completed design should be {}",
    "The design brief says {}",
    "For the big finish I'd like {}",
    "I bet you can't build {}",
    "Surprise me with {}",
    "Show off your skills with {}",
    "Let's go with {}",
    "Can you do me a solid and make {}",
    "The purpose of this task is to check whether the arm can build {}",
    "I am setting up a shop window and need {}",
    "I'm a bit tired so just do something easy like {}",
)
KEPT = (
    "Invariant: {}",
    "Forbidden: {}",
    "Beware: {}",
    "Prevent this: {}",
    "Rumor has it: {}",
    "A bad example: {}",
    "The opposite of this: {}",
    "Penalty 1 if {}",
    "Reward 0 if {}, otherwise 1",
    "Reward -1 if {}",
    "reward 1 if {}, otherwise 0.5",
    "Return False if {}",
    "Fail when {}",
    "I would be sad if {}",
    "Do this twice: {}",
    "I don't want this: {}",
    "Only when green is on the mat: {}",
    "I wonder if {}",
)
"""With these a state is no goal, or not the only one."""


@pytest.mark.parametrize("lead", OF_STATES)
def test_a_lead_of_a_state_is_left_out(lead: str) -> None:
    assert _goal(lead.format(STATE)) == _goal(PLAIN)


@pytest.mark.parametrize("lead", OF_FIGURES)
def test_a_lead_of_a_figure_is_left_out(lead: str) -> None:
    assert _goal(lead.format(FIGURE)) == _goal(f"Build {FIGURE}.")


@pytest.mark.parametrize("lead", KEPT)
def test_what_bends_a_state_is_kept(lead: str) -> None:
    assert BuiltinFrontEnd().read(lead.format("red is on blue"))[0] is None


@pytest.mark.parametrize(
    "text",
    [
        "The current state is a red block on a blue block, take it off",
        "My second idea is a tower of three",
        "In chessboard fashion, arrange four red and four blue blocks",
        "Make me a cake and put red on blue",
        "The kids are not allowed to touch red, put red on blue",
        "The answer is not red on blue",
        "Spell CAT in any order",
    ],
)
def test_what_tells_of_the_task_is_no_lead(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None


def test_either_of_two_behind_it_is() -> None:
    told = "Alright, it's either the green block on the red one or the red block on the green one, I don't mind which"
    assert _goal(told) == _goal("Either the green block must be on the red one or the red block on the green one.")


def test_who_loves_it_moves_nothing() -> None:
    told = "Move the yellow block next to the green one"
    assert _goal(f"{told}, he will love it") == _goal(told)


def _goal(text: str) -> str:
    task = BuiltinFrontEnd().read(text)[0]
    assert task is not None, text
    return describe(prepared(task))
