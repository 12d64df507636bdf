"""Where code tells the goal of its schema, gates judge that goal; they say the same as where they run the code."""

from __future__ import annotations

import pytest

from rpg.ir.artifact import GateReport, Program
from rpg.ir.schema import TaskSchema
from rpg.passes.validate import Measures
from rpg.passes.validate.bench import Bench
from rpg.passes.validate.gates import GATES
from tests.passes import tasks
from tests.passes.tasks import measured, program

FAST = Measures(resets=3)


def reports(subject: Program, trusted: bool) -> tuple[Bench, list[GateReport]]:
    """The gates in this process, but for the last one, which needs another."""
    bench = Bench(subject, FAST, trusted=trusted)
    return bench, [gate.check(subject, bench) for gate in GATES[:-1]]


@pytest.mark.parametrize("schema", tasks.ALL, ids=lambda schema: schema.name)
def test_gates_say_the_same_of_the_goal_and_of_the_code(schema: TaskSchema) -> None:
    subject = program(schema)
    (trusted, told), (_, run) = reports(subject, True), reports(subject, False)
    assert [measured(report) for report in told] == [measured(report) for report in run]
    assert (trusted.judge is None) == (schema is tasks.STAGES)


def test_code_that_tells_another_goal_is_run() -> None:
    subject = program(tasks.RED_ON_YELLOW)
    other = subject.code.replace('self.on("red_block", "yellow_block")', 'self.on("yellow_block", "red_block")')
    bench = Bench(subject.model_copy(update={"code": other}), FAST, trusted=True)
    assert bench.task and bench.judge is None


def test_code_that_does_not_wait_for_rest_is_run() -> None:
    subject = program(tasks.RED_ON_YELLOW)
    other = subject.code.replace("red_on_yellow & at_rest", "red_on_yellow")
    bench = Bench(subject.model_copy(update={"code": other}), FAST, trusted=True)
    assert bench.task and bench.judge is None
