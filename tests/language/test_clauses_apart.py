"""Clauses that are read in a sentence of their own, or with the sentence before them, where the text makes no sense as
it stands."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.language.clauses_apart import clauses_apart
from rpg.language.tokens import tokenize
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Red, blue and green: only the red one belongs on the white patch.",
         {"assets": {"red": 1, "blue": 1, "green": 1, "white_patch": 1}, "hold": ["red at=white_patch ; blue ; green"],
          "miss": ["red . blue at=white_patch ; green", "red ; blue ; green"]}),
        ("Red is on green, green is on blue. Remove green from the tower, so that red is directly on blue.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "start": ["blue^green^red"],
          "hold": [["blue^green^red", "blue^red ; green"]], "miss": [["blue^green^red", "blue ; red ; green"]]}),
        ("Line up a red, a green and a blue block. The green one is neither first nor last.",
         {"assets": {"red": 1, "blue": 1, "green": 1}, "hold": ["red green blue", "blue green red"],
          "miss": ["green red blue", "red blue green"]}),
        ("Put the pink block next to the brown one. But don't let them touch.",
         {"assets": {"pink": 1, "brown": 1}, "hold": ["pink brown pitch=1.5"], "miss": ["pink brown pitch=1"]}),
        ("There are two white blocks and a black one. All of them go on the yellow patch. Except the black one.",
         {"assets": {"white": 2, "black": 1, "yellow_patch": 1}, "hold": ["white . white at=yellow_patch ; black"],
          "miss": ["white . white . black at=yellow_patch", "white at=yellow_patch ; white ; black"]}),
        ("I would like to see the letter T made of five cubes, all of purple colour.", {"assets": {"purple": 5}}),
    ],
)  # fmt: skip
def test_clauses_told_apart(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "one block on each mat: two mats and three brown blocks",
        "Put the gray block on the cyan one. No, the white block.",
        "There are a red, a green and a blue patch. Each of them gets two of the six white blocks.",
        "Put red on the mat. Except blue.",
    ],
)
def test_what_makes_no_more_sense_apart_is_refused(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None


def test_nothing_is_lost_but_what_joins_them() -> None:
    said, _ = tokenize("Stack A on B, with the red one on the left, and all of it on the mat: the white one.")
    words = {token.word for token in said} - {",", ".", ":", "with", "and"}
    parted = [{token.word for token in way} for way in clauses_apart(said)]
    assert len(parted) == 3
    assert all(words <= way for way in parted)
