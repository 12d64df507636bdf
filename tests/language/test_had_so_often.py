"""Blocks that are had as often as they are told, and figures and places that are told by others of themselves."""

from __future__ import annotations

from typing import Any

import pytest

from tests.language.meaning import assert_means, code_of

WHITE_BETWEEN: dict[str, Any] = {
    "assets": {"green": 2, "white": 3, "red": 2},
    "hold": ["green^green white^white^white red^red", "red^red white^white^white green^green"],
    "miss": ["white^white^white green^green red^red", "green^white^green . white^white . red^red"],
}
A_FOURTH: dict[str, Any] = {
    "assets": {"green": 1, "red": 1, "gray": 2},
    "hold": ["gray^green^red^gray"],
    "miss": ["gray^green^gray^red", "red^green^gray^gray", "gray^red^green^gray"],
}
GREEN_LEFT: dict[str, Any] = {
    "assets": {"green": 2, "red": 3},
    "hold": ["green^green . red^red^red"],
    "miss": ["red^red^red . green^green", "green^green | red^red^red"],
}
FIVE_THERE: dict[str, Any] = {
    "assets": {"green": 4, "white": 2, "patch": 1},
    "hold": ["green green green | green white white at=patch pitch=1.1"],
    "miss": ["green green white at=patch", "green green green | green white at=patch pitch=1.1"],
}
TWO_ON_TWO: dict[str, Any] = {
    "assets": {"green": 2, "white": 2, "red_patch": 1, "blue_patch": 1},
    "hold": ["green^white at=red_patch; green^white at=blue_patch"],
    "miss": [
        "green^white at=red_patch; green at=blue_patch; white",
        "green white at=red_patch; green white at=blue_patch",
    ],
}
MEANT: dict[str, dict[str, Any]] = {
    "Build a tower of two green blocks, one of three white blocks and one of two red blocks, with the white one in the "
    "middle.": WHITE_BETWEEN,
    "Three towers: one of two green cubes, one of three white cubes and one of two red cubes, the white one in the "
    "middle.": WHITE_BETWEEN,
    "Build a green tower of two, a white tower of three and a red tower of two. The white one is in the "
    "middle.": WHITE_BETWEEN,
    "Build a row of one red block, one white block and one green block, with the white one in the middle.": {
        "assets": {"red": 1, "white": 1, "green": 1},
        "hold": ["red white green", "green white red"],
        "miss": ["white red green"],
    },
    "Make a tower of four blocks: the second from the bottom is green, the one above it is red, the others are "
    "gray.": A_FOURTH,
    "Make a tower of four blocks; the third from the top is green, the one directly above it is red and the others are "
    "gray.": A_FOURTH,
    "Make a row of four cubes; the second from the left is green, the one to its right is red, the others are gray.": {
        "assets": {"green": 1, "red": 1, "gray": 2},
        "hold": ["gray green red gray"],
        "miss": ["gray green gray red", "gray red green gray"],
    },
    "Tower A has two green blocks, tower B has three red blocks; A is left of B.": GREEN_LEFT,
    "Tower 1 has two green blocks, tower 2 has three red blocks. 1 stands left of 2.": GREEN_LEFT,
    "Tower A: two green blocks. Tower B: three red blocks. A is left of B.": GREEN_LEFT,
    "Put twice as many green blocks as white blocks on the mat: four green and two white ones.": FIVE_THERE,
    "Put more green than white blocks on the mat: two white and four green ones.": FIVE_THERE,
    "Put as many green as white cubes on the mat, two of each.": {
        "assets": {"green": 2, "white": 2, "patch": 1},
        "hold": ["green green | white white at=patch pitch=1.1"],
        "miss": ["green white at=patch"],
    },
    "Put a green block with a white one on top on each of the two mats, a red and a blue one.": TWO_ON_TWO,
    "In each of the four corners of the table is a green block with a white one on it.": {
        "assets": {"green": 4, "white": 4},
        "hold": [],
        "miss": ["green^white green^white green^white green^white"],
    },
    "Make a 2x3 grid of green blocks and put three white blocks on its front row.": {
        "assets": {"green": 6, "white": 3},
        "hold": ["green green green | green^white green^white green^white"],
        "miss": ["green green green | white white white", "green^white green^white green^white | green green green"],
    },
    "Build a tower of two green blocks and a tower of two red blocks. Each of them has a white block on top.": {
        "assets": {"green": 2, "red": 2, "white": 2},
        "hold": ["green^green^white . red^red^white"],
        "miss": ["green^green . red^red^white . white", "white^green^green . red^red^white"],
    },
    "Two towers with a white block between them, each with a green base and a red top.": {
        "assets": {"green": 2, "red": 2, "white": 1},
        "hold": ["green^red white green^red"],
        "miss": ["green^red green^red white", "red^green white green^red"],
    },
    "A green and a white block stand side by side, and a red block lies on both.": {
        "assets": {"green": 1, "white": 1, "red": 1},
        "hold": ["side red(0,-0.5) | green white"],
        "miss": ["green^red white"],
    },
    "Build two towers of two red blocks, and put one white block on each.": {
        "assets": {"red": 4, "white": 2},
        "hold": ["red^red^white . red^red^white"],
        "miss": ["red^red^white^white . red^red"],
    },
}
REFUSED = (
    "Two towers of two green cubes each, and one white cube on top of both.",
    "A square of four green cubes, and a single red cube lies on all of them.",
    "Build a gate: two towers of two white cubes, with a red cube lying on top of both.",
    "Build a tower of two green cubes and a tower of two white cubes, with one red cube on top of both.",
    "Two towers of two green cubes each, and one white cube on top of them.",
    "Leave the back left corner of the 3x3 square empty, the other eight cubes are white.",
    "Build a 3x3 grid of white blocks and leave its middle empty.",
    "Make a 3x3 grid of green blocks. On its middle row put three white blocks.",
    "Put twice as many green as white blocks on the mat: three green and two white ones.",
    "On the white mat there are twice as many blocks as on the green one: four blue ones.",
    "On each of the two mats put a green block with a white one behind it.",
    "The B block stands between two towers, each with a green base and a red top.",
    "A white block lies between two towers, and both the towers have a green base and a red top.",
)


@pytest.mark.parametrize("text", MEANT)
def test_states(text: str) -> None:
    assert_means(text, MEANT[text])


@pytest.mark.parametrize("text", REFUSED)
def test_refused(text: str) -> None:
    assert code_of(text)
