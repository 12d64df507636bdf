"""Paraphrases: enough of them, all different, each read back as the same task."""

from __future__ import annotations

import pytest

from rpg.blocks.equivalence import equivalent
from rpg.ir.schema import TaskSchema
from rpg.passes.schema.frontend import BuiltinFrontEnd
from rpg.passes.schema.paraphrase import paraphrases

INSTRUCTIONS = (
    "put the red block on the blue block",
    "line up red, yellow, green and blue from left to right",
    "exactly two of the three red blocks on the blue patch",
    "first put red on blue, then put green on red",
    "build a tower of three green blocks to the left of the letter A",
    "spell ROBOT",
    "red next to green but not next to blue",
    "swap the red block and the blue block",
)


def read(text: str) -> TaskSchema | None:
    return BuiltinFrontEnd().read(text)[0]


@pytest.mark.parametrize("instruction", INSTRUCTIONS)
def test_five_or_more_wordings_ask_for_the_same(instruction: str) -> None:
    schema = read(instruction)
    assert schema is not None
    found = paraphrases(schema, read)
    assert len(set(found)) == len(found) >= 5
    assert instruction not in found
    for text in found:
        other = read(text)
        assert other is not None and equivalent(schema, other), text


def test_a_reader_that_understands_nothing_leaves_no_paraphrases() -> None:
    schema = read(INSTRUCTIONS[0])
    assert schema is not None
    assert paraphrases(schema, lambda text: None) == ()
