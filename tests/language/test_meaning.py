"""What instructions mean, phenomenon by phenomenon: the goal in one compact line, or the code of the refusal."""

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from rpg.passes.schema.sketch import sketch

RELATIONS = {
    "put the red block on the blue block": "on(red_block, blue_block)",
    "please stack crimson cube atop the navy one": "on(red_block, blue_block)",
    "the red block should be directly under the blue block": "on(blue_block, red_block)",
    "could you place the red block to the left of the blue block?": "left_of(red_block, blue_block)",
    "red right of blue": "right_of(red_block, blue_block)",
    "put red next to blue": "beside(red_block, blue_block)",
    "put the red block between the blue block and the green block": "between(red_block, blue_block, green_block)",
    "put red and blue 12 cm apart": "distance(red_block, blue_block; minimum=0.11, maximum=0.13)",
    "put the red block to the left or behind the blue block": (
        "left_of(red_block, blue_block) or behind(red_block, blue_block)"
    ),
    "stack the green block on the yellow block beside the red block": (
        "on(green_block, yellow_block) and beside(yellow_block, red_block)"
    ),
    "the red block must not touch the blue block": "not touching(red_block, blue_block)",
    "leave a gap of 6 cm between the red and the green block": (
        "distance(red_block, green_block; minimum=0.05, maximum=0.07, measure=faces)"
    ),
}
STRUCTURES = {
    "build a tower of three green blocks": "stack(green_block_1 green_block_2 green_block_3; exact=True)",
    "a tower with red at the bottom and blue on top": (
        "stack(red_block blue_block; order=[given ranks=red_block blue_block first=bottom], exact=True)"
    ),
    "make a 2x2 square of red blocks": "grid(red_block_1 red_block_2 red_block_3 red_block_4, 2, 2)",
    "line up A, B and C in alphabetical order": (
        "row(A_block B_block C_block; axis=y, order=[label first=left], readable=True)"
    ),
    "stack red, green and blue from bottom to top": (
        "stack(red_block green_block blue_block; order=[given ranks=red_block green_block blue_block first=bottom])"
    ),
    "spell CAT": "spells(C_block A_block T_block, CAT)",
    "build the equation 2+3=5": "equation(2_block plus_block 3_block equals_block 5_block; text=2+3=5)",
    "sort two red and two blue blocks by color": (
        "group_by({red_block_1 red_block_2} {blue_block_1 blue_block_2}; by=color)"
    ),
    "make two towers of two red blocks": (
        "towers(red_block_1 red_block_2 red_block_3 red_block_4; count=2, heights=2 2)"
    ),
}
QUANTITIES = {
    "put exactly two of the three red blocks on the blue patch": (
        "count[2..2](red_block_1, red_block_2, red_block_3: on_patch(each, blue_patch))"
    ),
    "none of the two red blocks is on the green block": (
        "not on(red_block_1, green_block) and not on(red_block_2, green_block)"
    ),
    "put red or blue on the green patch": "on_patch(red_block, green_patch) or on_patch(blue_block, green_patch)",
    "there are two red blocks. put one on the blue patch and the other on the green patch": (
        "on_patch(red_block_1, blue_patch) and on_patch(red_block_2, green_patch)"
    ),
}
TIME = {
    "first put red on blue, then put green on red": "on(red_block, blue_block) then on(green_block, red_block)",
    "put red on blue before you put green on red": "on(red_block, blue_block) then on(green_block, red_block)",
    "put red on blue without moving green": "on(red_block, blue_block) and stayed(green_block)",
    "swap the red block and the blue block": "swapped(red_block, blue_block)",
}
REFUSED = {
    "put the sofa on the blue block": "unknown-word",
    "put the red block on the red block": "self-reference",
    "red on blue, blue on green, green on red": "support-cycle",
    "red is left of blue and right of blue": "contradiction",
    "there are three red blocks. put the red block on the patch": "ambiguous",
    "put it on the table": "no-referent",
    "build the equation 2+2=5": "false-equation",
    "put the red block left of blue and the green block right of it": "ambiguous",
    "pick up the red block": "no-goal",
    "line up thirteen blocks side by side from left to right": "does-not-fit",
}
ACCEPTED = {**RELATIONS, **STRUCTURES, **QUANTITIES, **TIME}


@pytest.mark.parametrize("text", ACCEPTED)
def test_goal(text: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is not None, diagnostics
    assert sketch(schema.goal) == ACCEPTED[text]


@pytest.mark.parametrize("text", REFUSED)
def test_refusal(text: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is None
    assert diagnostics[0].code == REFUSED[text]
    assert diagnostics[0].message


def test_every_node_knows_its_words() -> None:
    schema, _ = BuiltinFrontEnd().read("put the red block on the blue block and the green block next to it")
    assert schema is None or all(node.span is not None for node in getattr(schema.goal, "goals", (schema.goal,)))


def test_defaults_are_recorded() -> None:
    schema, _ = BuiltinFrontEnd().read("stack the red blocks")
    assert schema is not None
    assert "the number of red blocks is not said: 2" in schema.assumptions


def test_misspellings_are_recorded() -> None:
    schema, _ = BuiltinFrontEnd().read("put the red blok on the yelow block")
    assert schema is not None
    assert schema.assumptions[:2] == ("read 'blok' as 'block'", "read 'yelow' as 'yellow'")
