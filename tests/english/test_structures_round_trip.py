"""Structures, counts, stages and sizes: what they are described as compiles back to the same task."""

from __future__ import annotations

from itertools import groupby

import pytest

from rpg.blocks.english import describe
from rpg.blocks.equivalence import equivalent
from rpg.blocks.figure_parts import own_parts
from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.assets import Asset, Color, ColoredCube, GoalPatch, SemanticCube
from rpg.ir.node import Lowest
from rpg.ir.order import Order, Pattern
from rpg.ir.schema import TaskSchema
from rpg.ir.walk import names
from rpg.passes.schema.frontend import BuiltinFrontEnd
from rpg.store.taskfile import dump_schema, parse_schema
from tests.english.schemas import begun


def cubes(count: int, color: Color = "red") -> tuple[Asset, ...]:
    return tuple(ColoredCube(name=f"{color}_block_{i}", color=color) for i in range(1, count + 1))


def symbols(labels: str) -> tuple[Asset, ...]:
    return tuple(SemanticCube(name=f"symbol_{ord(label)}_{i}", label=label) for i, label in enumerate(labels))


def of(assets: tuple[Asset, ...]) -> tuple[str, ...]:
    return tuple(asset.name for asset in assets)


def given(assets: tuple[Asset, ...], **first: str) -> Order:
    return Order.model_validate({"by": "given", "ranks": [(name,) for name in of(assets)], **first})


def by_parts(part: str, figure: s.Cells, count: int) -> tuple[tuple[Asset, ...], g.Goal]:
    """A figure with one part green and the rest pink."""
    places = own_parts(figure, count)[part]
    green, pink = cubes(len(places), "green"), cubes(count - len(places), "pink")
    stock = {True: [*of(green)], False: [*of(pink)]}
    runs = groupby(range(count), key=places.__contains__)
    ranks = tuple(tuple(stock[inside].pop(0) for _ in run) for inside, run in runs)
    pattern = Pattern(kind="reading", order=Order(by="given", ranks=ranks), own=True)
    return green + pink, figure.model_copy(update={"blocks": of(green + pink), "pattern": pattern})  # type: ignore[return-value]


FIVE, SIX, EIGHT = cubes(5), cubes(6), cubes(8)
RED, BLUE = cubes(3), cubes(2, "blue")
MIXED = RED + BLUE
GREEN: tuple[Asset, ...] = (ColoredCube(name="green_block", color="green"),)
PATCH: tuple[Asset, ...] = (GoalPatch(name="yellow_patch", color="yellow"),)
COLORS: tuple[Color, ...] = ("orange", "pink", "white", "black")
FOUR: tuple[Asset, ...] = tuple(ColoredCube(name=f"{color}_block", color=color) for color in COLORS)
LETTERS, DIGITS, SUM = symbols("ABCD"), symbols("1234"), symbols("2+3=5")
SMALL_AND_BIG: tuple[Asset, ...] = (
    ColoredCube(name="red_block", color="red", size=0.03),
    ColoredCube(name="blue_block", color="blue", size=0.05),
)
EACH = (g.EACH,)

