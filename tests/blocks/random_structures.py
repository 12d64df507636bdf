"""Random structure goals, each with blocks that can form it."""

from __future__ import annotations

from collections.abc import Callable
from random import Random

from rpg.blocks.figures import FEWEST, FEWEST_FILLED, figure_size, line_sizes, pyramid_size, staircase_size, takes
from rpg.ir.assets import Asset, ColoredCube, SemanticCube
from rpg.ir.node import Node
from rpg.ir.order import Order, Pattern
from rpg.ir.structures import Cells, Equation, Figure, Grid, GroupBy, Pyramid, Row, Spells, Stack, Staircase, Towers

COLORS = ("red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink", "brown", "black", "white")
SYMBOLS = {"label": "ABCDEFGHIJKLMNOPQRSTUVWXYZ", "number": "0123456789"}
Made = tuple[Node, list[Asset]]


def blocks(rng: Random, count: int) -> tuple[list[Asset], str]:
    """Plain cubes of a few colours, letters or digits, and how their sort is put in order."""
    by = rng.choice(["rainbow", "label", "number"])
    if by == "rainbow":
        few = rng.sample(COLORS[:8], rng.randint(1, min(count, 5)))
        return [ColoredCube(name=f"b{k}", color=rng.choice(few)) for k in range(count)], by  # type: ignore[arg-type]
    return [SemanticCube(name=f"b{k}", label=rng.choice(SYMBOLS[by])) for k in range(count)], by


def names(assets: list[Asset]) -> tuple[str, ...]:
    return tuple(asset.name for asset in assets)


