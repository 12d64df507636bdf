"""One of several towers, or one of their blocks: what "exactly one of them" is behind them."""

from __future__ import annotations

import pytest

from rpg.blocks.english import describe
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import means

_TWO = "Make a tower of A and B and a tower of C and D"


@pytest.mark.parametrize(
    "text",
    [
        "Make two towers of two red blocks, exactly one on the mat.",
        "Make two towers of two red blocks. Exactly one of them must be on the mat.",
        f"{_TWO}, at most one of them in the left half.",
        f"{_TWO}. One of them is in the left half.",
        f"{_TWO}, either one on the mat.",
        "Build a tower of A and B and one of C and D, exactly one of them on the mat.",
        "Build a tower of A and B and one of C and D, either one on the mat.",
        "Make two rows of three red blocks, exactly one on the mat.",
    ],
)
def test_one_of_the_towers_or_of_their_blocks_is_asked(text: str) -> None:
    task, notes = BuiltinFrontEnd().read(text)
    assert task is None, describe(task)
    assert notes[0].code == "ambiguous"


def test_what_is_told_of_all_or_none_of_them_is_told_of_the_blocks() -> None:
    assert "The blocks A to D must be in the left half" in means(f"{_TWO}, both in the left half.")
    assert "The D block must not be in the left half" in means(f"{_TWO}, neither of them in the left half.")
    one_of_the_blocks = "Make two towers of two red blocks. One of the red blocks must be on the mat."
    assert "Exactly one of the four red blocks must be on" in means(one_of_the_blocks)


@pytest.mark.parametrize("kind", ["tower", "row"])
def test_one_of_others_is_one_more_of_its_kind(kind: str) -> None:
    told = means(f"Make a {kind} of A and B and one of C and D.")
    assert "The blocks A and B must" in told
    assert "The blocks C and D must" in told
