"""Each agent mends a real failure of its class; none of them weakens what was asked."""

from __future__ import annotations

import math
from random import Random

import pytest

from rpg.core.diagnostics import Diagnostic
from rpg.ir.artifact import GateReport, Program
from rpg.ir.assets import GoalPatch
from rpg.ir.goal import All, Goal
from rpg.ir.order import Order
from rpg.ir.relations import Above, LeftOf, On, OnPatch
from rpg.ir.schema import InitialState, Start
from rpg.ir.structures import Stack
from rpg.passes.codegen import lower, lower_goal, read_goal
from rpg.passes.repair import Tools, repair
from rpg.passes.repair.guard import dropped
from rpg.passes.validate import Measures
from rpg.pipeline import CompileOptions, Outcome, goal_path, repair_program
from tests.passes import tasks
from tests.passes.tasks import placed, program, task
from tests.passes.test_gates import edited

FAST = CompileOptions(measures=Measures(resets=2, other_goals=1))


def mended(subject: Program, agent: str, asked: Goal | None = None) -> Outcome:
    """The outcome of a repair that this agent has to have brought about, the goal unchanged."""
    outcome = repair_program(subject, asked, FAST)
    assert outcome.status == "admitted", outcome.log
    assert outcome.program is not None
    kept = [attempt for attempt in outcome.attempts if attempt.kept]
    assert [attempt.agent for attempt in kept] == [agent], outcome.attempts
    assert not dropped(asked or subject.task.goal, outcome.program.task)
    assert any(d.code == "repaired" and agent in d.message for d in outcome.diagnostics)
    return outcome


SYNTAX = (
    ("def _success(self) -> Verdict:", "def _success(self) -> Verdict"),
    ('self.on("red_block", "yellow_block")', 'self.on("red_block", "yellow_block"'),
    ('self.on("red_block", "yellow_block")', 'self.on("red_block", "yellow_block)'),
    ("return _success_check", "return _success_check)"),
    ("class RedOnYellow(BlockTask):", "class RedOnYellow(BlockTask):\n  def broken("),
)


@pytest.mark.parametrize(("old", "new"), SYNTAX)
def test_syntax(old: str, new: str) -> None:
    outcome = mended(edited(program(tasks.RED_ON_YELLOW), old, new), "SyntaxFixAgent")
    assert outcome.program is not None
    assert outcome.program.code == lower(tasks.RED_ON_YELLOW)


def test_syntax_patches_keep_what_was_written_by_hand() -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), "red_on_yellow", "as_i_call_it")
    subject = edited(subject, "def _success(self) -> Verdict:", "def _success(self) -> Verdict")
    outcome = mended(subject, "SyntaxFixAgent")
    assert outcome.program is not None
    assert "as_i_call_it = self.on(" in outcome.program.code


API = (
    ("self.on(", "self.onn("),
    ("self.scatter(", "self.scater("),
    ("_on_reset", "_on_rest"),
    ('color="red"', 'colour="red"'),
    ("import BlockTask, ColoredCube, Verdict", "import BlockTask, Verdict"),
    ("from rpg.env import BlockTask, ColoredCube, Verdict\n", ""),
    ("from rpg.env import", "from rpg.envs import"),
    ("from rpg.env", "import os\nfrom rpg.env"),
    ('"yellow_block")\n        at', '"yellow_block", strict=True)\n        at'),
    ('self.on("red_block", "yellow_block")', 'self.on("red_block")'),
    ("_success(self)", "_sucess(self)"),
)


@pytest.mark.parametrize(("old", "new"), API)
def test_api_usage(old: str, new: str) -> None:
    outcome = mended(edited(program(tasks.RED_ON_YELLOW), old, new), "APIUsageFixAgent")
    assert outcome.program is not None
    assert outcome.program.code == lower(tasks.RED_ON_YELLOW)


def test_near_match_names_keep_what_was_written_by_hand() -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), "red_on_yellow", "as_i_call_it")
    outcome = mended(edited(subject, "self.on(", "self.onn("), "APIUsageFixAgent")
    assert outcome.program is not None
    assert "as_i_call_it = self.on(" in outcome.program.code


def test_runtime_errors() -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), 'self.on("red_block"', 'self.on("rod_block"')
    outcome = mended(subject, "RuntimeFixAgent")
    assert outcome.attempts[0].strategy == "lower _success again"


