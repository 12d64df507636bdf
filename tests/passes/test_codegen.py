"""Lowered code: what it says is what the schema means, and it looks as a person would have written it."""

from __future__ import annotations

import ast
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from random import Random

import pytest

from rpg.blocks.evaluate import evaluate, settled
from rpg.blocks.initial import sample_start
from rpg.blocks.near_miss import near_misses
from rpg.blocks.state import World
from rpg.blocks.symmetry import interchangeable, namings, rename_state
from rpg.blocks.waypoints import looks_back
from rpg.ir.order import Order
from rpg.ir.relations import Facing
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Row, Stack
from rpg.passes.codegen import class_name, lower, lower_goal, read_goal
from rpg.passes.codegen.layout import quoted
from rpg.passes.codegen.naming import boolean_name
from rpg.passes.repair.placing import state_of
from rpg.passes.validate.load import load
from tests.passes import tasks
from tests.passes.tasks import program

ODD_TEXTS = (
    "He said \"put it there\" and 'left'",
    'three """ quotes and a \\ backslash\\',
    "a line\nand another\r\n\tand a tab",
    "direction \u202e marks and a \u200b gap",
    "Würfel auf 方块 stapeln 🧱",
    "long " * 400,
    "w" * 5000,
    "\x00\x07 control",
    "{braces} %s and 'single' \"double\"",
)


@pytest.mark.parametrize("schema", [t for t in tasks.ALL if t is not tasks.STAGES], ids=lambda schema: schema.name)
def test_code_judges_states_as_the_schema_does(schema: TaskSchema) -> None:
    subject = program(schema)
    judge = load(subject.code, subject.goal_code)[0]()
    world = World(subject.task.assets)
    goal, rng = subject.task.goal, Random(3)
    renamings = namings(interchangeable(goal, world))
    start = sample_start(subject.task.init, world, 0)
    at_goal = replace(state_of(subject.path[-1], world), start=start)
    bank = [at_goal, *(sample_start(subject.task.init, world, seed) for seed in range(1, 6))]
    bank += [miss.state for miss in near_misses(goal, at_goal, rng)]
    for state in bank:
        seen = replace(state, start=start)
        expected = any(evaluate(goal, rename_state(seen, naming)) for naming in renamings) and settled(seen)
        assert bool(judge.judge_states([seen], start)[-1].success) == bool(expected)


@pytest.mark.parametrize("schema", tasks.ALL, ids=lambda schema: schema.name)
def test_goal_code_reads_back_as_its_scenes(schema: TaskSchema) -> None:
    subject = program(schema)
    assert read_goal(subject.goal_code) == subject.path
    assert len(subject.path) == (1 if not looks_back(schema.goal) else len(subject.path))
    assert lower_goal(subject.task, read_goal(subject.goal_code) or ()) == subject.goal_code


@pytest.mark.parametrize(
    "text", ["", "class", "x = 1", "class A:\n    def _on_reset(self):\n        self.place(open('x'))", "class A: pass"]
)
def test_goal_code_of_another_kind_is_not_read(text: str) -> None:
    assert read_goal(text) is None


def test_the_code_is_what_a_formatter_and_a_linter_would_leave_alone(tmp_path: Path) -> None:
    for schema in tasks.ALL:
        subject = program(schema)
        (tmp_path / f"{schema.name.replace('-', '_')}.py").write_text(subject.code)
        (tmp_path / f"{schema.name.replace('-', '_')}_goal.py").write_text(subject.goal_code)
    ruff = [sys.executable, "-m", "ruff"]
    rules = ["--isolated", "--line-length", "100", "--select", "E,F,W,I,UP,B,SIM,C4,N,D300,D209"]
    checked = subprocess.run([*ruff, "check", *rules, str(tmp_path)], capture_output=True, text=True, check=False)
    assert checked.returncode == 0, checked.stdout
    style = ["--isolated", "--line-length", "100", "--diff"]
    formatted = subprocess.run([*ruff, "format", *style, str(tmp_path)], capture_output=True, text=True, check=False)
    assert formatted.returncode == 0, formatted.stdout


