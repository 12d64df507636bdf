"""Figures of cells, their patterns, and groups on hand-made states: what must hold, and what must not."""

from __future__ import annotations

import math
from random import Random

import pytest

from rpg.blocks.figures import (
    FEWEST,
    FEWEST_FILLED,
    figure_size,
    ideals,
    line_sizes,
    pyramid_size,
    ring_width,
    staircase_size,
    takes,
)
from rpg.blocks.predicates import PREDICATES
from rpg.blocks.state import BlockState, World, yaw_quat
from rpg.ir.assets import Asset, ColoredCube
from rpg.ir.order import Order, Pattern
from rpg.ir.structures import Cells, Figure, Grid, GroupBy, Pyramid, Staircase
from tests.blocks.structure_states import E, check_built, cubes, letters, placed, plain, state, value, world

YAWS = (0.0, 0.3, 1.0, 2.4, 4.0)
PITCH = 0.05


def named(count: int) -> tuple[str, ...]:
    return tuple(f"b{k}" for k in range(count))


def at(points: list[tuple[float, ...]], pitch: float = PITCH) -> dict[str, tuple[float, ...]]:
    return {f"b{k}": (p[0] * pitch, p[1] * pitch, *p[2:]) for k, p in enumerate(points)}


def holds(node: Cells, points: list[tuple[float, ...]], yaw: float = 0.0, pitch: float = PITCH) -> bool:
    return value(node, state(world(cubes(len(points))), at(points, pitch), yaw=yaw))  # type: ignore[arg-type]


SQUARE = [(0, 0), (0, 1), (0, 2), (1, 0), (1, 2), (2, 0), (2, 1), (2, 2)]


@pytest.mark.parametrize("yaw", YAWS)
def test_square_outline(yaw: float) -> None:
    node = Figure(blocks=named(8), shape="square")
    assert holds(node, SQUARE, yaw)
    assert holds(node, SQUARE, yaw, pitch=0.08) and not holds(node, SQUARE, yaw, pitch=0.12)
    middle_in = [(1, 1) if p == (1, 0) else p for p in SQUARE]
    assert not holds(node, middle_in, yaw)
    assert not holds(node, [*SQUARE[:-1], (3.2, 3.2)], yaw)
    assert not holds(node, [(x, y, 1) if (x, y) == (0, 0) else (x, y) for x, y in SQUARE], yaw)
    row = [(0, k) for k in range(8)]
    assert not holds(node, row, yaw, pitch=0.042)


@pytest.mark.parametrize("yaw", YAWS)
def test_gaps_that_are_asked_of_a_figure(yaw: float) -> None:
    square = [(0, 0), (0, 1), (1, 0), (1, 1)]
    grid = Grid(blocks=named(4), rows=2, columns=2, gap=0.02)
    for pitch, fine in ((0.045, False), (0.052, True), (0.06, True), (0.068, True), (0.072, False)):
        assert holds(grid, square, pitch=pitch) is fine
    tight = Figure(blocks=named(8), shape="square", gap=0.0, tolerance=0.002)
    assert holds(tight, SQUARE, yaw, pitch=0.04) and not holds(tight, SQUARE, yaw, pitch=0.045)
    wide = Figure(blocks=named(8), shape="square", gap=0.06)
    assert holds(wide, SQUARE, yaw, pitch=0.1) and not holds(wide, SQUARE, yaw, pitch=0.08)


def test_a_square_of_nine_is_filled() -> None:
    nine = [(x, y) for x in range(3) for y in range(3)]
    assert holds(Figure(blocks=named(9), shape="square", filled=True), nine)
    assert not takes(Figure(blocks=named(9), shape="square"), 9)
    assert not holds(Figure(blocks=named(9), shape="square"), nine)
    assert holds(Grid(blocks=named(9), rows=3, columns=3), nine, yaw=0.6)


@pytest.mark.parametrize(("off", "fine"), [(0.0, True), (0.02, True), (0.05, False)])
def test_each_block_is_within_half_an_edge_of_its_cell(off: float, fine: bool) -> None:
    nine = [(x * PITCH, y * PITCH) for x in range(3) for y in range(3)]
    moved = [(x + off, y) if k == 8 else (x, y) for k, (x, y) in enumerate(nine)]
    for yaw in YAWS:
        assert holds(Grid(blocks=named(9), rows=3, columns=3), moved, yaw, pitch=1.0) is fine


