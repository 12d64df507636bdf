"""Injected defects: each is caught by the gate meant for it, and its log says so."""

from __future__ import annotations

import math

import pytest

from rpg.core.isolate import Limits
from rpg.ir.artifact import GateReport, Program, failure_class
from rpg.ir.goal import All
from rpg.ir.relations import Above, LeftOf, On
from rpg.ir.schema import InitialState, Start
from rpg.passes.codegen import lower, lower_goal
from rpg.passes.validate import Measures, admitted, render_log, validate
from rpg.passes.validate.bench import Bench
from rpg.passes.validate.gates.determinism import DeterminismGate
from rpg.pipeline import is_lowered, validate_program
from tests.passes import tasks
from tests.passes.tasks import measured, placed, program, task

GATES = ("text", "compile", "smoke", "constraint", "goal-state", "bounds", "unsolved", "mutation", "determinism")
FAST = Measures(resets=3, other_goals=2)


def run(subject: Program) -> tuple[GateReport, ...]:
    return validate_program(subject, FAST)


def edited(subject: Program, old: str, new: str, goal: bool = False) -> Program:
    """The program with a change by hand in one of its files."""
    field = "goal_code" if goal else "code"
    text = getattr(subject, field)
    assert old in text
    return subject.model_copy(update={field: text.replace(old, new)})


def caught(subject: Program, gate: str, code: str) -> GateReport:
    """The report of the gate that must be the first to fail, with `code` among its findings and in the log."""
    reports = run(subject)
    assert not reports[-1].passed
    assert (reports[-1].name, [d.code for d in reports[-1].failures]) == (gate, [code])
    log = render_log(subject, reports)
    assert f"{gate} " in log and "FAIL" in log and code in log and log.endswith("not admitted\n")
    return reports[-1]


@pytest.mark.parametrize("schema", tasks.ALL, ids=lambda schema: schema.name)
def test_sound_tasks_pass_all_nine_gates(schema: object) -> None:
    subject = program(schema)  # type: ignore[arg-type]
    reports = run(subject)
    assert admitted(reports), render_log(subject, reports)
    assert tuple(report.name for report in reports) == GATES
    assert all(report.figures for report in reports)
    assert reports[7].figures["score"] == 1.0
    assert reports[7].figures["near_misses"] >= 5


def test_confined_code_passes_like_our_own() -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), "red_on_yellow", "as_asked")
    assert not is_lowered(subject)
    reports = run(subject)
    assert admitted(reports), render_log(subject, reports)
    mine = validate(program(tasks.RED_ON_YELLOW), trusted=True, measures=FAST)
    assert [measured(r) for r in reports] == [measured(r) for r in mine]


def test_a_cube_on_its_edge_is_unstable() -> None:
    schema = task(
        "edge", (tasks.cube("red"), tasks.cube("yellow")), LeftOf(a=("red_block",), b=("yellow_block",), span=(0, 4))
    )
    subject = program(schema)
    x, y, _ = subject.path[-1][0].position
    roll = (math.cos(math.pi / 8), 0.0, math.sin(math.pi / 8), 0.0)
    tipped = subject.path[-1][0].model_copy(
        update={"position": (x, y, 0.95 + 0.02 * math.sqrt(2)), "orientation": roll}
    )
    path = ((tipped, *subject.path[-1][1:]),)
    subject = subject.model_copy(update={"path": path, "goal_code": lower_goal(schema, path)})
    reports = run(subject)
    assert reports[-1].name == "goal-state"
    failure = reports[-1].failures[0]
    assert failure_class(failure) == "instability"
    assert failure.code in ("goal-topples", "goal-drifts")
    assert failure.facts["block"] == "red_block"
    assert failure.span == (0, 4)
    assert failure.code in render_log(subject, reports)


def test_a_centre_just_past_the_edge_of_its_support_is_unstable() -> None:
    subject = program(tasks.RED_ON_YELLOW)
    (red, yellow) = subject.path[-1]
    x, _, z = red.position
    over = placed(subject, red_block=(x, yellow.position[1] + 0.021, z))
    report = caught(over, "goal-state", "goal-topples") if len(run(over)[-1].failures) == 1 else run(over)[-1]
    assert report.name == "goal-state"
    failure = report.failures[0]
    assert failure_class(failure) == "instability"
    assert failure.facts["fall_m"] > 0.02
    assert tasks.RED_ON_YELLOW.instruction[slice(*failure.span or (0, 0))].startswith("put the red")
    assert failure.facts["subgoals_failed"] == ["the red block is on the yellow block"]


