"""What "or" joins where more is told behind it, and what "both", "neither" and "or both" are then."""

from __future__ import annotations

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import means


def _either(block: str, rel: str, one: str, other: str) -> str:
    return f"The {block} block must be {rel} the {one} block or the {block} block must be {rel} the {other} block."


@pytest.mark.parametrize(
    ("text", "either", "then"),
    [
        ("Put A on B or C and D on neither.", "on", "must not be on"),
        ("Put A on B or C, and D on neither.", "on", "must not be on"),
        ("A must be on B or C and D on neither.", "on", "must not be on"),
        ("Put A near B or near C, and D near neither.", "near", "must not be near"),
        ("Put A next to B or C and D next to both.", "next to", "must be next to"),
        ("Put A near B or C; D must be near both.", "near", "must be near"),
        ("Put A near B or near C. D must be near both of them.", "near", "must be near"),
    ],
)
def test_both_and_neither_are_what_or_joins(text: str, either: str, then: str) -> None:
    told = means(text)
    assert _either("A", either, "B", "C") in told
    for mark in "BC":
        assert f"The D block {then} the {mark} block." in told
    assert "or the D block" not in told
    assert "C block must" not in told
    assert "the A block." not in told


def test_so_it_is_of_colors_and_of_what_is_kept() -> None:
    told = means("Put red on blue or on green, and yellow on neither.")
    assert _either("red", "on", "blue", "green") in told
    assert "must not be on the red block" not in told
    told = means("Put A on B or on C, and keep D off both.")
    assert _either("A", "on", "B", "C") in told
    assert "D block is on" not in told
    assert "must never be somewhere above the C block" in told
    told = means("Put A near B or C. Keep D at least 10 cm from both.")
    assert "at least 10 cm from the B block and the D block must always be at least 10 cm from the C block" in told


@pytest.mark.parametrize(
    "text",
    [
        "Put A on B or C and D on the mat.",
        "Put red on blue or green and yellow on the mat.",
        "A must be on B or C and D must be on the mat.",
    ],
)
def test_where_it_could_be_either_it_is_asked(text: str) -> None:
    task, notes = BuiltinFrontEnd().read(text)
    assert task is None
    assert notes[0].code == "ambiguous"


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Put A on the mat or B and C on the mat.", "Either the A block must be on the gray patch, or the blocks B"),
        ("Put A on B, or C and D on the mat.", "Either the A block must be on the B block, or the blocks C and D"),
        ("Put A on B or C on D.", "The A block must be on the B block or the C block must be on the D block."),
        ("Put A on B or on C and D on the mat.", "The D block must be on the gray patch."),
    ],
)
def test_what_stands_behind_or_may_be_told_of_others(text: str, meant: str) -> None:
    assert meant in means(text)


@pytest.mark.parametrize(
    ("text", "there"),
    [
        ("A or B must be on the mat; both must be in the left half.", "The blocks A and B must be in the left half"),
        ("Put A or B on the mat and C next to both.", "The C block must be next to the B block."),
        ("Put A or B on the mat, but both of them in the left half.", "The blocks A and B must be in the left half"),
        ("Put A or B on the mat. They must not touch.", "The A block must not touch the B block."),
    ],
)
def test_both_of_two_of_which_one_is_there_are_both(text: str, there: str) -> None:
    told = means(text)
    assert there in told
    assert "The A block must be on the gray patch or the B block must be on the gray patch." in told


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("Put A next to B or C next to D, or both.",
         "The A block must be next to the B block or the C block must be next to the D block."),
        ("Put the red block on the mat, or the blue block on the green one, or both.",
         "The red block must be on the gray patch or the blue block must be on the green block."),
        ("Put red on blue, green on white, or both.",
         "The red block must be on the blue block or the green block must be on the white block."),
        ("Put A near B or C or both.", _either("A", "near", "B", "C")),
    ],
)  # fmt: skip
def test_or_both_says_no_more_than_or(text: str, meant: str) -> None:
    assert means(text).endswith(meant)


def test_neither_is_one_of_two_blocks() -> None:
    task, notes = BuiltinFrontEnd().read("Put A on the mat and put B near neither.")
    assert task is None
    assert notes[0].code == "ambiguous"
    assert "must not touch the A block. The C block must not touch the B block" in means(
        "A touches B. C touches neither."
    )


@pytest.mark.parametrize(
    ("text", "sides"),
    [
        ("Either A is on the patch, or B is not and C is on A.",
         "Either the A block must be on the gray patch, or the B block must not be on the gray patch and the C block"),
        ("Either A is on the patch and C is on A, or B is.",
         "Either the A block must be on the gray patch and the C block must be on the A block, or the B block"),
    ],
)  # fmt: skip
def test_what_and_joins_is_one_side_of_either(text: str, sides: str) -> None:
    assert sides in means(text)