def ring(count: int, radius: float) -> list[tuple[float, ...]]:
    return [(radius * math.cos(a), radius * math.sin(a)) for a in (2 * math.pi * k / count for k in range(count))]


@pytest.mark.parametrize("count", [3, 5, 8, 12])
def test_circle(count: int) -> None:
    node = Figure(blocks=named(count), shape="circle")
    radius = max(0.08, 0.045 / (2 * math.sin(math.pi / count)))
    for yaw in YAWS:
        assert holds(node, ring(count, radius), yaw, pitch=1.0)
    assert holds(node, ring(count, 0.12), pitch=1.0)
    assert not holds(node, ring(count, 0.30), pitch=1.0)
    if count > 4:
        bent = ring(count, radius)
        bent[0] = (bent[0][0] + 0.06, bent[0][1])
        assert not holds(node, bent, pitch=1.0)
        assert not holds(node, [(0.0, 0.045 * k) for k in range(count)], pitch=1.0)
        assert not holds(node, [*ring(count - 1, radius), (0.0, 0.0)], pitch=1.0)


def test_a_square_of_eight_is_no_circle_and_a_circle_no_square() -> None:
    assert not holds(Figure(blocks=named(8), shape="circle"), SQUARE, pitch=0.07)
    assert not holds(Figure(blocks=named(8), shape="square"), ring(8, 0.15), pitch=1.0)


TRIANGLE = [(0.0, 0.0), (-0.87, 0.5), (-0.87, -0.5), (-1.73, 1.0), (-1.73, 0.0), (-1.73, -1.0)]


def test_triangle() -> None:
    node = Figure(blocks=named(6), shape="triangle")
    for yaw in YAWS:
        assert holds(node, TRIANGLE, yaw, pitch=0.06)
    away = node.model_copy(update={"pointing": "back"})
    assert holds(away, TRIANGLE, pitch=0.06) and holds(away, TRIANGLE, math.radians(14), pitch=0.06)
    assert not holds(away, TRIANGLE, math.radians(17), pitch=0.06)
    assert not holds(away, TRIANGLE, math.pi, pitch=0.06)
    assert holds(node.model_copy(update={"pointing": "left"}), TRIANGLE, math.pi / 2, pitch=0.06)
    assert not holds(node, [(0, k) for k in range(6)], pitch=0.06)


EL = [(2, 0), (1, 0), (0, 0), (0, -1)]
"""As the viewer sees it: the stem goes away, the foot to the right."""


def test_letter_l_and_its_foot() -> None:
    node = Figure(blocks=named(4), shape="L")
    mirrored = [(x, -y) for x, y in EL]
    for yaw in YAWS:
        assert holds(node, EL, yaw) and holds(node, mirrored, yaw)
    right = node.model_copy(update={"pointing": "right"})
    assert holds(right, EL) and not holds(right, mirrored) and not holds(right, EL, math.pi / 2)
    assert not holds(right, [(-x, y) for x, y in EL])
    left = node.model_copy(update={"pointing": "left"})
    assert holds(left, mirrored) and not holds(left, EL)
    assert not holds(node, [(0, 0), (1, 0), (2, 0), (3, 0)])
    assert not holds(node, [(0, 0), (1, 0), (2, 0), (1, 1)])
    assert not holds(node, [(0, 0), (1, 0), (1, 1), (0, 1)])


TEE = [(0, 1), (0, 0), (0, -1), (-1, 0), (-2, 0)]
VEE = [(0, 0), (1, 1), (1, -1), (2, 2), (2, -2)]
YOU = [(0, 1), (0, 0), (0, -1), (1, 1), (1, -1)]
PLUS = [(0, 0), (1, 0), (-1, 0), (0, 1), (0, -1)]


@pytest.mark.parametrize(
    ("shape", "points", "pointing"), [("T", TEE, "front"), ("V", VEE, "front"), ("U", YOU, "back")]
)
def test_letters_and_where_they_point(shape: str, points: list[tuple[float, ...]], pointing: str) -> None:
    node = Figure(blocks=named(5), shape=shape)  # type: ignore[arg-type]
    for yaw in YAWS:
        assert holds(node, points, yaw)
    sides = {"front": 0, "right": 1, "back": 2, "left": 3}
    for side, quarter in sides.items():
        directed = node.model_copy(update={"pointing": side})
        turned = (quarter - sides[pointing]) * math.pi / 2
        assert holds(directed, points, turned), side
        assert not holds(directed, points, turned + math.pi / 2) and not holds(directed, points, turned + math.pi)
    for other in (TEE, VEE, YOU, PLUS):
        if other is not points:
            assert not holds(node, other)