def test_blocks_inside_each_other_at_the_start_are_caught() -> None:
    init = InitialState(
        poses=(Start(block="red_block", position=(0.5, 0.0)), Start(block="yellow_block", position=(0.51, 0.0)))
    )
    subject = program(tasks.RED_ON_YELLOW.model_copy(update={"init": init}))
    report = run(subject)[-1]
    assert report.name == "unsolved"
    assert [d.code for d in report.failures] == ["reset-overlap", "reset-moves"]
    assert "blocks overlap by" in render_log(subject, run(subject))
    assert report.figures["overlap_mm"] > 20
    assert failure_class(report.failures[0]) == "instability"


def test_a_start_outside_of_the_workspace_is_caught() -> None:
    init = InitialState(poses=(Start(block="red_block", position=(0.3, 0.0)),))
    report = caught(program(tasks.RED_ON_YELLOW.model_copy(update={"init": init})), "unsolved", "reset-out-of-bounds")
    assert failure_class(report.failures[0]) == "bounds"


def test_a_start_that_is_solved_already_is_caught() -> None:
    init = InitialState(arranged=(On(a=("red_block",), b=("yellow_block",)),))
    report = caught(program(tasks.RED_ON_YELLOW.model_copy(update={"init": init})), "unsolved", "start-solves-goal")
    assert failure_class(report.failures[0]) == "goal"


def test_code_that_places_a_solved_start_is_caught() -> None:
    calls = 'self.place("red_block", (0.55, 0.0, 1.01))\n        self.place("yellow_block", (0.55, 0.0, 0.97))'
    subject = edited(program(tasks.RED_ON_YELLOW), 'self.scatter("red_block", "yellow_block")', calls)
    report = caught(subject, "unsolved", "reset-solved")
    assert report.figures["solved"] == report.figures["resets"] == 3


@pytest.mark.parametrize("claim", ["True", "Verdict(True, 1.0)", "~Verdict(False, -1.0)", "self.count([])"])
def test_a_vacuous_success_is_caught(claim: str) -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), "return _success_check", f"return {claim}")
    report = caught(subject, "unsolved", "goal-vacuous")
    assert failure_class(report.failures[0]) == "goal"


def test_a_success_that_forgets_a_condition_is_caught() -> None:
    schema = task(
        "both",
        (tasks.cube("red"), tasks.cube("yellow"), tasks.cube("blue")),
        All(
            goals=(
                On(a=("red_block",), b=("yellow_block",)),
                LeftOf(a=("blue_block",), b=("yellow_block",), span=(0, 4)),
            )
        ),
    )
    subject = edited(program(schema), "red_on_yellow & blue_left_of_yellow & at_rest", "red_on_yellow & at_rest")
    report = caught(subject, "mutation", "goal-vacuous")
    assert report.figures["score"] < 1.0
    assert report.figures["survived"]
    assert report.failures[0].span == (0, 4)


def test_a_success_that_forgets_to_wait_for_rest_is_caught() -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), "red_on_yellow & at_rest", "red_on_yellow")
    caught(subject, "mutation", "goal-vacuous")


def test_stages_that_forget_to_wait_for_rest_are_caught() -> None:
    subject = edited(program(tasks.STAGES), "& at_rest\n", "\n")
    caught(subject, "mutation", "goal-vacuous")


def test_an_over_tight_success_is_caught() -> None:
    subject = edited(
        program(tasks.RED_ON_YELLOW),
        'self.on("red_block", "yellow_block")',
        'self.on("red_block", "yellow_block", offset_edges=0.01, slack=0.0005)',
    )
    report = caught(subject, "mutation", "goal-over-tight")
    assert report.figures["rejected"] > 0


def test_a_wrong_order_of_colours_is_caught() -> None:
    order = 'ranks=("{}_block", "green_block", "{}_block")'
    wrong = edited(program(tasks.TOWER), order.format("red", "blue"), order.format("blue", "red"))
    report = caught(wrong, "goal-state", "goal-not-met")
    assert failure_class(report.failures[0]) == "goal"