def order(rng: Random, assets: list[Asset], by: str, sides: tuple[str, ...]) -> Order:
    first = rng.choice([None, *sides])
    match rng.choice(["any", "given", "together", by, by]):
        case "given":
            pool = list(names(assets))
            rng.shuffle(pool)
            free = rng.choice([1, len(pool) // 2 + 1])
            ranks = (tuple(pool[:free]), *((name,) for name in pool[free:]))
            return Order(by="given", ranks=ranks, first=first)  # type: ignore[arg-type]
        case "together":
            return Order(by="together", attribute="color" if by == "rainbow" else "label", first=first)  # type: ignore[arg-type]
        case "any":
            return Order()
        case sort:
            return Order(by=sort, descending=rng.random() < 0.3, first=first)  # type: ignore[arg-type]


def stack(rng: Random) -> Made:
    assets, by = blocks(rng, rng.randint(2, 6))
    readable = by != "rainbow" and rng.random() < 0.5
    put = order(rng, assets, by, ("bottom", "top"))
    return Stack(blocks=names(assets), order=put, exact=rng.random() < 0.5, readable=readable), assets


def towers(rng: Random) -> Made:
    height, count = rng.randint(2, 3), rng.randint(2, 3)
    assets, _ = blocks(rng, height * count)
    return Towers(blocks=names(assets), count=rng.choice([None, count]), equal=rng.random() < 0.3), assets


def row(rng: Random) -> Made:
    assets, by = blocks(rng, rng.randint(2, 6))
    axis = rng.choice(["x", "y"])
    put = order(rng, assets, by, ("front", "back") if axis == "x" else ("left", "right"))
    spacing = rng.choice([{}, {"touching": True}, {"evenly": True}, {"spacing": 0.055}, {"gap": 0.012}])
    named = axis if put.first is None or rng.random() < 0.5 else None
    readable = by != "rainbow" and rng.random() < 0.5 and axis == "y"
    if axis == "y" and not readable and len(assets) < 6 and rng.random() < 0.3:
        named = rng.choice(["rising", "falling", "diagonal"])
    return Row(blocks=names(assets), axis=named, order=put, readable=readable, **spacing), assets  # type: ignore[arg-type]


def spells(rng: Random) -> Made:
    word, spare = rng.choice(["CAT", "ROBOT", "NOON", "TEA"]), rng.choice(["", "S", "QT"])
    assets: list[Asset] = [SemanticCube(name=f"b{k}", label=letter) for k, letter in enumerate(word + spare)]
    along = rng.choice(["row", "stack"])
    return Spells(blocks=names(assets), word=word, along=along, reverse=rng.random() < 0.3), assets  # type: ignore[arg-type]


def equation(rng: Random) -> Made:
    text = rng.choice(["2+3=5", "1+2*3=7", "8/4=2", "9-4=5", "6/4=3/2", "1+1+1=3"])
    assets: list[Asset] = [SemanticCube(name=f"b{k}", label=symbol) for k, symbol in enumerate(text)]
    along, fixed = rng.choice(["row", "stack"]), rng.choice([None, text])
    return Equation(blocks=names(assets), along=along, text=fixed), assets  # type: ignore[arg-type]


def group_by(rng: Random) -> Made:
    sizes = [rng.randint(1, 4) for _ in range(rng.randint(2, 4))]
    groups = tuple(tuple(f"{COLORS[k]}{j}" for j in range(size)) for k, size in enumerate(sizes))
    assets: list[Asset] = [ColoredCube(name=n, color=COLORS[k]) for k, g in enumerate(groups) for n in g]  # type: ignore[arg-type]
    return GroupBy(groups=groups, by="color", outliers=int(min(sizes) > 2)), assets


def cells(rng: Random) -> Made:
    make, count = _shape(rng)
    assets, by = blocks(rng, count)
    plain = make(names(assets), None, False)
    match rng.choice(["none", "reading", "lines"]):
        case "reading":
            reading = Pattern(kind="reading", order=order(rng, assets, by, ()), upward=rng.random() < 0.3)
            return make(names(assets), reading, by != "rainbow" and rng.random() < 0.5), assets
        case "lines" if not isinstance(plain, Figure):
            pattern = Pattern(kind=rng.choice(["row", "column", "layer", "checkerboard"]))
            node = make(names(assets), pattern, False)
            sizes = line_sizes(node, count)
            if len(sizes) <= len(COLORS):
                colors = [COLORS[k] for k, size in enumerate(sizes) for _ in range(size)]
                return node, [ColoredCube(name=f"b{k}", color=c) for k, c in enumerate(colors)]  # type: ignore[arg-type]
    return plain, assets


def _shape(rng: Random) -> tuple[Callable[[tuple[str, ...], Pattern | None, bool], Cells], int]:
    kind = rng.choice(["grid", "pyramid", "staircase", "figure", "figure"])
    if kind == "grid":
        rows, columns, layers = rng.choice(
            [(2, 3, 1), (3, 3, 1), (2, 4, 1), (1, 3, 2), (2, 2, 2), (3, 3, 2), (4, 4, 1)]
        )
        axis = rng.choice([None, None, "x", "y"])
        gap, tolerance = rng.choice([(None, 0.01), (None, 0.01), (0.0, 0.002), (0.015, 0.01)])
        return (
            lambda b, p, r: Grid(
                gap=gap,
                tolerance=tolerance,
                blocks=b,
                pattern=p,
                readable=r,
                rows=rows,
                columns=columns,
                layers=layers,
                axis=axis,  # type: ignore[arg-type]
            )
        ), rows * columns * layers
    if kind == "pyramid":
        base = rng.choice([(2, 1), (3, 1), (4, 1), (2, 2), (3, 3), (3, 2)])
        return (lambda b, p, r: Pyramid(blocks=b, pattern=p, readable=r, base=base)), pyramid_size(base)
    if kind == "staircase":
        steps, up = rng.randint(2, 4), rng.choice([None, "left", "right", "front", "back"])
        return (
            lambda b, p, r: Staircase(blocks=b, pattern=p, readable=r, steps=steps, up=up)  # type: ignore[arg-type]
        ), staircase_size(steps)
    shape = rng.choice(sorted(FEWEST))
    filled = shape in FEWEST_FILLED and rng.random() < 0.3
    pointing = rng.choice([None, "left", "back"]) if shape in ("L", "T", "U", "V", "triangle") else None
    sizes = [n for n in range(4, 13) if takes(Figure(blocks=("",), shape=shape, filled=filled), n)]  # type: ignore[arg-type]
    count = rng.choice([figure_size(shape, filled), *sizes])
    return (
        lambda b, p, r: Figure(
            blocks=b,
            pattern=p,
            readable=r,
            shape=shape,
            filled=filled,
            pointing=pointing,  # type: ignore[arg-type]
        )
    ), count


MAKERS = (stack, towers, row, row, spells, equation, group_by, cells, cells, cells)


def random_structure(seed: int) -> Made:
    rng = Random(seed)
    return rng.choice(MAKERS)(rng)
