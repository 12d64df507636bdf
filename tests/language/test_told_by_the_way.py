"""What is told in passing: relative clauses behind towers, exceptions and starts, and what pronouns find in them."""

from __future__ import annotations

from typing import Any

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("A red block stands to the left of a tower of two green blocks, which stands to the left of a blue block.",
         {"assets": {"red": 1, "green": 2, "blue": 1}, "hold": ["red green^green blue"],
          "miss": ["red blue green^green", "green^green red blue"]}),
        ("A white tower of three is behind a pink tower of two, which in turn is behind a single gray block.",
         {"assets": {"white": 3, "pink": 2, "gray": 1}, "hold": ["white^white^white | pink^pink | gray"],
          "miss": ["white^white^white | gray | pink^pink", "pink^pink | white^white^white | gray"]}),
        ("Put the red block left of the tower of two green blocks, which stands on the blue mat.",
         {"assets": {"red": 1, "green": 2, "blue_patch": 1},
          "hold": ["red at=blue_patch+0,5 ; green^green at=blue_patch"],
          "miss": ["red green^green", "red at=blue_patch ; green^green"]}),
        ("The red tower of two blocks, which stands to the left of the blue block, is on the patch.",
         {"assets": {"red": 2, "blue": 1, "patch": 1}, "hold": ["red^red at=patch ; blue at=patch+0,-5"],
          "miss": ["red^red blue", "red^red at=patch ; blue at=patch+0,5"]}),
        ("The yellow block, which is in front of the brown block now, should go behind it.",
         {"assets": {"yellow": 1, "brown": 1}, "start": ["brown | yellow"], "start_miss": ["yellow | brown"],
          "hold": ["yellow | brown"], "miss": ["brown | yellow"]}),
        ("The pink cube that is on the gray cube should stand next to it.",
         {"assets": {"pink": 1, "gray": 1}, "start": ["gray^pink"], "start_miss": ["gray pink"],
          "hold": ["gray pink"], "miss": ["gray^pink"]}),
        ("There are a red, a blue and a green block; with the exception of the red one, which stays off it, every "
         "block shall be placed on the white area.",
         {"assets": {"red": 1, "blue": 1, "green": 1, "white_patch": 1},
          "hold": [["red blue green", "red ; blue green at=white_patch"]],
          "miss": [["red blue green", "red blue green at=white_patch"], ["red blue green", "blue at=white_patch"]]}),
        ("Three red blocks and a blue one. Except for the blue one, which goes next to it, all blocks go on the mat.",
         {"assets": {"red": 3, "blue": 1, "patch": 1}, "hold": ["red^red^red at=patch ; blue at=patch+0,2.2"],
          "miss": ["red^red^red^blue at=patch", "red^red^red at=patch ; blue at=patch+0,5"]}),
    ],
)  # fmt: skip
def test_what_is_told_by_the_way_is_meant(text: str, meant: dict[str, Any]) -> None:
    assert_means(text, meant)


@pytest.mark.parametrize(
    "text",
    [
        "Put a green block on a tower of three red blocks that is on the mat.",
        "Put the red block left of the tower of two green blocks that stands on the blue mat.",
        "The red block, which is on the blue one, should be behind it.",
        "Put the red block, which lies on the blue mat, behind it.",
        "The red block, which is left of the green one, and the blue block, which is on the white one, should be "
        "behind it.",
    ],
)
def test_what_could_be_of_the_start_or_of_more_is_refused(text: str) -> None:
    schema, _ = BuiltinFrontEnd().read(text)
    assert schema is None
