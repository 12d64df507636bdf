"""The top of a tower that is moved is its top block, and the top two are both of them."""

from __future__ import annotations

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import means

_TOWERS = "There is a red tower of three and a blue tower of two. "


@pytest.mark.parametrize("top", ["its top", "the top of it", "the top of the tower", "the top block of the tower"])
def test_the_top_is_the_top_block(top: str) -> None:
    told = means(f"There is a tower of A, B and C from bottom to top. Put {top} on the patch.")
    assert "The C block must be on the gray patch." in told
    told = means(f"There is a red tower of three. Put {top} on the patch.")
    assert (
        "Red block 3 must be on the gray patch. Red block 1 and red block 2 must form a tower of exactly two." in told
    )


def test_the_top_of_one_tower_goes_on_another() -> None:
    told = means(_TOWERS + "Put the top of the red tower on the blue tower.")
    assert "Red block 3 must be on the tower of the two blue blocks." in told
    assert "must form a tower of exactly three" not in told


@pytest.mark.parametrize(
    "wish",
    [
        "Put the top two of the red one on the blue one.",
        "Put the two top blocks of the red tower on the blue tower.",
        "Move the top two blocks of the red tower onto the blue tower.",
    ],
)
def test_the_top_two_are_both_moved_and_the_others_are_left(wish: str) -> None:
    told = means(_TOWERS + wish)
    assert "Red block 2 must be on the tower of the two blue blocks. Red block 3 must be on red block 2." in told
    assert "Red block 2 must not be somewhere above red block 1." in told
    assert "must form a tower" not in told


def test_which_blocks_the_top_of_a_pyramid_is_or_the_bottom_of_look_alikes_is_asked() -> None:
    for text in ("There is a pyramid of red blocks. Put its top on the patch.",
                 _TOWERS + "Put the bottom two blocks of the red tower on the blue tower.",
                 _TOWERS + "Put the top three blocks of the red tower on the blue tower."):  # fmt: skip
        task, notes = BuiltinFrontEnd().read(text)
        assert task is None
        assert notes[0].code == "no-referent"


def test_what_is_put_on_its_top_is_put_on_the_tower() -> None:
    told = means("There is a red tower of three. Put a blue block on its top.")
    assert "The blue block must be on the tower of the three red blocks." in told
    told = means("Build a tower of two red blocks. The top of the tower must be free.")
    assert "Nothing must be on the tower of the two red blocks." in told
