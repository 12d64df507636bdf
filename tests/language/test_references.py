"""Where else a task is told, how it is graded and what it is called are left out; what tells of blocks is not."""

from __future__ import annotations

import pytest

from rpg.blocks.english import describe
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import code_of, means

CORE = "Put the red block on the blue block"
MEANT = "There are a red block and a blue block. The red block must be on the blue block."


@pytest.mark.parametrize(
    "tail",
    [
        ", as in figure 3.", " (see section 4).", ", like I showed you yesterday.", ". That's what safety says.",
        ". Worth 5 points.", " (difficulty 1).", " within 60 seconds.", " in a single move.", ", or else!",
        " without dropping it.", " and keep it there.", " so that it stands by itself.", ", then go back to the home "
        "position.", "...",
    ],
)  # fmt: skip
def test_what_is_said_behind(tail: str) -> None:
    assert means(CORE + tail).replace("\n", " ") == MEANT


@pytest.mark.parametrize(
    "lead",
    ["Edge case: ", "Side-effect case: ", "Attempt 3: ", "Oh no, ", "Hide and seek! ", "Teach the robot to ",
     "The level is cleared when "],
)  # fmt: skip
def test_what_is_said_ahead(lead: str) -> None:
    core = "the red block is on the blue block." if "when" in lead else f"{CORE[0].lower()}{CORE[1:]}."
    assert means(lead + core).replace("\n", " ") == MEANT


def test_what_is_kept_there_has_its_place_from_the_sentence_itself() -> None:
    said = means("The red block is on the blue patch. Leave it there. Put the green block on the red block.")
    assert "The red block must be on the blue patch." in said


@pytest.mark.parametrize(
    "text",
    ["Sort them as in figure 2.", "Arrange the blocks like before.", "Everything else fails to matter."],
)  # fmt: skip
def test_a_reference_alone_tells_nothing(text: str) -> None:
    assert code_of(text)


@pytest.mark.parametrize("tail", [" within 5 cm of the green block", ", green stays as it was before"])
def test_what_tells_of_blocks_is_kept(tail: str) -> None:
    task, _ = BuiltinFrontEnd().read(CORE + tail + ".")
    assert task is None or describe(task) != MEANT