@pytest.mark.parametrize("text", ODD_TEXTS)
def test_any_instruction_survives_as_it_is(text: str) -> None:
    subject = program(tasks.RED_ON_YELLOW.model_copy(update={"instruction": text}))
    assert load(subject.code, subject.goal_code)[0].instruction == text
    assert max(map(len, subject.code.splitlines())) <= 100
    assert all(char.isprintable() or char == "\n" for char in subject.code)


@pytest.mark.parametrize("text", ODD_TEXTS)
def test_quoted_text_evaluates_to_itself(text: str) -> None:
    assert ast.literal_eval(quoted(text)) == text


@pytest.mark.parametrize("schema", tasks.ALL, ids=lambda schema: schema.name)
def test_conditions_are_named_once_and_end_in_the_success_check(schema: TaskSchema) -> None:
    tree = ast.parse(program(schema).code)
    success = next(n for n in ast.walk(tree) if isinstance(n, ast.FunctionDef) and n.name == "_success")
    assigned = [node.targets[0].id for node in success.body if isinstance(node, ast.Assign)]  # type: ignore[attr-defined]
    assert assigned[-2:] == ["at_rest", "_success_check"]
    assert len(set(assigned)) == len(assigned)
    assert ast.unparse(success.body[-1]) == "return _success_check"
    used = {node.id for node in ast.walk(success) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)}
    assert set(assigned) <= used


def test_names_say_what_is_asked() -> None:
    assert boolean_name(tasks.RED_ON_YELLOW.goal) == "red_on_yellow"
    assert boolean_name(tasks.WORD.goal) == "noon_spelled"
    assert boolean_name(tasks.PATCH.goal) == "exactly_two_on_blue_patch"
    assert boolean_name(tasks.TOWER.goal) == "blocks_stacked_in_order"
    alike = Stack(blocks=("red_block_1", "red_block_2"))
    assert boolean_name(alike) == "two_red_blocks_stacked"
    assert boolean_name(Stack(blocks=("A_block", "B_block"))) == "a_and_b_stacked"
    assert boolean_name(Stack(blocks=("A_block", "B_block"), patch="blue_patch")) == "a_and_b_stacked_on_blue_patch"
    numbers = Row(blocks=("1_block", "2_block"), order=Order(by="number"))
    assert boolean_name(numbers) == "one_and_two_in_row_numerically"
    assert boolean_name(Facing(block="A_block", label="A", turn=180.0)) == "a_upside_down"
    assert boolean_name(Facing(block="A_block", label="A", toward="left")) == "a_facing_left"
    assert [boolean_name(part) for part in tasks.MIXED.goal.goals] == [  # type: ignore[union-attr]
        "red_on_green_or_red_on_blue",
        "not_yellow_in_left_half",
        "red_and_green_left_of_yellow",
        "red_clear",
    ]


@pytest.mark.parametrize(
    ("name", "expected"), [("red-on-blue", "RedOnBlue"), ("3x3-grid", "Task3x3Grid"), ("a", "A"), ("none", "TaskNone")]
)
def test_class_names(name: str, expected: str) -> None:
    assert class_name(name) == expected


def test_lowering_does_not_depend_on_the_process() -> None:
    script = (
        "from tests.passes import tasks\nfrom rpg.core.digest import digest_of\n"
        "made = [tasks.program(s) for s in tasks.ALL]\n"
        "print(digest_of([[p.code, p.goal_code] for p in made]))"
    )
    root = Path(__file__).parents[2]
    seen = set()
    for seed in ("0", "1", "4242"):
        environment = {"PYTHONHASHSEED": seed, "PYTHONPATH": str(root), "MUJOCO_GL": "disable"}
        done = subprocess.run(
            [sys.executable, "-c", script], env=environment, capture_output=True, text=True, check=True
        )
        seen.add(done.stdout)
    assert len(seen) == 1


def test_equal_schemas_give_equal_bytes() -> None:
    for schema in tasks.ALL:
        again = TaskSchema.model_validate_json(schema.model_dump_json())
        assert lower(again) == lower(schema)
