"""A tower without its top is met on the way to the tower; what is not is met too early."""

from __future__ import annotations

import pytest

from rpg.ir import goal as g
from rpg.ir.stages import passed
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.language.meaning import assert_means

BUILT = (
    "Build a stack with red at the bottom, green in the middle and blue at the top; then put the blue block back on "
)
APART, LOWER, WHOLE = "red; green; blue", "red^green; blue", "red^green^blue"


@pytest.mark.parametrize(
    ("text", "indices"),
    [
        (f"{BUILT}the table.", (1,)),
        ("Put green on red and blue on green. Then put blue on the table.", (1,)),
        ("Put red on the red patch, then on the green patch.", ()),
        ("Put red on blue, then green on yellow.", ()),
    ],
)
def test_which_stages_are_met_on_the_way(text: str, indices: tuple[int, ...]) -> None:
    task, _ = BuiltinFrontEnd().read(text)
    assert task is not None and isinstance(task.goal, g.Sequence)
    assert passed(task.goal) == indices


def test_the_tower_may_be_built_from_its_lower_part() -> None:
    assert_means(
        f"{BUILT}the table.",
        {
            "assets": {"red": 1, "green": 1, "blue": 1},
            "hold": [[APART, WHOLE, LOWER], [APART, LOWER, WHOLE, LOWER]],
            "miss": [[APART, LOWER], [APART, LOWER, WHOLE], [APART, WHOLE, APART], [APART, WHOLE, "blue^red; green"]],
        },
    )


def test_what_is_not_on_the_way_is_met_too_early() -> None:
    first, early = "red; blue; green; yellow", "green^yellow; red; blue"
    assert_means(
        "First put red on blue, then yellow on green.",
        {
            "assets": {"red": 1, "blue": 1, "green": 1, "yellow": 1},
            "hold": [[first, "blue^red; green; yellow", "blue^red; green^yellow"]],
            "miss": [[first, early, "green^yellow; blue^red"]],
        },
    )
