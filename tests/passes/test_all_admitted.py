"""Instructions that are understood become admitted tasks, also where conditions bear on each other; what leaves nothing
to do is refused."""

from __future__ import annotations

import pytest

from rpg.ir import goal as g
from rpg.passes.schema.frontend import BuiltinFrontEnd
from rpg.pipeline import CompileOptions, compile_instruction

ADMITTED = (
    # what is read has a block on it
    "first spell NO, after that put the red cube on the N",
    "Spell the word DOG on the table, and stack a red block onto the O.",
    "Build a 2x2 grid of the letters W, X, Y, Z in reading order and put a white block on the Z.",
    "Put 7, 8 and 9 in ascending order from left to right, and the letter Z on top of the 9.",
    "CAT is written with the blocks, and on the C there is a red block.",
    "Build a tower that spells HOUSE.",
    # above, but not directly; faces that can only be seen from the front
    "Put the orange block above the white block without putting it directly on the white block. There is a purple one.",
    "Digit 4 on digit 7, both facing the camera.",
    # what lasts
    "First build a row of three blue blocks, then stack a white one on the leftmost. "
    "Throughout, the red block must stay where it is.",
    "the red block must stay 15 cm or more from the blue block",
    "Neither the red nor the blue block stays on the gray patch where both of them start.",
    # what is so at nearly every start
    "JO should be readable from left to right, J first, on the table.",
    "First put the red block on the table, then put the blue block on it.",
    "white cube on table not on patch",
    "Every blue block must be on the table and no blue block may touch another block. "
    "There are three blue blocks and one red one.",
)


@pytest.mark.parametrize("text", ADMITTED)
def test_what_is_understood_is_admitted(text: str) -> None:
    outcome = compile_instruction(text, CompileOptions(paraphrases=0))
    assert outcome.status == "admitted", outcome.diagnostics


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("put the red block back where it was", "start-solves-goal"),
        ("the red block must stay on the blue block", "start-solves-goal"),
        ("leave red and blue where they are", "start-solves-goal"),
        ("the red block must stay clear of the blue patch", "start-solves-goal"),
        ("The red block must never be on the patch.", "start-solves-goal"),
        ("put three white blocks in one pile and three black ones in another pile, apart from each other", "ambiguous"),
    ],
)
def test_what_leaves_nothing_to_do_is_refused_when_it_is_read(text: str, code: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is None
    assert [d.code for d in diagnostics if d.severity == "error"] == [code]


def test_what_lasts_is_no_stage() -> None:
    schema, _ = BuiltinFrontEnd().read("First red on blue, then green on red. Throughout, black must stay where it is.")
    assert schema is not None and isinstance(schema.goal, g.All)
    done, lasting = schema.goal.goals
    assert isinstance(done, g.Sequence) and len(done.stages) == 2
    assert isinstance(lasting, g.Always)