def test_plus_and_x() -> None:
    assert holds(Figure(blocks=named(5), shape="plus"), PLUS, 0.3)
    cross = Figure(blocks=named(5), shape="X")
    assert holds(cross, PLUS, math.pi / 4) and not holds(cross, PLUS)
    assert holds(cross, PLUS, math.pi / 4 + math.radians(20)) and not holds(cross, PLUS, math.radians(20))


FLAT_PYRAMID = [(0, 0), (0, 1), (0, 2), (0, 0.5, 1), (0, 1.5, 1), (0, 1, 2)]


def test_flat_pyramid() -> None:
    node = Pyramid(blocks=named(6), base=(3, 1))
    for yaw in YAWS:
        assert holds(node, FLAT_PYRAMID, yaw) and holds(node, FLAT_PYRAMID, yaw, pitch=E)
    assert not holds(node, [p if len(p) < 3 or p[2] < 2 else (0, 3) for p in FLAT_PYRAMID])
    aligned = [(0, 0), (0, 1), (0, 2), (0, 0, 1), (0, 1, 1), (0, 0, 2)]
    assert not holds(node, aligned, pitch=0.07)
    assert not holds(node, [(0, 0), (0, 1), (0, 2), (0, 3), (0, 0.5, 1), (0, 1.5, 1)])


OTHERS = {
    "a line is no triangle": (Figure(blocks=named(3), shape="triangle"), [(0, 0), (0, 1), (0, 2)]),
    "a P is no plus": (Figure(blocks=named(5), shape="plus"), [(0, 0), (0, 1), (0, 2), (1, 0), (1, 1)]),
    "an S is no square": (Figure(blocks=named(4), shape="square"), [(0, 0), (0, 1), (1, 1), (1, 2)]),
    "a T is no L": (Figure(blocks=named(4), shape="L"), [(0, 0), (0, 1), (0, 2), (1, 1)]),
}


@pytest.mark.parametrize("case", OTHERS)
@pytest.mark.parametrize("pitch", [E, PITCH])
def test_blocks_that_plainly_fill_other_cells_are_another_figure(case: str, pitch: float) -> None:
    node, places = OTHERS[case]
    for yaw in YAWS:
        assert not holds(node, places, yaw, pitch=pitch)


@pytest.mark.parametrize("slip", [(0, 0.3), (0.3, 0), (0.25, 0.25)])
def test_a_figure_with_one_block_a_little_out_of_its_cell_is_still_that_figure(slip: tuple[float, float]) -> None:
    plus = [(0, 0), (0, 1), (0, -1), (1, 0), (-1 - slip[0], slip[1])]
    square = [(0, 0), (0, 1), (1, 0), (1 + slip[0], 1 + slip[1])]
    for yaw in YAWS:
        assert holds(Figure(blocks=named(5), shape="plus"), plus, yaw)
        assert holds(Figure(blocks=named(4), shape="square"), square, yaw)


@pytest.mark.parametrize(("off", "fine"), [(0.5, True), (0.25, True), (0.0, False)])
def test_a_pyramid_bridges_the_blocks_below(off: float, fine: bool) -> None:
    assert holds(Pyramid(blocks=named(3), base=(2, 1)), [(0, 0), (0, 1), (0, off, 1)], pitch=E) is fine


def test_square_pyramid() -> None:
    points = [(x, y, 0) for x in range(3) for y in range(3)]
    points += [(x + 0.5, y + 0.5, 1) for x in range(2) for y in range(2)]
    points += [(1, 1, 2)]  # type: ignore[list-item]
    node = Pyramid(blocks=named(14), base=(3, 3))
    for yaw in YAWS:
        assert holds(node, points, yaw)
    off = [p if p[2] != 1 else (p[0] + 1.2, p[1], p[2]) for p in points]
    assert not holds(node, off)


STAIRS = [(0, 0), (0, 1), (0, 2), (0, 1, 1), (0, 2, 1), (0, 2, 2)]
"""Going up to the left."""


def test_staircase() -> None:
    node = Staircase(blocks=named(6), steps=3)
    for yaw in YAWS:
        assert holds(node, STAIRS, yaw)
    for side, yaw in {"left": 0.0, "front": math.pi / 2, "right": math.pi, "back": -math.pi / 2}.items():
        assert holds(node.model_copy(update={"up": side}), STAIRS, yaw)
        assert not holds(node.model_copy(update={"up": side}), STAIRS, yaw + math.pi)
    assert not holds(node, [(0, 0), (0, 1), (0, 2), (0, 0, 1), (0, 2, 1), (0, 2, 2)])
    assert not holds(node, FLAT_PYRAMID, pitch=0.07)


