"""Second lists, questions, places and numbers that were lost on the way from a sentence to its task: they are in the
task, or are asked about."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means


@pytest.mark.parametrize(
    ("text", "code"),
    [
        # two orders of the same blocks
        ("Row: red, blue. The colours should go blue, red.", "order-conflict"),
        ("A row: red, blue, in the order blue, red.", "order-conflict"),
        ("Row: A, B, C. It should read B, C, A.", "order-conflict"),
        ("Tower: red, blue. From the bottom: blue, red.", "order-conflict"),
        ("Put red, green and blue in a row, in this order. From left to right: blue, red, green.", "order-conflict"),
        ("Put A, B, C in a row in alphabetical order. The order should be C, A, B.", "order-conflict"),
        # one block of several, and what it lies on
        ("There are three red blocks; one of them is on the mat. Put the other two next to it.", "ambiguous"),
        ("There are two blue blocks; one of them is on a mat. Put the other one beside it.", "ambiguous"),
        # what else is in a line
        ("A tower with at least two red blocks", "ambiguous"),
        ("There are three red and two blue blocks. Build a row with at least two red blocks.", "ambiguous"),
        ("A tower of red, blue and green with a white block between red and blue", "ambiguous"),
        ("A row of red, blue and green, a white block between red and blue", "ambiguous"),
        ("A tower of three red blocks with one on top of it", "ambiguous"),
        ("A tower of three blocks, two of which are red", "ambiguous"),
        ("A wall of six blocks, two of which are red", "ambiguous"),
        ("A red row of three blue blocks", "contradiction"),
        ("Make a little red row of a red, a green and a blue block", "contradiction"),
        # what nothing could come of
        ("Leave the white one alone on the mat", "misplaced"),
        ("Leave only the white block on the mat", "misplaced"),
        ("Spell CAT, not quite.", "incomplete"),
        ("Build a tower of red and blue. Spell CAT, not really.", "incomplete"),
        ("A sum: 3 = red", "misplaced"),
        ("Sum: 3 + 2 = blue", "misplaced"),
        ("an ascending pyramid", "ambiguous"),
        ("A wall in increasing order", "ambiguous"),
        ("Three blocks and a mat, all blue. Put them on the mat.", "ambiguous"),
        # questions
        ("Could it be that red is on blue", "no-goal"),
        ("Might it be the case that red is on blue?", "no-goal"),
        ("Do you see red on blue?", "no-goal"),
        ("Could red and blue have been in a row?", "no-goal"),
        # layers of a pyramid
        ("A pyramid with three blocks at the bottom and one on top of it", "ambiguous"),
        ("A pyramid with a 3x3 base and one on top of it", "ambiguous"),
        ("A pyramid of three red blocks and one on top of it", "self-reference"),
        # lists in figures that are read from another side than a page
        ("2x2 grid from right to left: red, blue, green, white", "misplaced"),
        ("A 3x3 grid of the numbers 1 to 9 from right to left", "misplaced"),
        # ends of no line
        ("Red is at the left end, blue at the right end.", "ambiguous"),
        ("A row of red, blue and green, from above", "incomplete"),
        ("Align x: red, green, blue", "misplaced-word"),
    ],
)
def test_what_would_be_lost_is_asked_about(text: str, code: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is None
    assert [d.code for d in diagnostics if d.severity == "error"] == [code]


FOUR = {"assets": {"red": 1, "blue": 1, "green": 1, "white": 1}, "hold": ["red blue | green white"],
        "miss": ["red green | blue white", "green white | red blue", "blue red | white green"]}  # fmt: skip
ANY = {**FOUR, "hold": [*FOUR["hold"], *FOUR["miss"]], "miss": []}
FIVE = {"assets": {"red": 1, "blue": 1, "green": 3}, "hold": ["red green green green blue"],
        "miss": ["blue green green green red", "red green^green green blue", "red blue green green green"]}  # fmt: skip
DOWN = {"assets": {"red": 1, "blue": 1, "green": 1}, "hold": ["green^blue^red"],
        "miss": ["red^blue^green", "blue^green^red"]}  # fmt: skip
TAPERED = {
    "assets": {"red": 1, "blue": 2, "green": 3},
    "hold": ["side . . red . . | . blue . blue . | green . green . green pitch=0.55,1"],
    "miss": ["side . . green . . | . blue . blue . | green . red . green pitch=0.55,1"],
}


IN_STEPS = {"assets": {"red": 1, "blue": 1, "green": 1},
            "hold": [["red blue green", "blue^red green", "blue^red^green"]],
            "miss": [["red blue green", "red^green blue", "blue^red^green"]]}  # fmt: skip
AT_ONCE = {**IN_STEPS, "hold": ["blue^red^green"], "miss": ["blue^green^red"]}


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("The sequence is: (1) red on blue, (2) green on red.", IN_STEPS),
        ("The sequence is: (1) Put red on blue. (2) Put green on red.", IN_STEPS),
        ("(1) Put red on blue, (2) put green on red.", IN_STEPS),
        ("Order: red on blue, green on red.", IN_STEPS),
        ("Steps: 1) red on blue 2) green on red", IN_STEPS),
        ("Requirements: (1) red is on blue, (2) green is on red.", AT_ONCE),
        ("2x2 grid: red, blue, green, white", FOUR),
        ("2x2 grid: red blue green white, please", FOUR),
        ("2x2 grid: red, blue; green, white", FOUR),
        ("A two by two grid: a red, a blue, a green and a white block", FOUR),
        ("A grid of 2 rows and 2 columns: red, blue, green and white.", FOUR),
        ("2x2 square: red, blue, green, white", FOUR),
        ("2x2 grid: red, blue, green, white, in any order", ANY),
        ("2x2 grid from these blocks: red, blue, green, white", ANY),
        ("2x2 grid: 2 red, 2 blue",
         {"assets": {"red": 2, "blue": 2}, "hold": ["red blue | blue red"], "miss": []}),
        ("2x2 wall: red, blue, green, white",
         {**FOUR, "hold": ["green^red white^blue pitch=1"], "miss": ["red^green blue^white pitch=1"]}),
        ("2x2 wall from bottom to top: red, blue, green, white",
         {**FOUR, "hold": ["red^green blue^white pitch=1"], "miss": ["green^red white^blue pitch=1"]}),
        ("A 2x2 grid on the mat: red, blue, green, white",
         {"assets": {**FOUR["assets"], "patch": 1}, "hold": ["red blue | green white pitch=1 at=patch"],
          "miss": ["red green | blue white pitch=1 at=patch"]}),
        ("2x2 grid: red, blue, green, white. Their order is not important.", ANY),
        ("A line: red, blue, green. The order is of no importance.",
         {"assets": DOWN["assets"], "hold": ["red blue green", "green red blue"], "miss": ["red^blue green"]}),
        ("On the left end a red block, on the right end a blue one, three greens between them", FIVE),
        ("A red block on the left end, a blue one on the right end, three green ones between them.", FIVE),
        ("Put a red block on the left end and a blue one on the right end, with three greens between them", FIVE),
        ("A tower from above: red, blue, green", DOWN),
        ("From above, the tower is red, blue, green", DOWN),
        ("Row: red, blue, green. From right to left: green, blue, red.",
         {"assets": DOWN["assets"], "hold": ["red blue green"], "miss": ["green blue red"]}),
        ("A circle: red, blue, green, white",
         {"assets": FOUR["assets"], "hold": ["red blue green white circle=1"],
          "miss": ["red blue | green . . . white"]}),
        ("Spell CAT, not DOG.", {"assets": {"C": 1, "A": 1, "T": 1}, "hold": ["C A T"], "miss": ["T A C"]}),
        ("May it be that red is on blue.",
         {"assets": {"red": 1, "blue": 1}, "hold": ["blue^red"], "miss": ["red^blue"]}),
        ("Red, blue and white are on the mat. Leave the white one alone there.",
         {"assets": {"red": 1, "blue": 1, "white": 1, "patch": 1}, "hold": ["white at=patch ; red ; blue"],
          "miss": ["white red pitch=1 at=patch ; blue"]}),
        ("take off the top block of the tower of three and put it beside the tower",
         {"assets": {"c1": 1, "c2": 1, "c3": 1}, "start": ["c1^c3^c2"], "hold": [["c1^c3^c2", "c1^c3 c2"]],
          "miss": [["c1^c3^c2", "c1 c3 c2"]]}),
    ],
)  # fmt: skip
def test_it_is_in_the_task(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize("way", ["from the top down", "going down", "top to bottom"])
def test_the_first_layer_counted_from_the_top_is_the_top_one(way: str) -> None:
    """None is assumed to be the lowest one then."""
    text = f"A pyramid of three layers, {way}: first layer red, second layer blue, third layer green"
    assert_means(text, TAPERED)
    schema, _ = BuiltinFrontEnd().read(text)
    assert schema is not None
    assert "the first layer is the lowest one" not in schema.assumptions
