"""What is told of the start and what comes after it, and steps one after the other, put together of parts: the start
has to be as it is told, and of all orders of the steps just the one that is said has to be right."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from random import Random
from typing import Any

from tests.corpus.entries import entry
from tests.corpus.judge import judge
from tests.corpus.run import read

SAMPLE = 120
"""Sentences of each kind, drawn from all there are."""
READ = 0.9
"""At least so many of them are read."""
Told = tuple[str, dict[str, Any]]

BEGUN = (
    "{block} starts {here}.", "{block} is {here} at first.", "At the start {block} is {here}.",
    "Currently {block} is {here}.", "{block} is lying {here}.", "To begin with, {block} is {here}.",
    "There is a red block {here}.", "{block} sits {here}.", "In the beginning, {block} lies {here}.",
    "You will find {block} {here}.", "{block} is {here} now.", "{block} starts out {here}.",
    "The episode starts with {block} {here}.", "{block} rests {here} to begin with.",
)  # fmt: skip
MOVED = (
    "Put it {there}.", "Take it and put it {there}.", "It should end up {there}.", "It must be {there} at the end.",
    "I want it {there}.", "It belongs {there}.", "Pick it up and place it {there}.", "At the end it is {there}.",
    "Now put it {there}.", "Then put {block} {there}.", "{block} should be {there} instead.", "Put {block} {there}.",
    "In the end {block} has to be {there}.", "Goal: {block} is {there}.", "Can you put {block} {there}?",
)  # fmt: skip
PLACES = {"on the blue block": ("blue^red", "blue", "blue"), "on the green block": ("green^red", "green", "green"),
          "on the yellow patch": ("red at=yellow_patch", "", "yellow_patch")}  # fmt: skip
"""Where a block is: the picture of it, the picture of the place without it, and what it takes."""
STEPS = (
    "First {a}, then {b}", "{a}, then {b}", "{a}. After that, {b}", "{b} after {doing_a}", "{b} once {a_done}",
    "Once {a_done}, {b}", "Only when {a_done} may {B} go on {b_place}", "Before {doing_b}, {a}", "{a} before {doing_b}",
    "{b}, but first {a}", "{b}, but only after {a_done}", "Start by {doing_a}, then {b}", "{a}. Only then {b}",
    "{a}. Once that is done, {b}", "Step 1: {a}. Step 2: {b}", "{a} and {b}, in that order", "In this order: {a}; {b}",
    "Wait until {a_done}, then {b}", "Do not {b} until {a_done}", "{b} as soon as {a_done}", "{a}, and at the end {b}",
    "Do the following in this order: {a}, {b}", "The first thing to do is to {a}, the second is to {b}",
    "{B} must not be put on {b_place} before {a_done}", "{a} first and {b} second", "{b}, having first {a}",
)  # fmt: skip
PAIRS = (("red", "blue", "green", "yellow"), ("A", "B", "C", "D"), ("red", "blue", "green", "red"))
"""Which block goes on which first, and which on which next."""


def capital(text: str) -> str:
    return text[0].upper() + text[1:]


def started() -> Iterator[Told]:
    """ "The red block sits on the blue one. At the end it is on the mat."."""
    for block, begun, moved in product(("red", "the red block"), BEGUN, MOVED):
        for here, there in product(PLACES, PLACES):
            if here == there:
                continue
            parts = [capital(part.format(block=block, here=here, there=there)) for part in (begun, moved)]
            (was, left, one), (is_, free, other) = PLACES[here], PLACES[there]
            first, last = (" ; ".join(x for x in pair if x) for pair in ((was, free), (left, is_)))
            yield " ".join(parts), {"assets": {"red": 1, one: 1, other: 1}, "start": [first], "start_miss": [last],
                                    "hold": [[first, last]], "miss": [[first, first]]}  # fmt: skip


def in_steps() -> Iterator[Told]:
    """ "Put green on yellow as soon as red is on blue"."""
    for (one, below, two, under), frame in product(PAIRS, STEPS):
        names = [name if len(name) == 1 else f"the {name} block" for name in (one, below, two, under)]
        put = [f"put {names[n]} on {names[n + 1]}" for n in (0, 2)]
        doing = [text.replace("put", "putting", 1) for text in put]
        words = {"a": put[0], "b": put[1], "doing_a": doing[0], "doing_b": doing[1], "B": names[2]}
        said = frame.format(**words, b_place=names[3], a_done=f"{names[0]} is on {names[1]}")
        chained = under == one
        lone = " ; ".join(dict.fromkeys((one, below, two, under)))
        after = f"{below}^{one} ; {two}" if chained else f"{below}^{one} ; {two} ; {under}"
        wrong = f"{under}^{two} ; {below}" if chained else f"{one} ; {below} ; {under}^{two}"
        both = f"{below}^{one}^{two}" if chained else f"{below}^{one} ; {under}^{two}"
        yield f"{capital(said)}.", {"assets": dict.fromkeys((one, below, two, under), 1), "hold": [[lone, after, both]],
                                    "miss": [[lone, wrong, both], [lone, after], [lone, after, lone]]}  # fmt: skip


def outcomes(told: list[Told]) -> list[str]:
    found: list[str] = []
    for said, meant in Random(0).sample(told, min(SAMPLE, len(told))):
        score = judge(entry("times", "told", said, meant), read)
        assert score.outcome in ("right", "refused"), (said, score.why)
        found.append(score.outcome)
    return found


def test_the_start_is_as_it_is_told_and_not_the_end() -> None:
    found = outcomes([*started()])
    assert found.count("right") >= READ * len(found)


def test_steps_follow_in_the_order_that_is_said() -> None:
    found = outcomes([*in_steps()])
    assert found.count("right") >= READ * len(found)


def test_what_is_kept_beside_what_is_denied_need_not_be_so_at_the_start() -> None:
    for without in (
        "without touching it",
        "but the two must not touch",
        "and not touching it",
        "without them touching",
    ):
        said = f"Keep red to the left of blue {without}."
        meant = {
            "assets": {"red": 1, "blue": 1},
            "hold": [["blue ; red", "red . blue"]],
            "miss": [["blue ; red", "red blue pitch=1"]],
        }
        score = judge(entry("times", "kept", said, meant), read)
        assert score.outcome == "right", (said, score.why)