def colored(*colors: str) -> World:
    assets: list[Asset] = [ColoredCube(name=f"b{k}", color=c) for k, c in enumerate(colors)]  # type: ignore[arg-type]
    return World(assets)


FAR_TO_NEAR = [(-r, -c) for r in range(2) for c in range(3)]


def test_rows_lie_along_y() -> None:
    node = Grid(blocks=named(6), rows=2, columns=3)
    assert holds(node, FAR_TO_NEAR) and holds(node, FAR_TO_NEAR, math.radians(40))
    assert not holds(node, FAR_TO_NEAR, math.radians(90)) and not holds(node, FAR_TO_NEAR, math.radians(50))
    named_axis = node.model_copy(update={"axis": "y"})
    assert holds(named_axis, FAR_TO_NEAR, 0.2) and not holds(named_axis, FAR_TO_NEAR, 0.3)
    assert holds(node.model_copy(update={"axis": "x"}), FAR_TO_NEAR, math.pi / 2)
    wall = [(0, c, level) for level in range(2) for c in range(3)]
    for yaw in YAWS:
        assert holds(Grid(blocks=named(6), rows=1, columns=3, layers=2), wall, yaw)


def test_patterns_by_row_and_column() -> None:
    objects = colored("red", "red", "red", "blue", "blue", "blue")
    by_row = Grid(blocks=named(6), rows=2, columns=3, pattern=Pattern(kind="row"))
    good = state(objects, at(FAR_TO_NEAR))  # type: ignore[arg-type]
    assert value(by_row, good)
    pairs = colored("red", "red", "blue", "blue", "green", "green")
    by_column = Grid(blocks=named(6), rows=2, columns=3, pattern=Pattern(kind="column"))
    columns = [(-r, -c) for c in range(3) for r in range(2)]
    assert value(by_column, state(pairs, at(columns)))  # type: ignore[arg-type]
    assert not value(by_column, state(pairs, at(FAR_TO_NEAR)))  # type: ignore[arg-type]
    mixed = colored("red", "blue", "red", "blue", "red", "blue")
    assert not value(by_row, state(mixed, at(FAR_TO_NEAR)))  # type: ignore[arg-type]
    one = colored(*["red"] * 6)
    assert not value(by_row, state(one, at(FAR_TO_NEAR)))  # type: ignore[arg-type]


def test_checkerboard_and_layers() -> None:
    board = colored("red", "blue", "red", "blue", "red", "blue")
    node = Grid(blocks=named(6), rows=2, columns=3, pattern=Pattern(kind="checkerboard"))
    alternating = [(-r, -c) for c in range(3) for r in range(2)]
    assert not value(node, state(board, at(alternating)))  # type: ignore[arg-type]
    swapped = [(-((k + c) % 2), -c) for c in range(3) for k in range(2)]
    assert value(node, state(board, at(swapped)))  # type: ignore[arg-type]
    cube = [(x, y, level) for level in range(2) for x in range(2) for y in range(2)]
    layers = Grid(blocks=named(8), rows=2, columns=2, layers=2, pattern=Pattern(kind="layer"))
    assert value(layers, state(colored(*["red"] * 4, *["blue"] * 4), at(cube)))  # type: ignore[arg-type]
    assert not value(layers, state(colored(*["red", "blue"] * 4), at(cube)))  # type: ignore[arg-type]


def test_reading_order_and_readability() -> None:
    objects = world(letters("ABCDEF"))
    blocks = tuple(f"s{k}" for k in range(6))
    reading = Pattern(kind="reading", order=Order(by="label"))
    node = Grid(blocks=blocks, rows=2, columns=3, pattern=reading, readable=True)
    page = {f"s{k}": (-p[0] * 0 + p[0] * PITCH, p[1] * PITCH) for k, p in enumerate(FAR_TO_NEAR)}
    assert value(node, state(objects, page))
    assert not value(node, state(objects, page, yaw=math.pi))
    assert not value(node, state(objects, page, turns={"s2": yaw_quat(math.pi)}))
    assert not value(node, state(objects, {**page, "s2": page["s3"], "s3": page["s2"]}))
    pyramid = {"s0": (0, 0, 2), "s1": (0, 0.5, 1), "s2": (0, -0.5, 1), "s3": (0, 1), "s4": (0, 0), "s5": (0, -1)}
    places = {name: (p[0], p[1] * PITCH, *p[2:]) for name, p in pyramid.items()}
    down = Pyramid(blocks=blocks, base=(3, 1), pattern=reading, readable=True)
    assert value(down, state(objects, places))  # type: ignore[arg-type]
    up = down.model_copy(update={"pattern": reading.model_copy(update={"upward": True})})
    assert not value(up, state(objects, places))  # type: ignore[arg-type]