CASES: tuple[tuple[tuple[Asset, ...], g.Goal], ...] = (
    (SIX, s.Towers(blocks=of(SIX), count=2)),
    (SIX, s.Towers(blocks=of(SIX), count=3)),
    (SIX, s.Towers(blocks=of(SIX), count=2, equal=True)),
    (RED, s.Stack(blocks=of(RED), exact=True)),
    (FOUR, s.Stack(blocks=of(FOUR), order=given(FOUR, first="top"))),
    (LETTERS, s.Stack(blocks=of(LETTERS), order=Order(by="label", first="top"), readable=True)),
    (DIGITS, s.Stack(blocks=of(DIGITS), order=Order(by="number", first="bottom"), readable=True)),
    (RED + PATCH, s.Stack(blocks=of(RED), exact=True, patch="yellow_patch")),
    (FOUR + PATCH, s.Stack(blocks=of(FOUR), order=given(FOUR), patch="yellow_patch")),
    (LETTERS, s.Row(blocks=of(LETTERS), axis="y", order=Order(by="label", first="left"), readable=True)),
    (
        LETTERS,
        s.Row(blocks=of(LETTERS), axis="y", order=Order(by="label", descending=True, first="left"), readable=True),
    ),
    (DIGITS, s.Row(blocks=of(DIGITS), axis="y", order=Order(by="number", first="left"), readable=True)),
    (DIGITS, s.Row(blocks=of(DIGITS), axis="x", order=Order(by="number", first="front"), readable=True)),
    (FOUR, s.Row(blocks=of(FOUR), axis="y")),
    (SIX, s.Row(blocks=of(SIX), axis="y", evenly=True)),
    (SIX, s.Row(blocks=of(SIX), axis="y", touching=True)),
    (SIX, s.Row(blocks=of(SIX), axis="y", spacing=0.06)),
    (SIX, s.Row(blocks=of(SIX), axis="y", gap=0.03)),
    (MIXED, s.Row(blocks=of(MIXED), axis="y", order=Order(by="alternating"))),
    (MIXED, s.Row(blocks=of(MIXED), axis="y", order=Order(by="mirrored"))),
    (FOUR, s.Row(blocks=of(FOUR), axis="y", order=Order(by="rainbow", first="left"))),
    (SIX, s.Grid(blocks=of(SIX), rows=2, columns=3)),
    (SIX, s.Grid(blocks=of(SIX), rows=1, columns=3, layers=2)),
    (EIGHT, s.Grid(blocks=of(EIGHT), rows=2, columns=2, layers=2)),
    (SIX, s.Pyramid(blocks=of(SIX), base=(3, 1))),
    (FIVE, s.Pyramid(blocks=of(FIVE), base=(2, 2))),
    (SIX, s.Staircase(blocks=of(SIX), steps=3)),
    (SIX, s.Staircase(blocks=of(SIX), steps=3, up="right")),
    (EIGHT, s.Figure(blocks=of(EIGHT), shape="circle")),
    (EIGHT, s.Figure(blocks=of(EIGHT), shape="square")),
    (SIX, s.Figure(blocks=of(SIX), shape="triangle")),
    (FIVE, s.Figure(blocks=of(FIVE), shape="L")),
    (FIVE, s.Figure(blocks=of(FIVE), shape="L", pointing="right")),
    (FIVE, s.Figure(blocks=of(FIVE), shape="plus")),
    (MIXED, s.GroupBy(groups=(of(RED), of(BLUE)), by="color")),
    (LETTERS + DIGITS, s.GroupBy(groups=(of(LETTERS), of(DIGITS)), by="kind")),
    (symbols("CAT"), s.Spells(blocks=of(symbols("CAT")), word="CAT")),
    (symbols("CAT"), s.Spells(blocks=of(symbols("CAT")), word="CAT", along="stack")),
    (symbols("CAT"), s.Spells(blocks=of(symbols("CAT")), word="CAT", reverse=True)),
    (SUM, s.Equation(blocks=of(SUM), text="2+3=5")),
    (SUM, s.Equation(blocks=of(SUM))),
    (RED + PATCH, g.Count(over=of(RED), at_most=1, goal=g.OnPatch(a=EACH, patch="yellow_patch"))),
    (RED + GREEN, g.Count(over=of(RED), at_least=2, at_most=2, goal=g.Beside(a=EACH, b="green_block"))),
    (RED + GREEN, g.LeftOf(a=of(RED), b="green_block")),
    (MIXED, g.RightOf(a=of(RED), b=of(BLUE))),
    (
        RED + GREEN,
        g.All(goals=(s.Stack(blocks=of(RED), exact=True), g.Beside(a="green_block", b=Lowest(lowest=of(RED))))),
    ),
    (
        FOUR,
        g.Sequence(
            stages=(
                g.Stage(goal=g.On(a="orange_block", b="pink_block")),
                g.Stage(goal=g.On(a="white_block", b="orange_block")),
            )
        ),
    ),
    (FOUR, g.All(goals=(g.On(a="orange_block", b="pink_block"), g.Always(goal=g.OnTable(a="white_block"))))),
    (LETTERS[:1], g.Facing(block=LETTERS[0].name, label="A", turn=180.0)),
    (LETTERS[:1], g.Facing(block=LETTERS[0].name, label="A", turn=0.0)),
    (SMALL_AND_BIG, g.On(a="red_block", b="blue_block")),
    by_parts("the corner", s.Figure(blocks=("",), shape="L"), 5),
    by_parts("the corner", s.Figure(blocks=("",), shape="L", pointing="left"), 5),
    by_parts("the bar", s.Figure(blocks=("",), shape="T"), 5),
    by_parts("the two corners", s.Figure(blocks=("",), shape="U", pointing="front"), 7),
    by_parts("the two ends", s.Figure(blocks=("",), shape="U"), 7),
    by_parts("the point", s.Figure(blocks=("",), shape="V"), 5),
    by_parts("the three corners", s.Figure(blocks=("",), shape="triangle"), 6),
    by_parts("the lowest step", s.Staircase(blocks=("",), steps=3), 6),
    by_parts("the second step", s.Staircase(blocks=("",), steps=3, up="left"), 6),
    by_parts("the highest step", s.Staircase(blocks=("",), steps=3, up="right"), 6),
    by_parts("the top block of the highest step", s.Staircase(blocks=("",), steps=2), 3),
)


@pytest.mark.parametrize(("assets", "goal"), CASES)
def test_description_compiles_to_an_equivalent_task(assets: tuple[Asset, ...], goal: g.Goal) -> None:
    mentioned = set(names(goal))
    used = tuple(asset for asset in assets if asset.name in mentioned)
    schema = begun(TaskSchema(name="case", instruction="case", assets=used, goal=goal))
    text = describe(schema)
    read, diagnostics = BuiltinFrontEnd().read(text)
    assert read is not None, f"{text}\n{diagnostics}"
    assert equivalent(schema, read), f"{text}\n{read.goal}"
    assert parse_schema(dump_schema(schema)) == schema
