"""Feasibility in four steps: what there is, what is needed, what cannot be, and what would mend it."""

from __future__ import annotations

import re

import pytest

from rpg.core.diagnostics import Diagnostic
from rpg.ir import goal as g
from rpg.ir.assets import SemanticCube
from rpg.ir.order import Order
from rpg.ir.relations import Facing, On
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Row, Spells, Stack
from rpg.ir.walk import atoms
from rpg.passes.schema.feasibility import Repairable, examine
from rpg.passes.schema.feasibility.inventory import take_stock
from rpg.passes.schema.feasibility.requirements import Grip, Ordering, Reach, Room, Sight, Symbols, requirements
from rpg.passes.schema.frontend import BuiltinFrontEnd
from rpg.pipeline import compile_instruction, compile_schema
from tests.passes import tasks
from tests.passes.tasks import task

REDUCE, REORDER, SPATIAL = (
    "REDUCE_LABELS_PRESERVE_GEOMETRY",
    "SWITCH_ORDERING_PATTERN",
    "SWITCH_TO_SPATIAL_ONLY",
)


def letters(symbols: str) -> tuple[SemanticCube, ...]:
    return tuple(SemanticCube(name=f"{symbol}_block", label=symbol) for symbol in symbols)


def row(symbols: str, **fields: object) -> TaskSchema:
    cubes = letters(symbols)
    return task("row", cubes, Row(blocks=tuple(cube.name for cube in cubes), axis="y", **fields))  # type: ignore[arg-type]


def refused(text: str) -> Diagnostic:
    """The one diagnostic of an instruction that is refused."""
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is None
    (diagnostic,) = diagnostics
    return diagnostic


def read(text: str) -> TaskSchema:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is not None, diagnostics
    return schema


# Asset analysis.


def test_the_inventory_counts_what_blocks_show() -> None:
    stock = take_stock(task("mixed", (*letters("AB7"), tasks.cube("red")), On(a=("A_block",), b=("B_block",))), {})
    assert stock.of("letter") == ("A_block", "B_block")
    assert stock.of("digit") == ("7_block",)
    assert stock.of("sign") == ()
    assert stock.sorts("red_block") == frozenset()
    assert stock.excesses == ()


@pytest.mark.parametrize(("sort", "limit"), [("letter", 26), ("digit", 10)])
def test_the_limits_are_sharp(sort: str, limit: int) -> None:
    symbol = "E" if sort == "letter" else "3"
    for count, beyond in ((limit, False), (limit + 1, True)):
        cubes = tuple(SemanticCube(name=f"block_{n}", label=symbol) for n in range(count))
        stock = take_stock(task("many", cubes, On(a=("block_0",), b=("block_1",))), {})
        assert [excess.what for excess in stock.excesses] == ([sort] if beyond else [])


# Requirement extraction.


def test_requirements_are_extracted_from_the_goal() -> None:
    cubes = (*letters("CAT"), tasks.cube("red"))
    word = Spells(blocks=("C_block", "A_block", "T_block"), word="CAT")
    line = Row(blocks=("C_block", "A_block"), axis="x", order=Order(by="label"))
    lifted = On(a=("red_block",), b=("T_block",))
    seen = Facing(block="T_block", label="T", toward="up")
    subject = task("all", cubes, g.All(goals=(word, line, lifted, seen)))
    needs = requirements(subject, take_stock(subject, {}))
    assert [type(need) for need in needs] == [Room, Symbols, Room, Ordering, Reach, Grip, Sight]
    room, symbols, across, ordering, _, grip, sight = needs
    assert isinstance(room, Room) and room.axis == "y" and room.extent_m == pytest.approx(0.12)
    assert isinstance(symbols, Symbols) and symbols.text == "CAT"
    assert isinstance(across, Room) and across.room_m == pytest.approx(0.30)
    assert isinstance(ordering, Ordering) and ordering.wants == "letter"
    assert isinstance(grip, Grip) and grip.block == "red_block"
    assert isinstance(sight, Sight) and sight.covered == {"T_block": "red_block"}


def test_what_is_only_one_of_two_ways_is_not_required() -> None:
    either = g.Any(goals=(Spells(blocks=("A_block", "B_block"), word="AB"), On(a=("A_block",), b=("B_block",))))
    subject = task("either", letters("AB"), either)
    assert requirements(subject, take_stock(subject, {})) == ()


# The check.

BIG_RED, BLUE = tasks.cube("red", size=0.1), tasks.cube("blue")
COVERED = g.All(goals=(On(a=("A_block",), b=("B_block",)), Facing(block="B_block", label="B", toward="up")))


@pytest.mark.parametrize(
    ("subject", "code"),
    [
        (row("ABCDEFGHIJKLM"), "does-not-fit"),
        (row("ABC", order=Order(by="number")), "order-misfit"),
        (task("word", letters("CAB"), Spells(blocks=("C_block", "A_block", "B_block"), word="CAT")), "missing-symbol"),
        (
            task("long", letters("LAM"), Spells(blocks=("L_block", "A_block", "M_block"), word="LLAMA")),
            "missing-symbol",
        ),
        (task("covered", letters("AB"), COVERED), "covered-face"),
        (task("wide", (BIG_RED, BLUE), On(a=("red_block",), b=("blue_block",))), "too-wide"),
    ],
)
def test_what_cannot_be_is_found_in_a_task_written_by_hand(subject: TaskSchema, code: str) -> None:
    with pytest.raises(Repairable) as refusal:
        examine(subject)
    assert [diagnostic.code for diagnostic in refusal.value.diagnostics] == [code]
    outcome = compile_schema(subject)
    assert outcome.status == "refused"
    assert code in [diagnostic.code for diagnostic in outcome.diagnostics]