def test_orders_around_a_circle() -> None:
    objects = colored(*["red", "blue"] * 4)
    node = Figure(blocks=named(8), shape="circle", pattern=Pattern(kind="reading", order=Order(by="alternating")))
    assert value(node, state(objects, at(ring(8, 0.1), 1.0), yaw=0.4))  # type: ignore[arg-type]
    assert not value(node, state(colored(*["red"] * 4, *["blue"] * 4), at(ring(8, 0.1), 1.0)))  # type: ignore[arg-type]


@pytest.mark.parametrize("shape", sorted(FEWEST))
def test_default_sizes_are_those_of_the_figures(shape: str) -> None:
    for filled in (False, True) if shape in FEWEST_FILLED else (False,):
        count = figure_size(shape, filled)
        node = Figure(blocks=named(count), shape=shape, filled=filled)  # type: ignore[arg-type]
        assert takes(node, count)
        check_built(node, world(cubes(count)), least=3)


def test_sizes() -> None:
    assert figure_size("square", False, (4, 4)) == 12 and figure_size("L", False, (4, 3)) == 6
    assert pyramid_size((3, 1)) == 6 and pyramid_size((3, 3)) == 14 and pyramid_size((4, 3)) == 20
    assert staircase_size(4) == 10 and 0.27 < ring_width(19, 0.04) < 0.28 < ring_width(20, 0.04)
    rows = Grid(blocks=named(27), rows=3, columns=3, layers=3, pattern=Pattern(kind="row"))
    assert line_sizes(rows, 27) == [3] * 9
    assert not takes(Figure(blocks=("a",), shape="square"), 7) and takes(Figure(blocks=("a",), shape="L"), 7)


@pytest.mark.parametrize(
    "node",
    [
        Grid(blocks=named(6), rows=2, columns=3),
        Grid(blocks=named(6), rows=1, columns=3, layers=2, axis="x"),
        Grid(blocks=named(8), rows=2, columns=2, layers=2),
        Grid(blocks=named(27), rows=3, columns=3, layers=3),
        Pyramid(blocks=named(10), base=(4, 1)),
        Pyramid(blocks=named(14), base=(3, 3)),
        Staircase(blocks=named(10), steps=4, up="right"),
        Figure(blocks=named(6), shape="T", pointing="left"),
        Figure(blocks=named(7), shape="V"),
        Figure(blocks=named(12), shape="square"),
        Figure(blocks=named(18), shape="circle"),
    ],
)
def test_built_figures_hold_and_their_near_misses_do_not(node: Cells) -> None:
    check_built(node, world(cubes(len(node.blocks))), least=3)


@pytest.mark.parametrize(
    ("node", "colors"),
    [
        (Grid(blocks=named(9), rows=3, columns=3, pattern=Pattern(kind="row")), "red " * 3 + "blue " * 3 + "pink " * 3),
        (Grid(blocks=named(9), rows=3, columns=3, pattern=Pattern(kind="checkerboard")), "red " * 5 + "blue " * 4),
        (Pyramid(blocks=named(6), base=(3, 1), pattern=Pattern(kind="layer")), "red " * 3 + "blue " * 2 + "pink"),
    ],
)
def test_built_patterns(node: Cells, colors: str) -> None:
    check_built(node, colored(*colors.split()), least=4)


def test_supports_of_a_pyramid_in_reading_order() -> None:
    objects = world(letters("ABC"))
    pattern = Pattern(kind="reading", order=Order(by="label"))
    node = Pyramid(blocks=("s0", "s1", "s2"), base=(2, 1), pattern=pattern)
    edges = set(PREDICATES["pyramid"].supports(node, objects))
    assert edges == {("s1", "table"), ("s2", "table"), ("s0", "s1"), ("s0", "s2")}
    assert not list(PREDICATES["pyramid"].supports(node.model_copy(update={"pattern": None}), objects))


