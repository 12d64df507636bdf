"""Figures with two or three parts, and what the parts are called."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from random import Random

from tests.corpus.composed.building import shapes
from tests.corpus.composed.building.letters import name_of
from tests.corpus.composed.building.shapes import Cell, Figure
from tests.corpus.composed.ordering.phrased import NUMBERS

LOW = "the bottom layer|the lower layer|the bottom row|the lower row|the lowest layer|the layer at the bottom"
HIGH = "the top layer|the upper layer|the top row|the upper row|the topmost layer|the layer on top"
MID = "the middle layer|the middle row|the layer in the middle|the second layer"
BASE = "the base|the bottom layer|the bottom row|the lowest row|the lowest layer"
TIP = "the tip|the top|the apex|the peak|the top block|the block at the top|the topmost block|the uppermost block"
CORNERS = (
    "the corners|the four corners|all four corners|the corner blocks|the blocks at the corners|the four corner blocks"
)
CENTRE = "the middle block|the centre|the block in the middle|the center|the middle|the central block|the centre block"
BORDER = "the border|the outer blocks|the outside|the edge|the frame"
ENDS = "the ends|both ends|the two ends|the end blocks|the two outer blocks|the blocks at the ends|the outermost blocks"
FAR = "the far row|the back row|the row at the back|the row farthest away|the rear row|the farther row"
NEAR = "the near row|the front row|the nearest row|the row in front|the row nearest to me|the nearer row"
LEFT = "the left column|the leftmost column|the column on the left|the left-hand column"
RIGHT = "the right column|the rightmost column|the column on the right|the right-hand column"
BLOCKS = "[blocks|cubes|bricks]"


@dataclass(frozen=True)
class Part:
    """What a part is called, with `|` between names; nothing where it is only what is left. And its cells."""

    names: str
    cells: tuple[Cell, ...]


@dataclass(frozen=True)
class Parted:
    """A figure, how people tell of it without any colour, its parts, and whether the last may be called the rest."""

    short: str
    figure: Figure
    said: str
    parts: tuple[Part, ...]
    rest: bool = True


def split(figure: Figure, names: str, cells: Iterable[Cell]) -> tuple[Part, ...]:
    """A part and the rest."""
    inside = tuple(cells)
    return Part(names, inside), Part("", tuple(cell for cell in figure.cells if cell not in inside))


def lines(figure: Figure, axis: int, *names: str) -> tuple[Part, ...]:
    """Its rows from the far one, its columns from the left, or its layers from the bottom."""
    return tuple(Part(name, tuple(c for c in figure.cells if c[axis] == k)) for k, name in enumerate(names))


def wall(rng: Random) -> Parted:
    wide, high = rng.choice(((3, 2), (4, 2), (2, 3), (3, 3)))
    figure, m, n = shapes.cuboid(1, wide, high), NUMBERS[wide], NUMBERS[high]
    said = (
        f"[a wall {m} wide and {n} high|a wall of {n} layers of {m} blocks|a wall, {m} blocks long and {n} high|a wall "
        f"{m} {BLOCKS} wide and {n} {BLOCKS} high|a wall of {NUMBERS[wide * high]} blocks, {m} wide]"
    )
    if wide == 3 and rng.random() < 0.3:
        parts = lines(figure, 1, LEFT, "the middle column|the column in the middle", RIGHT)
        return Parted("wall", figure, said, parts, rest=False)
    return Parted("wall", figure, said, lines(figure, 2, LOW, *([MID] if high == 3 else []), HIGH), rest=high == 2)


def tower(rng: Random) -> Parted:
    high = rng.choice((3, 3, 4, 5))
    figure, m = shapes.cuboid(1, 1, high), NUMBERS[high]
    said = (
        f"[a tower of {m}|a [tower|stack] of {m} {BLOCKS}|a tower with {m} blocks|a tower {m} blocks high|a tower, {m} "
        f"{BLOCKS} high|a tower with {m} storeys]"
    )
    top = "the top block|the topmost block|the uppermost one|the highest block|the one on top|the block at the top"
    bottom = "the bottom block|the lowest block|the lowest one|the one at the bottom|the block at the bottom"
    middle = "the middle block|the block in the middle|the middle one|the one in the middle"
    if high == 3 and rng.random() < 0.3:
        return Parted("tower", figure, said, lines(figure, 2, bottom, middle, top), rest=False)
    choices = [(bottom, 0), (top, high - 1), *([(middle, high // 2)] if high % 2 else [])]
    names, level = rng.choice(choices)
    return Parted("tower", figure, said, split(figure, names, [(0, 0, level)]))


def row(rng: Random) -> Parted:
    long = rng.choice((3, 4, 5))
    figure, m = shapes.line(long), NUMBERS[long]
    said = f"[a row of {m}|a [row|line] of {m} {BLOCKS}|{m} blocks in a row|a row with {m} {BLOCKS}]"
    left = "the leftmost block|the left end|the block at the left end|the leftmost one|the first block from the left"
    right = "the rightmost block|the right end|the block at the right end|the one on the far right"
    middle = "the middle block|the one in the middle|the block in the middle|the middle one"
    inner = "the inner blocks|the blocks between them|the ones in between|the rest|the others"
    ends, rest = ((0, 0, 0), (0, long - 1, 0)), figure.cells[1:-1]
    if rng.random() < 0.5:
        parts = (Part(ENDS, ends), Part(inner if long > 3 else middle, rest))
        return Parted("row", figure, said, parts, rest=long > 3)
    choices = [(left, 0), (right, long - 1), *([(middle, long // 2)] if long % 2 else [])]
    names, column = rng.choice(choices)
    return Parted("row", figure, said, split(figure, names, [(0, column, 0)]))


def grid(rng: Random) -> Parted:
    rows, columns = rng.choice(((2, 3), (2, 2), (3, 3), (2, 4), (3, 2)))
    figure, m, n = shapes.cuboid(rows, columns), NUMBERS[rows], NUMBERS[columns]
    said = f"[a grid [of|with] {m} rows and {n} columns|a {rows}x{columns} grid of blocks|a grid, {m} rows of {n}]"
    if rows == columns or rng.random() < 0.3:
        said = f"[{said}|a {m} by {n} grid]"
    if columns <= 3 and rng.random() < 0.4:
        names = [LEFT, RIGHT] if columns == 2 else [LEFT, "the middle column|the column in the middle", RIGHT]
        return Parted("grid", figure, said, lines(figure, 1, *names), rest=columns == 2)
    names = [FAR, NEAR] if rows == 2 else [FAR, "the middle row|the row in the middle", NEAR]
    return Parted("grid", figure, said, lines(figure, 0, *names), rest=rows == 2)


def cube(rng: Random) -> Parted:
    figure = shapes.cuboid(2, 2, 2)
    said = (
        "[a 2x2x2 cube|a big cube, 2 by 2 by 2|a cube of eight blocks|a big cube from eight blocks|a solid 2 x 2 x 2 "
        "cube|a big cube made of eight blocks|a two by two by two cube]"
    )
    halves = "the bottom half|the lower half|the lower four blocks", "the top half|the upper half|the top four blocks"
    return Parted("cube", figure, said, lines(figure, 2, *rng.choice(((LOW, HIGH), halves))))


def pyramid(rng: Random) -> Parted:
    if rng.random() < 0.35:
        figure = shapes.square_pyramid(2)
        said = (
            "[a square pyramid with a 2x2 base|a square pyramid of five blocks|a pyramid on a square base of two by two"
            "|a 2x2 pyramid|a pyramid with a square base of four blocks]"
        )
        base = "the base|the bottom layer|the four at the bottom|the lower four|the bottom blocks"
        return Parted("pyramid", figure, said, lines(figure, 2, base, TIP))
    base = rng.choice((2, 3, 3))
    figure, m = shapes.pyramid(base), NUMBERS[base]
    said = (
        f"[a [flat|] pyramid of {NUMBERS[base * (base + 1) // 2]} blocks|a pyramid with {m} at the bottom|a pyramid "
        f"with a base of {m} blocks]"
    )
    if base == 3 and rng.random() < 0.4:
        parts = lines(figure, 2, BASE, "the middle layer|the middle row|the second row|the layer in between", TIP)
        return Parted("pyramid", figure, said, parts, rest=False)
    names, cells = rng.choice(((TIP, figure.cells[-1:]), (BASE, figure.cells[:base])))
    return Parted("pyramid", figure, said, split(figure, names, cells))


def staircase(rng: Random) -> Parted:
    steps, left = rng.choice((2, 3, 3)), rng.random() < 0.5
    figure, m, side = shapes.stairs(steps, left=left), NUMBERS[steps], ("right", "left")[left]
    said = (
        f"[a staircase [of|with] {m} steps [going up|rising] to the {side}|a staircase of {NUMBERS[len(figure.cells)]} "
        f"blocks that goes up to the {side}|a {m}-step staircase going up to the {side}|a staircase of {m} steps, "
        f"going up to the {side}]"
    )
    low = "the lowest step|the first step|the bottom step|the smallest step"
    high = "the highest step|the top step|the last step|the tallest step"
    parts = lines(figure, 1, *((high, low) if left else (low, high))) if steps == 2 else ()
    if steps == 3:
        middle = "the middle step|the second step|the step in the middle"
        parts = lines(figure, 1, *((high, middle, low) if left else (low, middle, high)))
    if steps == 3 and rng.random() < 0.4:
        return Parted("staircase", figure, said, parts, rest=False)
    if rng.random() < 0.3:
        top = "the top block of the highest step|the block at the top of the highest step|the topmost block"
        return Parted("staircase", figure, said, split(figure, top, [max(figure.cells, key=lambda c: c[2])]))
    part = rng.choice((parts[0], parts[-1]))
    return Parted("staircase", figure, said, split(figure, part.names, part.cells))


def square(rng: Random) -> Parted:
    around = tuple(c for c in shapes.RING.cells if c[0] != 1 and c[1] != 1)
    if rng.random() < 0.4:
        said = (
            "[a square outline of eight blocks|the outline of a square, eight blocks|a hollow square of 8 blocks|a "
            "hollow square, three blocks per side|an outline square of eight blocks]"
        )
        return Parted("square", shapes.RING, said, split(shapes.RING, CORNERS, around))
    figure = shapes.cuboid(3, 3)
    said = (
        "[a filled 3x3 square|a 3 by 3 square, filled|a filled square of nine blocks|a 3x3 grid|a filled square, three "
        "per side|a three by three grid of blocks|a solid 3x3 square]"
    )
    if rng.random() < 0.4:
        return Parted("square", figure, said, (Part(CENTRE, ((1, 1, 0),)), Part(BORDER, shapes.RING.cells)))
    names, cells = rng.choice(((CENTRE, ((1, 1, 0),)), (CORNERS, around)))
    return Parted("square", figure, said, split(figure, names, cells))


def letter(rng: Random) -> Parted:
    name = rng.choice("LTUV")
    figure = {"L": shapes.L["right"], "T": shapes.T["me"], "U": shapes.U["far"], "V": shapes.V["me"]}[name]
    said = f"[{name_of(name)} [of|out of|from|made of] {NUMBERS[len(figure.cells)]} {BLOCKS}]"
    if name == "T":
        bar, stem = "the bar|the crossbar|the cross bar|the top bar", "the stem|the foot|the leg|the rest"
        parts: tuple[Part, ...] = (Part(bar, figure.cells[:3]), Part(stem, figure.cells[3:]))
        return Parted(name, figure, said, parts, rest=False)
    names, cells = {
        "L": ("the corner|the corner block|the block at the corner", [(2, 0, 0)]),
        "U": ("the corners|the two corners|the two corner blocks|both corners", [(2, 0, 0), (2, 2, 0)]),
        "V": ("the tip|the point|the block at the tip", [(2, 2, 0)]),
    }[name]
    return Parted(name, figure, said, split(figure, names, cells))


def plus(_: Random) -> Parted:
    said = f"[a [plus sign|plus|plus shape|cross] [of|made of|out of] five {BLOCKS}]"
    arms = "the arms|the four arms|the outer blocks|the rest|the others"
    middle, outside = Part(CENTRE, ((1, 1, 0),)), tuple(c for c in shapes.PLUS.cells if c != (1, 1, 0))
    return Parted("plus", shapes.PLUS, said, (middle, Part(arms, outside)), rest=False)


KINDS: tuple[Callable[[Random], Parted], ...] = (
    wall, tower, row, grid, cube, pyramid, staircase, square, letter, plus,
)  # fmt: skip