def test_a_goal_state_with_the_wrong_order_is_caught() -> None:
    subject = program(tasks.TOWER)
    red, green, blue = (p.position for p in subject.path[-1])
    wrong = placed(subject, red_block=blue, green_block=green, blue_block=red)
    report = caught(wrong, "goal-state", "goal-not-met")
    assert report.failures[0].facts["subgoals_failed"]
    assert report.failures[0].facts["poses"]["red_block"][2] > 1.0


def test_a_goal_state_outside_of_the_workspace_is_caught() -> None:
    subject = program(tasks.RED_ON_YELLOW)
    over = placed(subject, red_block=(0.72, 0.0, 1.01), yellow_block=(0.72, 0.0, 0.97))
    reports = run(over)
    assert reports[-1].name == "bounds"
    assert {d.code for d in reports[-1].failures} == {"goal-out-of-bounds"}
    assert [d.facts["block"] for d in reports[-1].failures] == ["red_block", "yellow_block"]
    assert all(failure_class(d) == "bounds" and d.facts["outside_m"] == 0.02 for d in reports[-1].failures)
    assert "0.720" in render_log(over, reports)


def test_a_support_cycle_is_caught_before_any_physics_of_the_goal() -> None:
    subject = program(tasks.RED_ON_YELLOW)
    goal = All(
        goals=(
            On(a=("red_block",), b=("yellow_block",), span=(0, 6)),
            On(a=("yellow_block",), b=("red_block",), span=(7, 10)),
        )
    )
    round_about = subject.task.model_copy(update={"goal": goal})
    report = caught(
        subject.model_copy(update={"task": round_about, "code": lower(round_about)}), "constraint", "support-cycle"
    )
    failure = report.failures[0]
    assert failure_class(failure) == "constraint"
    assert sorted(failure.facts["cycle"]) == ["red_block", "yellow_block"]
    assert {failure.span, *(label.span for label in failure.labels)} == {(0, 6), (7, 10)}


def test_a_redundant_predicate_is_noted_and_harmless() -> None:
    schema = task(
        "redundant",
        (tasks.cube("red"), tasks.cube("green"), tasks.cube("blue")),
        All(
            goals=(
                On(a=("red_block",), b=("green_block",)),
                On(a=("green_block",), b=("blue_block",)),
                Above(a=("red_block",), b=("blue_block",), span=(0, 3)),
            )
        ),
    )
    reports = run(program(schema))
    assert admitted(reports)
    notes = reports[3].diagnostics
    assert [(d.code, d.severity, d.span) for d in notes] == [("redundant-predicate", "note", (0, 3))]


def test_a_block_that_is_not_there_is_a_failure_of_the_smoke_gate() -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), 'self.on("red_block"', 'self.on("rod_block"')
    reports = run(subject)
    assert reports[-1].name == "smoke"
    assert failure_class(reports[-1].failures[0]) == "runtime"
    assert "code.py, line" in reports[-1].failures[0].facts["traceback"]


def test_other_objects_than_in_the_schema_are_caught() -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), 'name="red_block", color="red"', 'name="red_block", color="pink"')
    assert caught(subject, "smoke", "assets-differ").failures[0].facts["names"] == ["red_block"]


def test_a_task_that_does_not_repeat_is_caught() -> None:
    subject = program(tasks.RED_ON_YELLOW)
    bench = Bench(
        subject, FAST, prints={"steps": "1", "reset 0": "2"}, elsewhere=lambda: {"steps": "1", "reset 0": "3"}
    )
    report = DeterminismGate().check(subject, bench)
    assert [d.code for d in report.failures] == ["not-deterministic"]
    assert report.failures[0].facts["states"] == ["reset 0"]
    assert report.figures == {"states": 2, "differing": 1}


DAMAGES: tuple[tuple[str, str, str, str, str], ...] = (
    ("colon", "def _success(self) -> Verdict:", "def _success(self) -> Verdict", "syntax", "code-syntax"),
    ("method", "self.on(", "self.onn(", "api", "code-unknown-attribute"),
    ("keyword", '"yellow_block")\n        at', '"yellow_block", slak=1)\n        at', "api", "code-bad-call"),
    ("argument", 'self.on("red_block", "yellow_block")', 'self.on("red_block")', "api", "code-bad-call"),
    ("field", 'color="red"', 'colour="red"', "api", "code-bad-call"),
    ("import", "import BlockTask", "import BlockTsk", "api", "code-unknown-name"),
    ("module", "from rpg.env", "from rpg.core", "api", "code-import"),
    ("os", "from rpg.env", "import os\nfrom rpg.env", "api", "code-forbidden"),
    ("hook", "_on_reset", "_on_rest", "api", "code-unknown-hook"),
    ("no success", "_success(self)", "_on_step(self)", "api", "code-shape"),
    ("loose code", "class RedOnYellow", "print(1)\n\n\nclass RedOnYellow", "api", "code-shape"),
)


