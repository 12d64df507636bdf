"""Goals that only deny something: a task starts where what they deny is so."""

from __future__ import annotations

import pytest

from rpg.blocks.evaluate import evaluate
from rpg.blocks.initial import sample_start
from rpg.blocks.state import World
from rpg.ir.schema import InitialState
from rpg.passes.schema.frontend import BuiltinFrontEnd
from rpg.pipeline import CompileOptions, compile_instruction


@pytest.mark.parametrize(
    "text",
    [
        "The green block must not touch any of the three red blocks.",
        "At most one of the three red blocks is on the green patch.",
        "red and blue must not be on the same patch",
        "Red isn't both on the patch and left of blue.",
    ],
)
def test_the_start_breaks_the_goal(text: str) -> None:
    outcome = compile_instruction(text, CompileOptions(paraphrases=0))
    assert outcome.status == "admitted", outcome.diagnostics
    schema = outcome.schema
    assert schema is not None and any("at the start" in told for told in schema.assumptions)
    world = World(schema.assets)
    for seed in range(5):
        assert not evaluate(schema.goal, sample_start(schema.init, world, seed))


@pytest.mark.parametrize(
    "text",
    [
        "Red starts on the patch. Red must not be on the patch at the end.",
        "Put red on blue. Red must not touch the green block.",
    ],
)
def test_a_start_that_is_told_and_a_goal_that_asks_for_something_are_left_alone(text: str) -> None:
    schema, _ = BuiltinFrontEnd().read(text, name=None, seed=0, author=None)
    assert schema is not None and not any("would hold" in told for told in schema.assumptions)


def test_what_must_never_be_has_no_such_start() -> None:
    text = "Put red on blue. The red block must never be on the patch."
    schema, _ = BuiltinFrontEnd().read(text, name=None, seed=0, author=None)
    assert schema is not None and schema.init == InitialState()