GROUPS = (("r1", "r2"), ("b1", "b2"))
SORTED = {"r1": (0.0, 0.0), "r2": (0.0, 0.06), "b1": (0.0, 0.2), "b2": (0.0, 0.26)}


def grouped(node: GroupBy, **changed: tuple[float, ...]) -> bool:
    objects = world(plain(r1="red", r2="red", b1="blue", b2="blue"))
    for yaw in YAWS[1:]:
        whole = state(objects, {**SORTED, **changed}, yaw=yaw)  # type: ignore[arg-type]
        assert value(node, whole) == value(node, state(objects, {**SORTED, **changed}))  # type: ignore[arg-type]
    return value(node, state(objects, {**SORTED, **changed}))  # type: ignore[arg-type]


def test_groups_lie_apart() -> None:
    node = GroupBy(groups=GROUPS, by="color")
    assert grouped(node)
    assert grouped(node, r2=(0.0, 0.039), r1=(0.0, -0.08))
    assert not grouped(node, r1=(0.0, -0.061)), "a member too far from its group"
    assert grouped(node, r2=(0.0, 0.0, 1)), "stacks count as groups"
    assert grouped(node, b1=(0.0, 0.161), b2=(0.0, 0.22)) and not grouped(node, b1=(0.0, 0.159), b2=(0.0, 0.22))
    assert not grouped(node, r2=(0.0, 0.26), b2=(0.0, 0.06))
    wide = {"r1": (0.0, -0.05), "b1": (0.0, 0.165), "b2": (0.0, 0.22)}
    assert not grouped(node, **wide), "groups must be farther apart than any gap inside one"


def test_outliers() -> None:
    objects = world(cubes(3, "red", "r"), cubes(3, "blue", "b"))
    groups = (tuple(f"r{k}" for k in range(3)), tuple(f"b{k}" for k in range(3)))
    node = GroupBy(groups=groups, by="color", outliers=1)
    here = {f"r{k}": (0.0, 0.05 * k) for k in range(3)} | {f"b{k}": (0.0, 0.3 + 0.05 * k) for k in range(3)}
    assert not value(node, state(objects, here))
    one = {**here, "r0": here["b0"], "b0": here["r0"]}
    assert value(node, state(objects, one))
    two = {**one, "r1": here["b1"], "b1": here["r1"]}
    assert value(node, state(objects, two)), "two of the other colour make that one the stranger"
    assert not value(node, state(objects, {**one, "b0": (0.0, 0.45)}))
    check_built(node, objects, least=3)
    check_built(GroupBy(groups=groups, by="color"), objects, least=3)


@pytest.mark.parametrize("seed", range(30))
def test_figures_survive_placing_that_is_not_exact(seed: int) -> None:
    """Rotated anywhere, shifted by up to a fifth of an edge per block, whichever block is in which cell."""
    rng = Random(seed)
    nodes = [
        Grid(blocks=named(9), rows=3, columns=3),
        Figure(blocks=named(8), shape="circle"),
        Figure(blocks=named(4), shape="L"),
        Figure(blocks=named(6), shape="triangle"),
        Figure(blocks=named(10), shape="rectangle"),
        Pyramid(blocks=named(14), base=(3, 3)),
        Staircase(blocks=named(6), steps=3),
    ]
    for node in nodes:
        objects = world(cubes(len(node.blocks)))
        built = placed(next(iter(PREDICATES[node.kind].build(node, objects, rng))), objects)
        names = list(node.blocks)
        rng.shuffle(names)
        turn, places = rng.uniform(0, 6.3), {}
        for name, old in zip(names, node.blocks, strict=True):
            x, y, z = built.position[old]
            x, y = x - 0.55 + rng.uniform(-0.008, 0.008), y + rng.uniform(-0.008, 0.008)
            c, s = math.cos(turn), math.sin(turn)
            places[name] = (0.5 + c * x - s * y, 0.1 + s * x + c * y, z)
        moved = BlockState(objects, places, {name: yaw_quat(turn) for name in names})
        assert value(node, moved), (node.kind, PREDICATES[node.kind].evaluate(node, moved))


def test_every_form_of_a_figure_has_its_number_of_cells() -> None:
    for count in range(3, 14):
        for shape in sorted(FEWEST):
            node = Figure(blocks=named(count), shape=shape)  # type: ignore[arg-type]
            for ideal in ideals(node, count):
                spots = {(round(c.x, 3), round(c.y, 3)) for c in ideal.cells}
                assert len(spots) == count
