"""The whole way from a schema to an admitted program, and back from its files."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from rpg.core.diagnostics import Diagnostic, UsageError
from rpg.core.passes import Context, Manager, Report
from rpg.ir.goal import All, Sequence, Stage
from rpg.ir.relations import LeftOf, On, OnTable, RightOf
from rpg.ir.schema import InitialState, TaskSchema
from rpg.passes.validate import Measures
from rpg.pipeline import CompileOptions, compile_instruction, compile_schema, is_lowered, load_program, validate_program
from tests.passes import tasks

FAST = CompileOptions(measures=Measures(resets=2, other_goals=1))

SCRIPT = """
from rpg.core.digest import digest_of
from rpg.pipeline import compile_schema
from tests.passes import tasks
for schema in (tasks.STAGES, tasks.PATCH, tasks.ALIKE):
    made = compile_schema(schema)
    assert made.status == "admitted", made.log
    print(digest_of([made.schema.model_dump(mode="json"), made.program.code, made.program.goal_code, made.log]))
"""


def test_processes_agree_on_every_byte(tmp_path: Path) -> None:
    root = Path(__file__).parents[2]
    seen = set()
    for seed, folder in (("0", root), ("7", tmp_path)):
        environment = {"PYTHONHASHSEED": seed, "PYTHONPATH": str(root), "MUJOCO_GL": "disable"}
        command = [sys.executable, "-c", SCRIPT]
        done = subprocess.run(command, env=environment, cwd=folder, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        seen.add(done.stdout)
    assert len(seen) == 1


def test_an_outcome_says_everything() -> None:
    heard: list[str] = []
    outcome = compile_schema(
        tasks.RED_ON_YELLOW, CompileOptions(listen=lambda stage, text: heard.append(f"{stage} {text}"))
    )
    assert outcome.status == "admitted"
    assert outcome.mutation_score == 1.0
    assert "red block" in outcome.goal_text
    assert outcome.log.endswith("\nadmitted\n")
    assert [gate.name for gate in outcome.gates if not gate.passed] == []
    assert heard[:3] == ["feasibility start", "arrange start", "codegen start"]
    assert outcome.attempts == () and outcome.pictures == {}


def test_goals_that_contradict_each_other_are_refused() -> None:
    goal = All(
        goals=(
            LeftOf(a=("red_block",), b=("yellow_block",), span=(0, 5)),
            RightOf(a=("red_block",), b=("yellow_block",), span=(6, 9)),
        )
    )
    outcome = compile_schema(tasks.RED_ON_YELLOW.model_copy(update={"goal": goal}), FAST)
    assert outcome.status == "refused"
    assert outcome.program is None
    assert {d.severity for d in outcome.diagnostics} == {"error"}
    spans = {outcome.diagnostics[0].span, *(label.span for label in outcome.diagnostics[0].labels)}
    assert spans >= {(0, 5), (6, 9)}


STARTS = (
    InitialState(arranged=(On(a=("red_block",), b=("yellow_block",)),)),
    InitialState(
        arranged=(On(a=("red_block",), b=("yellow_block",)), On(a=("yellow_block",), b=("red_block",))),
    ),
)


@pytest.mark.parametrize("init", STARTS)
def test_starts_that_cannot_be_are_refused(init: InitialState) -> None:
    outcome = compile_schema(tasks.RED_ON_YELLOW.model_copy(update={"init": init}), FAST)
    assert outcome.status == "refused"
    assert [d.severity for d in outcome.diagnostics] == ["error"]
    assert outcome.attempts == ()


def test_a_stage_that_is_met_from_the_start_is_refused() -> None:
    stages = (Stage(goal=OnTable(a=("yellow_block",))), Stage(goal=On(a=("red_block",), b=("yellow_block",))))
    outcome = compile_schema(tasks.RED_ON_YELLOW.model_copy(update={"goal": Sequence(stages=stages)}), FAST)
    assert outcome.status == "refused"
    assert [d.code for d in outcome.diagnostics] == ["start-solves-goal"]


class _Reader:
    """A front end that knows one sentence."""

    def read(
        self, text: str, *, name: str | None, seed: int, author: str | None
    ) -> tuple[TaskSchema | None, tuple[Diagnostic, ...]]:
        if text != tasks.RED_ON_YELLOW.instruction:
            return None, (Diagnostic(code="unknown-word", message="what?"),)
        extra = {"name": name or "named-by-itself", "seed": seed, "author": author}
        return tasks.RED_ON_YELLOW.model_copy(update=extra), ()


def test_an_instruction_goes_through_the_front_end_it_is_given() -> None:
    options = CompileOptions(name="given", seed=4, author="ada", front_end=_Reader(), measures=FAST.measures)
    made = compile_instruction(tasks.RED_ON_YELLOW.instruction, options)
    assert made.status == "admitted" and made.schema is not None
    assert (made.schema.name, made.schema.seed, made.schema.author) == ("given", 4, "ada")
    refused = compile_instruction("something else", options)
    assert (refused.status, [d.code for d in refused.diagnostics]) == ("refused", ["unknown-word"])


def test_files_on_disk_make_the_same_program(tmp_path: Path) -> None:
    made = compile_schema(tasks.STAGES, FAST).program
    assert made is not None
    (tmp_path / "code.py").write_text(made.code)
    (tmp_path / "goal_state_code.py").write_text(made.goal_code)
    again = load_program(tmp_path, made.task)
    assert again == made
    assert is_lowered(again)
    assert validate_program(again, FAST.measures) == compile_schema(tasks.STAGES, FAST).gates


def test_changed_files_are_not_taken_for_our_own(tmp_path: Path) -> None:
    made = compile_schema(tasks.RED_ON_YELLOW, FAST).program
    assert made is not None
    for old, new in (("BlockTask):", "BlockTask): "), ("at_rest\n", "at_rest  # \n")):
        assert not is_lowered(made.model_copy(update={"code": made.code.replace(old, new)}))
    assert not is_lowered(made.model_copy(update={"goal_code": made.goal_code + "\n"}))
    assert not is_lowered(made.model_copy(update={"path": ()}))
    other = made.task.model_copy(update={"goal": On(a=("yellow_block",), b=("red_block",))})
    assert not is_lowered(made.model_copy(update={"task": other}))


def test_a_directory_without_a_task_is_a_usage_error(tmp_path: Path) -> None:
    with pytest.raises(UsageError):
        load_program(tmp_path, tasks.RED_ON_YELLOW)


class _Add:
    def __init__(self, name: str, amount: int | None) -> None:
        self.name, self.amount = name, amount

    def run(self, item: int, context: Context) -> tuple[int | None, Report]:
        return (None if self.amount is None else item + self.amount), Report(found=self.amount)


def test_the_manager_runs_passes_in_order_and_stops_where_one_yields_nothing() -> None:
    checked: list[tuple[str, int]] = []
    manager = Manager((_Add("one", 1), _Add("two", 2)), lambda name, item: checked.append((name, item)))
    run = manager.run(0)
    assert run.item == 3
    assert checked == [("one", 1), ("two", 3)]
    assert [record.name for record in run.records] == ["one", "two"]
    stopped = Manager((_Add("one", 1), _Add("none", None), _Add("never", 1))).run(0)
    assert stopped.item is None
    assert [record.name for record in stopped.records] == ["one", "none"]