def test_a_vacuous_success_check() -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), "return _success_check", "return True")
    assert mended(subject, "SuccessCheckFixAgent").attempts[0].strategy == "write the success check anew"


def test_a_success_check_in_the_wrong_order() -> None:
    order = 'ranks=("{}_block", "green_block", "{}_block")'
    subject = edited(program(tasks.TOWER), order.format("red", "blue"), order.format("blue", "red"))
    mended(subject, "SuccessCheckFixAgent")


def test_a_goal_state_in_the_wrong_order() -> None:
    subject = program(tasks.TOWER)
    red, green, blue = (p.position for p in subject.path[-1])
    outcome = mended(placed(subject, red_block=blue, green_block=green, blue_block=red), "SuccessCheckFixAgent")
    assert outcome.attempts[0].strategy.startswith("arrange another goal state")


def test_a_cube_on_its_edge() -> None:
    schema = task("edge", (tasks.cube("red"), tasks.cube("yellow")), LeftOf(a=("red_block",), b=("yellow_block",)))
    subject = program(schema)
    red = subject.path[-1][0]
    roll = (math.cos(math.pi / 8), 0.0, math.sin(math.pi / 8), 0.0)
    tipped = red.model_copy(update={"position": (*red.position[:2], 0.95 + 0.02 * math.sqrt(2)), "orientation": roll})
    path = ((tipped, *subject.path[-1][1:]),)
    subject = subject.model_copy(update={"path": path, "goal_code": lower_goal(schema, path)})
    outcome = mended(subject, "StructureStabilityFixAgent")
    assert outcome.attempts[0].strategy == "set the blocks down flat"


def test_a_centre_past_the_edge_of_its_support() -> None:
    subject = program(tasks.RED_ON_YELLOW)
    red, yellow = subject.path[-1]
    over = placed(subject, red_block=(red.position[0], yellow.position[1] + 0.021, red.position[2]))
    outcome = mended(over, "StructureStabilityFixAgent")
    assert outcome.attempts[-1].strategy == "centre each block on what is under it"
    assert outcome.program is not None
    assert outcome.program.path[-1][0].position[:2] == outcome.program.path[-1][1].position[:2]


def test_neighbours_that_push_each_other_are_moved_apart() -> None:
    subject = program(tasks.ROW)
    red, green, blue = (p.position for p in subject.path[-1])
    middle = green[1]
    tight = placed(
        subject,
        red_block=(green[0], middle + 0.032, red[2]),
        green_block=green,
        blue_block=(green[0], middle - 0.032, blue[2]),
    )
    outcome = mended(tight, "StructureStabilityFixAgent")
    assert outcome.attempts[-1].strategy.startswith("move neighbours apart")


def test_starts_that_overlap() -> None:
    init = InitialState(
        poses=(Start(block="red_block", position=(0.5, 0.0)), Start(block="yellow_block", position=(0.51, 0.0)))
    )
    subject = program(tasks.RED_ON_YELLOW.model_copy(update={"init": init}))
    outcome = mended(subject, "StructureStabilityFixAgent")
    assert outcome.schema is not None
    a, b = outcome.schema.init.poses
    assert a.position == (0.5, 0.0)
    assert math.dist(a.position, b.position) < 0.08


def test_a_goal_state_outside_of_the_workspace() -> None:
    over = placed(program(tasks.RED_ON_YELLOW), red_block=(0.72, 0.0, 1.01), yellow_block=(0.72, 0.0, 0.97))
    outcome = mended(over, "GeometricBoundsFixAgent")
    assert outcome.attempts[0].strategy == "move the arrangement into the workspace"
    assert outcome.program is not None
    assert all(abs(p.position[0] - 0.695) < 1e-6 for p in outcome.program.path[-1])


def test_a_start_outside_of_the_workspace() -> None:
    init = InitialState(poses=(Start(block="red_block", position=(0.3, 0.4), jitter=0.02),))
    outcome = mended(program(tasks.RED_ON_YELLOW.model_copy(update={"init": init})), "GeometricBoundsFixAgent")
    assert outcome.schema is not None
    assert outcome.schema.init.poses[0].position == (0.42, 0.23)


ASKED = All(goals=(On(a=("red_block",), b=("green_block",)), On(a=("green_block",), b=("blue_block",))))
THREE = (tasks.cube("red"), tasks.cube("green"), tasks.cube("blue"))