@pytest.mark.parametrize(("old", "new", "kind", "code"), [d[1:] for d in DAMAGES], ids=[d[0] for d in DAMAGES])
def test_damaged_text_is_caught_by_the_text_gate(old: str, new: str, kind: str, code: str) -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), old, new)
    reports = run(subject)
    assert len(reports) == 1 and reports[0].name == "text"
    found = {d.code: d for d in reports[0].failures}
    assert code in found
    assert failure_class(found[code]) == kind
    assert found[code].facts["file"] == "code.py"


HOSTILE = (
    "().__class__.__base__.__subclasses__()",
    "self.__init__.__globals__",
    "self._physics",
    "self.model.__class__",
    "__import__('os').system('true')",
    "eval('1')",
    "exec('1')",
    "open('/etc/passwd').read()",
    "getattr(self, '_physics')",
    "globals()",
    "vars(self)",
    "type(self)",
    "(lambda: 1)()",
    "f'{self}'",
    "'{0.__class__}'.format(self)",
    "10 ** 10 ** 10",
    "[x for x in self.__dict__]",
    "super().__init__",
    "BlockTask.__subclasses__()",
    "print('x')",
    "breakpoint()",
    "compile('1', '', 'eval')",
)


@pytest.mark.parametrize("expression", HOSTILE)
def test_hostile_expressions_do_not_pass_the_text_gate(expression: str) -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), "return _success_check", f"x = {expression}\n        return x")
    reports = run(subject)
    assert [r.name for r in reports] == ["text"]
    assert not reports[0].passed


def test_endless_code_is_ended_by_the_clock() -> None:
    loop = "for _ in range(1000000000000):\n            pass\n        return _success_check"
    subject = edited(program(tasks.RED_ON_YELLOW), "return _success_check", loop)
    reports = validate(subject, trusted=False, measures=FAST, limits=Limits(seconds=1.5))
    assert [d.code for d in reports[-1].failures] == ["code-times-out"]
    assert failure_class(reports[-1].failures[0]) == "runtime"


def test_a_memory_bomb_is_contained() -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), "return _success_check", "x = [0] * 10000000000\n        return x")
    reports = run(subject)
    assert not reports[-1].passed
    assert failure_class(reports[-1].failures[0]) == "runtime"


def test_logs_are_the_same_every_time_and_name_no_machine() -> None:
    subject = program(tasks.STAGES)
    logs = {render_log(subject, run(subject)) for _ in range(2)}
    assert len(logs) == 1
    assert "/" not in logs.pop().replace("mm/s", "")


@pytest.mark.parametrize("line", ["on = 5", "reset = 1", "_memory = 1", "blocks = [().__class__]", "step = None"])
def test_values_of_the_class_hide_nothing(line: str) -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), "    def _initialize_env", f"    {line}\n\n    def _initialize_env")
    reports = run(subject)
    assert [r.name for r in reports] == ["text"]
    assert not reports[0].passed


def test_values_of_the_class_may_be_lists_of_names() -> None:
    subject = edited(
        program(tasks.RED_ON_YELLOW), "    def _init", '    both = ("red_block", "yellow_block")\n\n    def _init'
    )
    subject = edited(subject, 'self.scatter("red_block", "yellow_block")', "self.scatter(*self.both)")
    assert admitted(run(subject))


@pytest.mark.parametrize("code", ["def f():\n            pass", "class A:\n            pass", "from rpg.env import On"])
def test_nothing_is_defined_inside_of_a_method(code: str) -> None:
    subject = edited(program(tasks.RED_ON_YELLOW), "return _success_check", f"{code}\n        return _success_check")
    reports = run(subject)
    assert [r.name for r in reports] == ["text"]
    assert "code-shape" in {d.code for d in reports[0].failures}
