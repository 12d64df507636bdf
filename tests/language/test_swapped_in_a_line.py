"""Two blocks of a line that change places: the others stay where they are in it."""

from __future__ import annotations

import pytest

from tests.language.meaning import assert_means, code_of, start_and_end

ROW = "A, B, C and D stand in a row from left to right. "


@pytest.mark.parametrize("done", ["Swap A and D.", "Swap the two at the ends.", "Exchange the first and the last."])
def test_the_rest_of_the_row_keeps_its_order(done: str) -> None:
    row = "A B C D at=0,0"
    held = [[row, "D B C A at=0,0"]]
    missed = [[row, "D C B A at=0,0"], [row, "A B C D at=0,0"], [row, "A C B D at=0,0"]]
    assert_means(ROW + done, {"assets": {"A": 1, "B": 1, "C": 1, "D": 1}, "hold": held, "miss": missed})


def test_a_tower_is_built_again_with_two_swapped() -> None:
    text = "A tower has red at the bottom, then blue, then green, and white on top. Swap blue and green."
    assert "from bottom to top in the order red, green, blue, white" in start_and_end(text)[1]


def test_the_front_of_a_word_is_asked_about() -> None:
    assert start_and_end("The letters spell EAT. Move the last one to the front.")[1].endswith("the word TEA.")
    assert code_of("The letters spell EAT. Move the T to the front.") == "ambiguous"
