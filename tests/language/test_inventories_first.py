"""Inventories told first, put together of what says that there is something, a list of it, and what is asked of it: the
task has the blocks and mats of the list, no others, and the goal that the rest tells."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from random import Random
from typing import Any

from tests.corpus.entries import entry
from tests.corpus.judge import judge
from tests.corpus.run import read

SAMPLE = 150
"""Sentences, drawn from all there are."""
READ = 0.95
"""At least so many of them are read."""
LISTS = ("{L} are on the table", "{L} lie on the table", "On the table lie {L}", "There are {L} on the table",
         "There are {L}", "We have {L}", "You see {L}", "The table holds {L}", "The scene contains {L}",
         "{L} are given", "Given are {L}", "Here are {L}", "The table has {L} on it", "There are only {L}",
         "There is nothing on the table except {L}", "The following are on the table: {L}", "Imagine {L} on a table",
         "There is a table with {L} on it", "The robot has {L}", "In front of the robot are {L}")  # fmt: skip
TOTALS = ("{T} are on the table: {C}", "There are {T}: {C}", "There are {T} on the table, {C}", "{T} ({C}) are given",
          "{T}, {C}, are on the table", "{T} lie on the table, {C}", "The table has {T} on it: {C}",
          "The scene contains {T}: {C}", "{T} are on the table, namely {C}")  # fmt: skip
Told = tuple[str, dict[str, Any]]
"""A text, and what it means."""


def told(lists: tuple[str, ...], totals: tuple[tuple[str, str], ...], means: dict[str, Any]) -> Iterator[Told]:
    """All inventories of the same things with what is asked of them."""
    stock = [frame.format(L=one) for frame, one in product(LISTS, lists)]
    stock += [frame.format(T=total, C=parts) for frame, (total, parts) in product(TOTALS, totals)]
    for there, (asked, (hold, miss)) in product(stock, means["asked"].items()):
        yield f"{there[0].upper()}{there[1:]}. {asked}.", {"assets": means["assets"], "hold": hold, "miss": miss}


def inventories() -> Iterator[Told]:
    yield from told(
        ("three green blocks and two purple blocks", "three green and two purple blocks"),
        (("five blocks", "three green and two purple"), ("five blocks", "three of them green and two of them purple"),
         ("five blocks", "three green ones and two purple ones")),
        {"assets": {"green": 3, "purple": 2}, "asked": {
            "Stack all five so that the colours alternate":
                (["green^purple^green^purple^green"], ["green^green^green^purple^purple", "purple^green^purple^green"]),
            "They should be stacked by colour into two towers":
                (["green^green^green ; purple^purple"], ["green^green^green^purple^purple", "green^purple^green"]),
            "Every green block should be to the left of every purple one":
                (["green green green purple purple"], ["green purple green green purple"]),
        }},
    )  # fmt: skip
    yield from told(
        ("three letter blocks, A, B and C, and two digit blocks, 1 and 2,",
         "the letters A, B and C and the digits 1 and 2", "blocks with the letters A, B and C and the digits 1 and 2"),
        (("five blocks", "A, B, C, 1 and 2"),),
        {"assets": {"A": 1, "B": 1, "C": 1, "1": 1, "2": 1}, "asked": {
            "The letters should be in one group and the digits in another":
                (["A B C ; 1 2"], ["A B 1 ; C 2", "A B C 1 2"]),
            "Stack the letters in alphabetical order from bottom to top": (["A^B^C"], ["C^B^A", "A^B"]),
        }},
    )  # fmt: skip
    yield from told(
        ("three green blocks, a red mat and a blue mat", "two mats, a red and a blue one, and three green blocks",
         "a red and a blue mat together with three green blocks"),
        (),
        {"assets": {"green": 3, "red_patch": 1, "blue_patch": 1}, "asked": {
            "Two of the blocks should be on the red mat and the third one on the blue mat":
                (["green green at=red_patch ; green at=blue_patch"],
                 ["green at=red_patch ; green green at=blue_patch", "green green at=red_patch ; green"]),
            "Each mat should have a block on it":
                (["green at=red_patch ; green at=blue_patch ; green"], ["green at=red_patch ; green ; green"]),
        }},
    )  # fmt: skip


def test_what_is_listed_is_there_and_no_more() -> None:
    texts = sorted(dict(inventories()).items())
    outcomes = []
    for text, means in Random(0).sample(texts, SAMPLE):
        score = judge(entry("inventories", "first", text, {"say": [text], **means}), read)
        assert score.outcome in ("right", "refused"), (text, score.why)
        outcomes.append(score.outcome)
    assert outcomes.count("right") >= READ * SAMPLE


def test_what_is_not_listed_is_not_there() -> None:
    lists = ("three green blocks and two purple blocks", "a green block, a purple block and a white mat")
    for frame, one in product(LISTS, lists):
        text = f"{frame.format(L=one)}. The red block should be on a purple one."
        score = judge(entry("inventories", "first", text, {"say": [text], "refuse": True}), read)
        assert score.outcome == "right", text