@pytest.mark.parametrize(
    "subject",
    [
        row("ABCDEFGHIJKL"),
        row("CAB", order=Order(by="label")),
        task("word", letters("CATS"), Spells(blocks=("C_block", "A_block", "T_block", "S_block"), word="CAT")),
        task("wide", (BIG_RED, BLUE), On(a=("blue_block",), b=("red_block",))),
        task("widest", (tasks.cube("red", size=0.08), BLUE), On(a=("red_block",), b=("blue_block",))),
        task("tower", (BIG_RED, BLUE), Stack(blocks=("red_block", "blue_block"))),
    ],
)
def test_what_can_just_be_is_left_alone(subject: TaskSchema) -> None:
    found = examine(subject)
    assert found.task is subject
    assert found.made == ()


# Repairs that change nothing asked for are made, and noted.


def test_digits_in_alphabetical_order_are_in_numerical_order() -> None:
    found = examine(row("312", order=Order(by="label", first="left")))
    assert isinstance(found.task.goal, Row)
    assert found.task.goal.order == Order(by="number", first="left")
    assert [repair.kind for repair in found.made] == [REORDER]
    assert found.task.assumptions == ("digits have no alphabet: the order is numerical",)


def test_open_symbols_beyond_the_alphabet_become_digits_and_the_wall_stays() -> None:
    schema = read("Build a 6x5 wall of symbol blocks")
    assert len(take_stock(schema, {}).of("letter")) == 26
    assert len(take_stock(schema, {}).of("digit")) == 4
    (wall,) = atoms(schema.goal)
    assert (wall.kind, len(wall.blocks)) == ("grid", 30)  # type: ignore[union-attr]
    assert "there are 26 letter cubes at most: the further symbols are 1 2 3 4" in schema.assumptions


def test_nothing_is_asked_of_faces_that_are_covered() -> None:
    schema = read("Put A on B so that both letters face up")
    assert [(atom.kind, getattr(atom, "block", None)) for atom in atoms(schema.goal)] == [
        ("on", None),
        ("facing", "A_block"),
    ]
    assert "nothing is asked of a face that another block lies on" in schema.assumptions


ADAPTED = {
    "Line up the number blocks 3, 1 and 2 in alphabetical order": REORDER,
    "Build a 6x5 wall of symbol blocks": REDUCE,
    "Stack the letters A, B and C in that order so that every letter faces up": SPATIAL,
}


@pytest.mark.parametrize("text", ADAPTED)
def test_a_task_that_was_adapted_says_so_and_is_admitted(text: str) -> None:
    outcome = compile_instruction(text)
    assert outcome.status == "admitted"
    notes = [diagnostic for diagnostic in outcome.diagnostics if diagnostic.code == "adapted"]
    assert [(note.severity, note.facts["repair"]) for note in notes] == [("note", ADAPTED[text])]
    assert notes[0].message in outcome.assumptions


# Repairs that would change what was asked for are only suggested, in words that were tried.


SUGGESTED = {
    "Arrange 27 letter blocks in alphabetical order": REDUCE,
    "Put 12 digit blocks on the blue patch": REDUCE,
    "Build a 3x4 grid of digit blocks": REDUCE,
    "Line up the letters C, A and B in numerical order": REORDER,
    "Line up the red, blue and green blocks in alphabetical order": REORDER,
    "Line up A, B and C in alphabetical order with B on the left": REORDER,
    "Arrange three red blocks in alphabetical order": SPATIAL,
    "Spell the word CAT with the letters C, A and B": SPATIAL,
    "Put the block A on the block B, and the letter of the block B faces up": SPATIAL,
}


@pytest.mark.parametrize("text", SUGGESTED)
def test_a_refusal_suggests_a_task_that_is_admitted(text: str) -> None:
    diagnostic = refused(text)
    assert diagnostic.facts["repair"] == SUGGESTED[text]
    said = re.search(r'or say "(.*)"$', diagnostic.hint or "")
    assert said is not None
    assert said[1] == diagnostic.facts["instruction"]
    assert diagnostic.span is not None
    assert compile_instruction(said[1]).status == "admitted"


def test_reduced_labels_keep_the_shape() -> None:
    schema = read(refused("Build a 3x4 grid of digit blocks").facts["instruction"])
    (grid,) = atoms(schema.goal)
    assert (grid.rows, grid.columns, len(grid.blocks)) == (3, 4, 12)  # type: ignore[union-attr]
    assert len(take_stock(schema, {}).of("digit")) == 10


def test_a_switched_order_keeps_the_line() -> None:
    schema = read(refused("Line up the red, blue and green blocks in alphabetical order").facts["instruction"])
    (line,) = atoms(schema.goal)
    assert isinstance(line, Row)
    assert (line.axis, line.order.by, line.order.first) == ("y", "rainbow", "left")


def test_of_two_orders_the_first_is_kept() -> None:
    schema = read(refused("Line up A, B and C in alphabetical order with B on the left").facts["instruction"])
    (line,) = atoms(schema.goal)
    assert isinstance(line, Row)
    assert line.order.by == "label"


def test_places_stay_where_symbols_are_given_up() -> None:
    schema = read(refused("Spell the word CAT with the letters C, A and B").facts["instruction"])
    (line,) = atoms(schema.goal)
    assert isinstance(line, Row)
    assert set(line.blocks) == {"C_block", "A_block", "B_block"}
    assert line.order.by == "any"
