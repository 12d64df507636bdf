"""Titles are left out that tell nothing, or nothing but what is told again behind them; others are not."""

from __future__ import annotations

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import code_of, means

TITLES = (
    ("Variant with distractors:", "red cube on blue cube, plus two distractor cubes"),
    ("Long-horizon variant with letter cubes:", "first stack A on B, and after that put C on A"),
    ("size ordering (from the infant paper):", "stack three cubes with the biggest at the bottom"),
    ("Fancy sorting by color:", "two red and two blue blocks, sorted by color"),
    ("Two armies:", "three white blocks in one row, three black blocks in another row"),
    ("Three little pigs:", "three towers of 1, 2 and 3 blocks"),
    ("Treasure room:", "a gold block on a black block"),
    ("Traffic light!", "Red on top, yellow in the middle, green at the bottom."),
    ("Drumroll...", "put red on blue!"),
)
KEPT = (
    ("Variant with distractors: red cube on blue cube", "unknown-word"),
    ("Variant with four blocks: red cube on blue cube", "unknown-word"),
    ("Variant without a mat: red cube on blue cube", "unknown-word"),
    ("Long-horizon variant with red cubes: first stack A on B, and after that put C on A.", "unknown-word"),
    ("Three armies: three white blocks in one row, three black blocks in another row", "unknown-word"),
    ("Two teams of three: a row of white blocks and a row of black blocks", "unknown-word"),
    ("Color sorting: two red and two blue blocks in a row", "misplaced-word"),
    ("Reversal of a stack. Put red on blue.", "misplaced-word"),
    ("Crescent: put five red blocks on the mat.", "unknown-word"),
    ("Piramid: six red blocks on the mat", "ambiguous"),
    ("Levitate red. Put red on blue.", "unknown-word"),
    ("Levitate everything. Put red on blue.", "unknown-word"),
    ("Crookedly. Put three red blocks on the mat.", "unknown-word"),
)
"""What they tell would be lost."""


@pytest.mark.parametrize(("title", "told"), TITLES)
def test_a_title_is_left_out_with_a_note(title: str, told: str) -> None:
    whole = f"{title} {told}"
    assert means(whole) == means(told)
    task, _ = BuiltinFrontEnd().read(whole)
    assert task is not None and any(note.startswith("left out") for note in task.assumptions)


@pytest.mark.parametrize(("text", "code"), KEPT)
def test_what_is_not_told_again_is_kept(text: str, code: str) -> None:
    assert code_of(text) == code
