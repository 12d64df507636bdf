"""What a first sentence tells, where what follows undoes it."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("One stack of six green blocks. Split it into two equal stacks.",
         {"assets": {"green": 6}, "start": ["green^green^green^green^green^green"],
          "start_miss": ["green^green^green ; green^green^green"], "hold": ["green^green^green ; green^green^green"],
          "miss": ["green^green^green^green^green^green", "green^green ; green^green ; green^green"]}),
        ("Six green blocks in two stacks of three. Merge them into one stack.",
         {"assets": {"green": 6}, "start": ["green^green^green ; green^green^green"],
          "hold": ["green^green^green^green^green^green"], "miss": ["green^green^green ; green^green^green"]}),
        ("The A is upside down. Turn it upright.",
         {"assets": {"A": 1}, "start": ["A~180"], "start_miss": ["A"], "hold": ["A"], "miss": ["A~180"]}),
        ("Red on blue. Put blue on red.",
         {"assets": {"red": 1, "blue": 1}, "start": ["blue^red"], "start_miss": ["red ; blue"], "hold": ["red^blue"],
          "miss": ["blue^red"]}),
        ("Red left of blue. Put red right of blue.",
         {"assets": {"red": 1, "blue": 1}, "start": ["red blue"], "start_miss": ["blue red"], "hold": ["blue red"],
          "miss": ["red blue"]}),
    ],
)  # fmt: skip
def test_what_is_undone_is_so_at_the_start(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "Stack red on blue. Put blue on red.",
        "Red must be on blue. Put blue on red.",
        "Put blue on red. Red on blue.",
        "The red block ends on the blue patch. Clear the patch.",
        "We finish with the white cube lying on the red patch. Move the white cube to the blue patch.",
        "Red on blue and blue on red.",
    ],
)
def test_what_is_asked_for_twice_is_no_start(text: str) -> None:
    assert BuiltinFrontEnd().read(text)[0] is None
