"""Sentences whose conditions have to be arranged together: what is read must also become a task."""

from __future__ import annotations

import pytest

from rpg.pipeline import CompileOptions, compile_instruction


@pytest.mark.parametrize(
    "text",
    [
        "put red on green without ever putting red in the left half",
        "Three green blocks touch each other",
        "Push the pink and the green cube together until they touch.",
        "Spell BED with the cubes touching",
        "Spell DOG with a gap of 8 cm between the letters",
        "Make 2 + 3 = 5 with the blocks touching",
        "a 2x2 grid of four red blocks with gaps of 2 cm",
        "A circle of eight blue blocks with gaps of 1 cm",
        "Two red and two blue blocks in a row, all touching, same colours together",
        "Make a row of red, white and blue, from left to right, but don't move the white one.",
        "Never move the black cube. Build a tower of three green cubes to the right of it.",
        "A B C in a row, left to right, B stays where it is",
        "Build a tower of red, green and blue without moving the green one",
        "Spell CAT without moving the A",
        "All towers the same height: take nine white blocks and make three towers.",
    ],
)
def test_arranged(text: str) -> None:
    outcome = compile_instruction(text, CompileOptions(paraphrases=0))
    assert outcome.status == "admitted", outcome.diagnostics