def broken_goal(goal: Goal) -> Program:
    """A program whose goal is `goal`, which nothing can satisfy; its goal state is that of what was asked."""
    sound = program(task("three", THREE, ASKED))
    wrong = sound.task.model_copy(update={"goal": goal})
    return sound.model_copy(update={"task": wrong, "code": lower(wrong)})


def test_a_support_that_was_written_the_wrong_way_round() -> None:
    wrong = All(goals=(*ASKED.goals, On(a=("blue_block",), b=("red_block",))))
    outcome = mended(broken_goal(wrong), "ConstraintFixAgent", ASKED)
    assert outcome.schema is not None
    assert not dropped(ASKED, outcome.schema)


def test_a_chain_that_was_written_the_wrong_way_round() -> None:
    order = Order(by="given", ranks=(("blue_block",), ("green_block",), ("red_block",)))
    asked = All(goals=(Stack(blocks=("red_block", "green_block", "blue_block"), order=order), ASKED.goals[0]))
    flipped = order.model_copy(update={"ranks": tuple(reversed(order.ranks))})
    wrong = All(goals=(asked.goals[0].model_copy(update={"order": flipped}), ASKED.goals[0]))
    outcome = mended(broken_goal(wrong), "ConstraintFixAgent", asked)
    assert [a.strategy for a in outcome.attempts if a.kept] == ["reverse a support chain"]


def test_a_circle_that_was_really_asked_for_is_not_broken_up() -> None:
    circle = All(goals=(*ASKED.goals, On(a=("blue_block",), b=("red_block",))))
    outcome = repair_program(broken_goal(circle), options=FAST)
    assert outcome.status == "refused"
    assert outcome.gates[-1].name == "constraint"
    assert outcome.schema is not None and outcome.schema.goal == circle


def test_a_dropped_condition_is_told_from_an_implied_one() -> None:
    above = Above(a=("red_block",), b=("blue_block",))
    both = task("three", THREE, ASKED)
    assert dropped(All(goals=(*ASKED.goals, above)), both) == []
    left = LeftOf(a=("red_block",), b=("blue_block",))
    assert dropped(All(goals=(*ASKED.goals, left)), both) == [left]
    looser = task("three", THREE, All(goals=(ASKED.goals[0], ASKED.goals[1].model_copy(update={"slack": 0.01}))))
    assert dropped(ASKED, looser) == [ASKED.goals[1]]


def test_a_patch_that_is_too_small_grows() -> None:
    small = GoalPatch(name="blue_patch", color="blue", size=(0.02, 0.02), position=(0.5, 0.0))
    schema = task(
        "small",
        (tasks.cube("red"), tasks.cube("green"), small),
        OnPatch(a=("red_block", "green_block"), patch="blue_patch"),
    )
    big = schema.model_copy(update={"assets": (*schema.assets[:2], small.model_copy(update={"size": (0.1, 0.1)}))})
    path = goal_path(big, Random(0))
    subject = Program(task=schema, path=path, code=lower(schema), goal_code=lower_goal(schema, path))
    outcome = repair_program(subject, options=FAST)
    assert outcome.status == "admitted", outcome.log
    assert outcome.schema is not None
    assert outcome.schema.patches[0].size[0] > 0.02


class _Stubborn:
    """Validation that fails always, at the same gate with the same class."""

    def __init__(self, kind: str) -> None:
        self.kind, self.calls = kind, 0

    def __call__(self, subject: Program) -> tuple[GateReport, ...]:
        self.calls += 1
        wrong = Diagnostic(code="goal-not-met", message="no", facts={"class": self.kind})
        return (GateReport.of("goal-state", [wrong]),)


@pytest.mark.parametrize("kind", ["goal", "instability", "bounds", "syntax", "api", "runtime", "constraint"])
def test_repair_is_bounded_and_never_tries_a_state_twice(kind: str) -> None:
    subject = program(tasks.RED_ON_YELLOW)
    seen: list[str] = []
    validate = _Stubborn(kind)

    def watched(candidate: Program) -> tuple[GateReport, ...]:
        seen.append(candidate.code + candidate.goal_code)
        return validate(candidate)

    tools = Tools(lower, lower_goal, read_goal, goal_path, watched)
    result = repair(subject, validate(subject), subject.task.goal, tools)
    assert len(seen) <= 3
    assert len(seen) == len(set(seen))
    assert result.program == subject
    assert all(not attempt.kept for attempt in result.attempts)
