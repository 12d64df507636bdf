"""Parts that a figure has however it lies: the corner of an L, the bar of a T, the steps of a staircase."""

from __future__ import annotations

import pytest

from rpg.blocks.figure_parts import has_own, own_parts
from rpg.blocks.state import World
from rpg.ir.order import Order, Pattern
from rpg.ir.structures import Cells, Figure, Grid, Staircase
from tests.blocks.structure_states import check_built, plain, state, value, world

YAWS = (0.0, 0.4, 1.6, 2.9, 4.4)
PITCH = 0.05
Points = list[tuple[float, ...]]
L = Figure(blocks=("",), shape="L")
T = Figure(blocks=("",), shape="T")
U = Figure(blocks=("",), shape="U")
V = Figure(blocks=("",), shape="V")
TRIANGLE = Figure(blocks=("",), shape="triangle")
STAIRS = Staircase(blocks=("",), steps=3)
L_AT: Points = [(0, 0), (1, 0), (2, 0), (0, 1), (0, 2)]
T_AT: Points = [(0, -1), (0, 0), (0, 1), (-1, 0), (-2, 0)]
U_AT: Points = [(0, 0), (0, 2), (0, 1), (-1, 0), (-1, 2), (-2, 0), (-2, 2)]
U_WIDE: Points = [(0, 0), (0, 4), (0, 1), (0, 2), (0, 3), (-1, 0), (-1, 4)]
V_AT: Points = [(0, 0), (0.9, 0.5), (0.9, -0.5), (1.8, 1), (1.8, -1)]
TRIANGLE_AT: Points = [(0, 0), (1.73, -1), (1.73, 1), (0.87, -0.5), (0.87, 0.5), (1.73, 0)]
STAIRS_AT: Points = [(0, 0), (0, 1), (0, 1, 1), (0, 2), (0, 2, 1), (0, 2, 2)]


def parted(figure: Cells, part: str, count: int) -> tuple[Cells, int]:
    """`figure` of so many blocks with its part red and the rest blue, and how many are red."""
    blocks = tuple(f"b{k}" for k in range(count))
    places = own_parts(figure, count)[part]
    red = len(places)
    looks = ["red" if k in places else "blue" for k in range(count)]
    stock = {"red": list(blocks[:red]), "blue": list(blocks[red:])}
    ranks = tuple((stock[look].pop(0),) for look in looks)
    pattern = Pattern(kind="reading", order=Order(by="given", ranks=ranks), own=True)
    return figure.model_copy(update={"blocks": blocks, "pattern": pattern}), red


def holds(node: Cells, red: int, points: Points, yaw: float, mirrored: bool) -> bool:
    """With the red blocks at the first points, and the blue ones at the others."""
    sign = -1 if mirrored else 1
    at = {f"b{k}": (p[0] * PITCH, sign * p[1] * PITCH, *p[2:]) for k, p in enumerate(points)}
    return value(node, state(painted(red, len(points)), at, yaw=yaw))  # type: ignore[arg-type]


def painted(red: int, count: int) -> World:
    """So many red blocks, and blue ones."""
    return world(plain(**{f"b{k}": "red" if k < red else "blue" for k in range(count)}))


CASES = [
    (L, "the corner", L_AT, [1, 0, 2, 3, 4]),
    (T, "the bar", T_AT, [3, 0, 1, 2, 4]),
    (U, "the two corners", U_AT, [0, 2, 1, 3, 4, 5, 6]),
    (U, "the two corners", U_WIDE, [0, 4, 1, 2, 3, 5, 6]),
    (U, "the two ends", U_AT[::-1], [2, 1, 0, 3, 4, 5, 6]),
    (V, "the point", V_AT, [3, 0, 1, 2, 4]),
    (V, "the two ends", V_AT[::-1], [2, 1, 0, 3, 4]),
    (TRIANGLE, "the three corners", TRIANGLE_AT, [0, 1, 3, 2, 4, 5]),
    (STAIRS, "the lowest step", STAIRS_AT, [1, 0, 2, 3, 4, 5]),
]


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize(("figure", "part", "points", "other"), CASES)
def test_a_part_turns_with_its_figure(
    figure: Cells, part: str, points: Points, other: list[int], mirrored: bool
) -> None:
    node, red = parted(figure, part, len(points))
    for yaw in YAWS:
        assert holds(node, red, points, yaw, mirrored)
        assert not holds(node, red, [points[k] for k in other], yaw, mirrored)


def test_the_highest_step_and_the_block_on_top() -> None:
    highest, three = parted(STAIRS, "the highest step", 6)
    assert three == 3 and holds(highest, 3, STAIRS_AT[3:] + STAIRS_AT[:3], 0.0, False)
    assert not holds(highest, 3, STAIRS_AT, 0.0, False)
    top, one = parted(STAIRS.model_copy(update={"up": "left"}), "the top block of the highest step", 6)
    assert one == 1 and holds(top, 1, STAIRS_AT[5:] + STAIRS_AT[:5], 0.0, False)
    assert not holds(top, 1, STAIRS_AT[5:] + STAIRS_AT[:5], 0.0, True)
    assert not holds(top, 1, STAIRS_AT, 0.0, False)


def test_a_part_that_is_elsewhere_in_another_size_is_none() -> None:
    """Seven blocks are a U three or five blocks wide, whose bases differ."""
    assert set(own_parts(U, 7)) == {"the two corners", "the two ends"}
    assert own_parts(U.model_copy(update={"sides": (3, 3)}), 7)["the base"] == (0, 1, 2)
    assert not has_own(Grid(blocks=("",), rows=2, columns=2)) and not has_own(Figure(blocks=("",), shape="circle"))


@pytest.mark.parametrize(("figure", "part", "points", "_"), CASES)
def test_figures_built_with_their_parts_hold(figure: Cells, part: str, points: Points, _: list[int]) -> None:
    node, red = parted(figure, part, len(points))
    check_built(node, painted(red, len(points)), least=3)
