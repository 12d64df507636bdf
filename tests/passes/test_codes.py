"""The rarer findings of the gates, each brought about; no finding is there that nothing brings about."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest

import rpg.passes.validate.runner as runner
from rpg.core.codes import ROOMS
from rpg.core.sandbox import Layers
from rpg.ir.artifact import failure_class
from rpg.ir.goal import All
from rpg.ir.relations import Above
from rpg.passes.codegen import lower
from rpg.passes.validate.bench import Bench
from rpg.passes.validate.gates.constraint import ConstraintGate, Edge
from rpg.passes.validate.gates.smoke import SmokeGate
from rpg.pipeline import repair_program
from tests.passes import tasks
from tests.passes.tasks import placed, program
from tests.passes.test_gates import caught, edited, run
from tests.passes.test_repair import FAST as OPTIONS

SCATTER = 'self.scatter("red_block", "yellow_block")'


def test_code_too_long() -> None:
    subject = program(tasks.RED_ON_YELLOW)
    caught(subject.model_copy(update={"code": subject.code + "# long\n" * 40_000}), "text", "code-too-long")


def test_code_load() -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), "    def _init", '    word: int("a") = 1\n\n    def _init')
    assert "ValueError" in caught(subject, "compile", "code-load").failures[0].facts["traceback"]


def test_code_crashes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(SmokeGate, "check", lambda *_: os.abort())
    subject = edited(program(tasks.RED_ON_YELLOW), "red_on_yellow", "as_asked")
    report = caught(subject, "smoke", "code-crashes")
    assert "signal" in report.failures[0].message or "status" in report.failures[0].message


def test_code_not_confined(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("rpg.core.isolate.confine", lambda *_: Layers(rlimits=True))
    subject = edited(program(tasks.RED_ON_YELLOW), "red_on_yellow", "as_asked")
    report = caught(subject, "compile", "code-not-confined")
    assert report.failures[0].hint


@pytest.mark.parametrize("place", ['float("nan")', 'float("inf")'])
def test_physics_diverges(place: str) -> None:
    calls = f'self.place("red_block", (0.5, {place}, 0.97))\n        self.place("yellow_block", (0.6, 0.1, 0.97))'
    reports = run(edited(program(tasks.RED_ON_YELLOW), SCATTER, calls))
    assert reports[-1].name == "smoke" and not reports[-1].passed
    assert [d.code for d in reports[-1].failures] == ["physics-diverges"]


def test_unsupported_block() -> None:
    edges = [Edge("red_block", "sky", True, (0, 3)), Edge("sky", "cloud", True, None)]
    found = ConstraintGate()._judge(edges, Bench(program(tasks.RED_ON_YELLOW)).world)
    assert [(d.code, d.facts["block"], d.span) for d in found] == [("unsupported-block", "red_block", (0, 3))]


def test_goal_moves() -> None:
    subject = placed(program(tasks.RED_ON_YELLOW), red_block=(0.55, 0.0, 400.0))
    codes = {d.code for d in run(subject)[-1].failures}
    assert codes == {"goal-topples", "goal-moves", "goal-not-met"}


def test_goal_drifts() -> None:
    subject = program(tasks.ROW)
    red, green, blue = (p.position for p in subject.path[-1])
    close = placed(subject, red_block=(green[0], green[1] + 0.022, red[2]), blue_block=(green[0], -0.2, blue[2]))
    assert "goal-drifts" in {d.code for d in run(close)[-1].failures}


def test_goal_not_kept() -> None:
    counting = (
        "    ticks = 0\n\n    def _on_step(self) -> None:\n        self.ticks = self.ticks + 1\n\n    def _success"
    )
    subject = edited(program(tasks.RED_ON_YELLOW), "    def _success", counting)
    late = "red_on_yellow & at_rest & self.count([at_rest for _ in range(self.ticks)], at_most=60)"
    subject = edited(subject, "red_on_yellow & at_rest", late)
    report = caught(subject, "goal-state", "goal-not-kept")
    assert "after 11 control steps" in report.failures[0].message


def test_task_crashes() -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), "return _success_check", "return _success_check + 1")
    report = caught(subject, "smoke", "task-crashes")
    assert report.failures[0].facts["line"] == subject.code.splitlines().index("        return _success_check + 1") + 1


def test_reset_lost() -> None:
    calls = 'self.place("red_block", (0.5, 0.0, 0.97))\n        self.place("yellow_block", (0.6, 0.1, 0.97))'
    subject = edited(program(tasks.RED_ON_YELLOW), SCATTER, calls)
    lost = subject.model_copy(
        update={"code": subject.code + "\n    def _fail(self) -> Verdict:\n        return True\n"}
    )
    caught(lost, "unsolved", "reset-lost")


def test_reset_moves() -> None:
    calls = 'self.place("red_block", (0.5, 0.0, 1.1))\n        self.place("yellow_block", (0.6, 0.1, 0.97))'
    report = caught(edited(program(tasks.RED_ON_YELLOW), SCATTER, calls), "unsolved", "reset-moves")
    assert report.figures["speed_mm_s"] > 100
    assert failure_class(report.failures[0]) == "instability"


def test_repair_refused() -> None:
    circle = All(goals=(Above(a=("red_block",), b=("yellow_block",)), Above(a=("yellow_block",), b=("red_block",))))
    sound = program(tasks.RED_ON_YELLOW)
    task = sound.task.model_copy(update={"goal": circle})
    outcome = repair_program(sound.model_copy(update={"task": task, "code": lower(task)}), options=OPTIONS)
    assert outcome.status == "refused"
    assert outcome.schema is not None and outcome.schema.goal == circle
    refused = [d for d in outcome.diagnostics if d.code == "repair-refused"]
    assert refused and "drop 1 of the conditions" in refused[0].message


def test_a_nursery_that_has_ended_is_replaced() -> None:
    os.close(runner._nursery(os.getpid())._requests)
    assert run(program(tasks.RED_ON_YELLOW))[-1].passed


def test_every_code_of_this_room_is_brought_about_by_a_test() -> None:
    tests = "".join(path.read_text() for path in Path(__file__).parent.glob("test_*.py"))
    missing = [code.id for code in ROOMS["validate"] if f'"{code.id}"' not in tests]
    assert missing == []


def test_every_code_of_this_room_is_reported_somewhere() -> None:
    package = Path(runner.__file__).parents[1]
    sources = "".join(path.read_text() for room in ("validate", "repair") for path in (package / room).rglob("*.py"))
    reported = set(re.findall(r'"([a-z]+(?:-[a-z]+)*)"', sources))
    assert {code.id for code in ROOMS["validate"]} <= reported
