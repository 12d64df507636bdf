"""Towers and rows that are there before an order, told part by part: how they begin is what is told, in whatever
sentence, and what is ordered is all that is asked for."""

from __future__ import annotations

from itertools import product
from random import Random
from typing import Any

import pytest

from tests.corpus.entries import Entry, entry
from tests.corpus.judge import judge
from tests.corpus.run import read

SAMPLE = 120
"""Sentences of each kind of line, drawn from all there are."""
READ = 0.95
"""At least so many of them are read."""
THERE = (
    "There is a {line}", "We have a {line}", "A {line} stands on the table", "You see a {line}", "Here is a {line}",
    "On the table there is a {line}", "There is a {line} of three blocks", "At the start there is a {line}",
    "Initially there is a {line}",
)  # fmt: skip
TOWERS = (
    ", {a} at the bottom, {b} in the middle, {c} on top.", " with {a} at the bottom, {b} in the middle and {c} on top.",
    ": {a} at the bottom, {b} above it, {c} on top.", ". {A} is at the bottom, {b} in the middle and {c} on top.",
    ", with {a} at the bottom, {b} on that and {c} on top.", ", {a} lowest, then {b}, then {c}.",
    ". The bottom one is {a}, the middle one {b} and the top one {c}.", ". From bottom to top it is {a}, {b}, {c}.",
    ". The {a} block is at the bottom, the {b} one in the middle, the {c} one on top.",
    ". Its bottom block is {a}, its middle block {b} and its top block {c}.",
    ". At the bottom is {a}, in the middle {b}, on top {c}.",
    ". It has {a} at the bottom, {b} in the middle and {c} on top.",
)  # fmt: skip
ROWS = (
    ", {a} on the left, {b} in the middle, {c} on the right.", ", from left to right {a}, {b} and {c}.",
    " with {a} on the left, {b} in the middle and {c} on the right.", ". From left to right it is {a}, {b}, {c}.",
    ": {a} on the left, {b} next to it, {c} on the right.",
    ". {A} is on the left, {b} in the middle and {c} on the right.",
    ". The {a} block is on the left, the {b} one in the middle, the {c} one on the right.",
    ". Its left block is {a}, its middle block {b} and its right block {c}.",
    ". The leftmost one is {a}, the middle one {b} and the rightmost one {c}.",
    ". On the left is {a}, in the middle {b}, on the right {c}.",
)  # fmt: skip
Order = tuple[str, str, Any, Any]
"""What is ordered, what there is besides, and how it is and is not in the end, at all times if these are several."""
OF_TOWERS: tuple[Order, ...] = (
    ("Put the green block next to it.", "green", "{all} green", "{a}; {b}; {c}; green"),
    ("Put the green block on top of it.", "green", "{all}^green", "{all}; green"),
    ("Take the {c} block off and put it on the table.", "", "{a}^{b}; {c}", "{all}"),
    ("Move the {c} block to the table.", "", "{a}^{b}; {c}", "{all}"),
    ("Turn it upside down.", "", "{turned}", "{all}"),
    ("Reverse its order.", "", "{turned}", "{all}"),
    ("Now put the {c} block on the green mat.", "green_patch", "{a}^{b}; {c} at=green_patch", "{all}"),
    ("Take it apart.", "", "{a}; {b}; {c}", "{all}"),
)
OF_ROWS: tuple[Order, ...] = (
    ("Put the green block on the middle one.", "green", "{a} {b}^green {c}", "{a}^green {b} {c}"),
    ("Put the green block on the leftmost one.", "green", "{a}^green {b} {c}", "{a} {b} {c}^green"),
    ("Put the {c} block on the {a} one.", "", "{a}^{c}; {b}", "{c}^{a}; {b}"),
    ("Reverse the row.", "", "{turned}", "{all}"),
    ("Swap the two outer blocks.", "", ["{all}", "{turned}"], ["{all}", "{b} {a} {c}"]),
    ("Swap the {a} block and the {b} block.", "", ["{all}", "{b} {a} {c}"], ["{all}", "{turned}"]),
    ("Stack them with {a} at the bottom and {c} on top.", "", "{a}^{b}^{c}", "{c}^{b}^{a}"),
    ("Move the {b} block to the left end.", "", "{b} {a} {c}", "{a} {c} {b}"),
    ("Move the middle block to the right end.", "", "{a} {c} {b}", "{b} {a} {c}"),
    ("Put the green block to the right of it.", "green", "{a} {b} {c} green", "green {a} {b} {c}"),
    ("Take the middle block and put it on the green mat.", "green_patch", "{a} . {c}; {b} at=green_patch", "{all}"),
    ("Make a tower of them.", "", "{a}^{b}^{c}", "{all}"),
)


def line(joint: str, said: str, order: Order, colors: list[str]) -> Entry:
    a, b, c = colors
    words = {"a": a, "b": b, "c": c, "A": a.capitalize(), "all": joint.join(colors), "turned": joint.join(colors[::-1])}
    command, extra, hold, miss = order
    beside = f"; {extra}" if extra == "green" else ""
    data = {
        "assets": dict.fromkeys([a, b, c, *([extra] if extra else [])], 1),
        "start": [words["all"] + beside],
        "start_miss": [words["turned"] + beside, f"{a}; {b}; {c}{beside}"],
        "hold": [hold.format(**words) if isinstance(hold, str) else [x.format(**words) for x in hold]],
        "miss": [miss.format(**words) if isinstance(miss, str) else [x.format(**words) for x in miss]],
    }
    return entry("told", "lines", f"{said} {command}".format(**words), data)


@pytest.mark.parametrize(
    ("kind", "joint", "told", "orders"), [("tower", "^", TOWERS, OF_TOWERS), ("row", " ", ROWS, OF_ROWS)]
)
def test_a_line_that_is_there_begins_as_it_is_told(
    kind: str, joint: str, told: tuple[str, ...], orders: tuple[Order, ...]
) -> None:
    drawn = Random(7)
    scores = []
    for there, parts, order in drawn.sample(list(product(THERE, told, orders)), SAMPLE):
        colors = drawn.sample(["red", "white", "blue", "black"], 3)
        scores.append(judge(line(joint, there.replace("{line}", kind) + parts, order, colors), read))
    wrong = [(score.entry.text, score.why) for score in scores if score.outcome in ("wrong", "crash")]
    assert not wrong
    assert sum(score.outcome == "right" for score in scores) >= READ * SAMPLE
