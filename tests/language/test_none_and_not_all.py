"""What is denied of none, of not all or of at most one: ever, of both places together, or of doing anything at all."""

from __future__ import annotations

import pytest

from rpg.ir import goal as g
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import code_of, means


@pytest.mark.parametrize(
    ("text", "never"),
    [
        ("Put the red block on the mat; no other block may ever be on the mat. There are two blue blocks.",
         ["Blue block 1 must never be on the gray patch", "blue block 2 must never be on the gray patch"]),
        ("Put A on B; neither C nor D may ever be on the mat.",
         ["The C block must never be on the gray patch", "the D block must never be on the gray patch"]),
        ("Put A and B on the mat; neither of them may ever touch C.", ["the B block must never touch the C block"]),
        ("Put A on the mat. Only A may ever be on the mat. There is a B.", ["B block must never be on the gray patch"]),
    ],
)  # fmt: skip
def test_what_may_not_ever_be_so_never_is(text: str, never: list[str]) -> None:
    told = means(text)
    assert all(part in told for part in never)


def test_what_may_not_be_so_is_told_of_the_end() -> None:
    assert "The C block must not be on the gray patch." in means("Put A on B; neither C nor D may be on the mat.")


@pytest.mark.parametrize(
    "text",
    [
        "None of A, B, C may be both near the red block and on the mat.",
        "Neither A nor B may be both near the red block and on the mat.",
        "There are A and B. No block may be both near the red block and on the mat.",
    ],
)
def test_both_places_are_denied_together(text: str) -> None:
    told = means(text)
    for block in "AB":
        near, on = (
            f"The {block} block must not be near the red block",
            f"the {block} block must not be on the gray patch",
        )
        assert f"{near} or {on}." in told


@pytest.mark.parametrize(
    "text",
    [
        "Not one of A, B and C may be on the mat and in the near half at once.",
        "None of A, B and C may be on the mat in the near half.",
    ],
)
def test_so_they_are_at_once_or_one_within_the_other(text: str) -> None:
    task, _ = BuiltinFrontEnd().read(text)
    assert task is not None
    assert isinstance(task.goal, g.All)
    assert [isinstance(x, g.Not) and isinstance(x.goal, g.All) for x in task.goal.goals] == [True] * 3
    assert not any("at once" in told for told in task.assumptions)


def test_near_both_is_near_the_one_and_the_other() -> None:
    told = means("Put A on B. Neither C nor D may touch both A and B.")
    assert "The D block must not touch the A block or the D block must not touch the B block." in told
    told = means("Put A on B. Neither C nor D may touch A or B.")
    assert "The D block must not touch the A block. The D block must not touch the B block." in told


@pytest.mark.parametrize(
    "text",
    [
        "No red block may be in the left half and on the mat. There are two red blocks.",
        "None of the blue blocks may be left of the mat and behind it. There are two blue blocks.",
        "No block may be both in the left half and on the mat: red, blue, green.",
        "Put A on the mat; either B or C must not be there.",
        "Put A, B, C on the mat, not all touching.",
        "Put three red blocks on the mat, not all touching each other.",
        "Put A, B and C on the mat, but not all touching one another.",
        "Put red, blue and green on the mat, at most one of them on another.",
        "Put red, blue and green on the mat with no more than one on top of another.",
        "Put A, B and C on the mat. At most one may be left of another.",
    ],
)
def test_where_it_is_not_clear_how_much_is_denied_it_is_asked(text: str) -> None:
    assert code_of(text) == "ambiguous"


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("None of A, B and C may be on the mat or in the left half.", "The C block must not be in the left half"),
        ("Put A on the mat; neither B nor C must be there.", "The C block must not be on the gray patch."),
        ("Put A on the mat; at least one of B and C must not be there.",
         "The B block must not be on the gray patch or the C block must not be on the gray patch."),
        ("Do not put either B or C on the mat. Put A on B.", "The C block must not be on the gray patch."),
        ("No two of A, B and C may be on each other. Put A on the mat.",
         "The B block must not be somewhere above the C block."),
        ("Put A, B and C on the mat, not touching.", "The B block must not touch the C block."),
        ("Put A, B and C on the mat, none of them on another.", "The C block must not be somewhere above the A block."),
        ("Put red, blue and green on the mat. Blue and green must not be on another block.",
         "The green block must not be on the blue block."),
    ],
)  # fmt: skip
def test_what_is_plainly_denied_is_denied_of_each(text: str, meant: str) -> None:
    assert meant in means(text)


@pytest.mark.parametrize(
    "text",
    [
        "Move at most one of the blocks: red, blue, green.",
        "Move no more than two of A, B and C.",
        "There are A, B and C. Move at most one block.",
    ],
)
def test_what_is_done_where_nothing_is_moved_is_no_task(text: str) -> None:
    assert code_of(text) == "start-solves-goal"


def test_beside_what_is_done_few_may_be_moved() -> None:
    told = means("Put A on B. Move at most one of the blocks A, B and C.")
    assert "At most one of the blocks A, B and C must be moved" in told
    assert "At the start" not in told
    assert "Exactly one of the blocks A, B and C must be moved" in means("Move exactly one of A, B and C.")


def test_what_is_left_by_itself_is_so_of_no_one_of_several() -> None:
    text = (
        "None of the three gray blocks shall be left on the table by itself: all three shall be stacked on the red one."
    )
    assert "Gray block 1 must not be on the table." in means(text)
