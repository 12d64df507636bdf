"""The notation of the corpus: what pictures draw, and that they draw no more blocks than their entry expects."""

from __future__ import annotations

from collections import Counter

import pytest

from rpg.ir.assets import ColoredCube, GoalPatch, SemanticCube
from rpg.ir.goal import OnTable
from rpg.ir.schema import TaskSchema
from tests.corpus.entries import SPLITS, load
from tests.corpus.looks import OPEN, Binding, Mismatch
from tests.corpus.states import TOKEN, Painter, parse

SCHEMA = TaskSchema(
    name="scene",
    instruction="scene",
    assets=(
        ColoredCube(name="red_block_1", color="red"),
        ColoredCube(name="red_block_2", color="red"),
        ColoredCube(name="blue_block", color="blue", size=0.05),
        SemanticCube(name="A_block", label="A"),
        GoalPatch(name="green_patch", color="green", position=(0.5, 0.1)),
    ),
    goal=OnTable(a="A_block"),
)
EXPECTED: dict[str, int | str] = {"red": 2, "blue{5}": 1, "A": 1, "green_patch": 1}


def painter() -> Painter:
    binding = Binding(SCHEMA, EXPECTED)
    binding.check()
    return Painter(binding)


def test_stacks_stand_on_real_sizes() -> None:
    state = painter().state("blue{5}^red^A at=0,0")
    heights = [round(state.bottom(name) - state.bottom("blue_block"), 4) for name in ("red_block_1", "A_block")]
    assert heights == [0.05, 0.09]


def test_rows_go_from_far_to_near_and_left_to_right() -> None:
    state = painter().state("red A | . red at=0,0 pitch=2")
    far_left, near_right, letter = (state.position[name] for name in ("red_block_1", "red_block_2", "A_block"))
    assert far_left[0] > near_right[0] and far_left[1] > near_right[1]
    assert letter[0] == far_left[0] and letter[1] == near_right[1]


def test_pieces_lie_on_patches_and_the_rest_far_away() -> None:
    state = painter().state("A~90 at=green_patch+0.5,0")
    assert state.position["A_block"][:2] == pytest.approx((0.52, 0.1))
    assert state.axes("A_block")[0][1] == pytest.approx(-1.0)
    assert all(state.position[name][0] > 4 for name in ("red_block_1", "red_block_2", "blue_block"))


def test_other_assets_than_expected_are_a_mismatch() -> None:
    for expected in ({"red": 2}, {**EXPECTED, "red": 3}, {**EXPECTED, "green_patch": 2}):
        with pytest.raises(Mismatch):
            Binding(SCHEMA, expected).check()


@pytest.mark.parametrize("split", SPLITS)
def test_pictures_draw_only_what_is_expected(split: str) -> None:
    for entry in load(split):
        expected = {str(look): str(count) for look, count in (entry.assets or {}).items()}
        for picture in (picture for state in (*entry.hold, *entry.miss) for picture in state if expected):
            rows = [row for part in picture.split(";") for row in parse(part).rows]
            cells = [token for row in rows for cell in row for token in (cell[:1] if cell[1:] == ["*"] else cell)]
            tokens = [match for match in map(TOKEN.fullmatch, cells) if match and not match["all"]]
            for look, count in Counter(match["look"] for match in tokens).items():
                left_open = look == "any" or not expected.keys().isdisjoint(OPEN)
                limit = expected.get(look, ">=0" if left_open else "none")
                assert limit != "none", f"{entry.text!r}: {look} in {picture!r}"
                assert ">" in limit or count <= int(limit), f"{entry.text!r}: {count} {look} in {picture!r}"
