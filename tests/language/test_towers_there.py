"""Towers that are there before an order, told part by part: how they begin is what is told, in whatever sentence, and
what is ordered is all that is asked for."""

from __future__ import annotations

from itertools import product
from random import Random

from tests.corpus.entries import Entry, entry
from tests.corpus.judge import judge
from tests.corpus.run import read

SAMPLE = 120
"""Sentences, drawn from all there are."""
READ = 0.95
"""At least so many of them are read."""
THERE = (
    "There is a tower", "We have a tower", "A tower stands on the table", "You see a tower", "Here is a tower",
    "On the table there is a tower", "There is a tower of three blocks", "At the start there is a tower",
    "Initially there is a stack",
)  # fmt: skip
TOLD = (
    ", {a} at the bottom, {b} in the middle, {c} on top.", " with {a} at the bottom, {b} in the middle and {c} on top.",
    ": {a} at the bottom, {b} above it, {c} on top.", ". {A} is at the bottom, {b} in the middle and {c} on top.",
    ", with {a} at the bottom, {b} on that and {c} on top.", ", {a} lowest, then {b}, then {c}.",
    ". The bottom one is {a}, the middle one {b} and the top one {c}.", ". From bottom to top it is {a}, {b}, {c}.",
    ". The {a} block is at the bottom, the {b} one in the middle, the {c} one on top.",
    ". Its bottom block is {a}, its middle block {b} and its top block {c}.",
    ". At the bottom is {a}, in the middle {b}, on top {c}.",
    ". It has {a} at the bottom, {b} in the middle and {c} on top.",
)  # fmt: skip
ORDERS = (
    ("Put the green block next to it.", "green", "{up} green", "{a}; {b}; {c}; green"),
    ("Put the green block on top of it.", "green", "{up}^green", "{up}; green"),
    ("Take the {c} block off and put it on the table.", "", "{a}^{b}; {c}", "{up}"),
    ("Move the {c} block to the table.", "", "{a}^{b}; {c}", "{up}"),
    ("Turn it upside down.", "", "{down}", "{up}"),
    ("Reverse its order.", "", "{down}", "{up}"),
    ("Now put the {c} block on the green mat.", "green_patch", "{a}^{b}; {c} at=green_patch", "{up}"),
    ("Take it apart.", "", "{a}; {b}; {c}", "{up}"),
)
"""What is ordered, what there is besides, and how it is and is not in the end."""


def tower(there: str, told: str, order: tuple[str, str, str, str], colors: list[str]) -> Entry:
    a, b, c = colors
    words = {"a": a, "b": b, "c": c, "A": a.capitalize(), "up": f"{a}^{b}^{c}", "down": f"{c}^{b}^{a}"}
    said, extra, hold, miss = (part.format(**words) for part in order)
    beside = f"; {extra}" if extra == "green" else ""
    data = {
        "assets": dict.fromkeys([a, b, c, *([extra] if extra else [])], 1),
        "start": [words["up"] + beside],
        "start_miss": [words["down"] + beside, f"{a}; {b}; {c}{beside}"],
        "hold": [hold],
        "miss": [miss],
    }
    return entry("told", "towers", f"{there}{told.format(**words)} {said}", data)


def test_towers_that_are_there_begin_as_they_are_told() -> None:
    drawn = Random(7)
    chosen = drawn.sample(list(product(THERE, TOLD, ORDERS)), SAMPLE)
    scores = [judge(tower(*x, drawn.sample(["red", "white", "blue", "black"], 3)), read) for x in chosen]
    wrong = [(score.entry.text, score.why) for score in scores if score.outcome in ("wrong", "crash")]
    assert not wrong
    assert sum(score.outcome == "right" for score in scores) >= READ * SAMPLE
