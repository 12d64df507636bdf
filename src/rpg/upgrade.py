"""What an upgrade of rpg or MuJoCo changed: gates run again, verdicts compared with those on record.

A record is one character per state of a bank: "1" where the goal held, "0" where it did not. The bank is made by
arithmetic on the goal scene that the version's own goal_state_code.py holds, never by physics or by the predicates
under test, so that the same states are judged before and after.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations
from random import Random

from rpg.blocks.state import BlockState, Vec3, World
from rpg.core.diagnostics import Diagnostic
from rpg.env.bench import judge_each
from rpg.ir.artifact import GateReport, Program
from rpg.loading import lowered
from rpg.passes.repair.placing import state_of
from rpg.passes.validate import admitted, render_log
from rpg.passes.validate.load import load
from rpg.pipeline import load_program, validate_program
from rpg.store import Version

SHIFTS: tuple[tuple[str, Vec3], ...] = (
    ("moved 6 mm to the left", (0.0, 0.006, 0.0)),
    ("moved 3 cm away", (0.03, 0.0, 0.0)),
    ("moved 9 cm to the right", (0.0, -0.09, 0.0)),
    ("lifted by 4 cm", (0.0, 0.0, 0.04)),
)
"""What happens to single blocks of the goal scene, in metres (x away from the viewer, y to the left)."""
MOST_BLOCKS = 8
MOST_SWAPS = 6
SCATTERED = 4
SPREAD = 0.2
"""Half the edge (m) of the square over which blocks are scattered."""


def bank(program: Program) -> Iterator[tuple[str, BlockState]]:
    """States to judge, each with what is done to the goal scene."""
    goal = state_of(program.path[-1], World(program.task.assets))
    names = sorted(goal.position)
    yield "the goal scene", goal
    for name in names[:MOST_BLOCKS]:
        x, y, z = goal.position[name]
        for what, (dx, dy, dz) in SHIFTS:
            yield f"{name} {what}", goal.moved({name: ((x + dx, y + dy, z + dz), goal.orientation[name])})
    for a, b in list(combinations(names, 2))[:MOST_SWAPS]:
        there, here = (goal.position[a], goal.orientation[b]), (goal.position[b], goal.orientation[a])
        yield f"{a} and {b} swapped", goal.moved({a: (here[0], here[1]), b: (there[0], there[1])})
    rng = Random("bank")
    for number in range(1, SCATTERED + 1):
        lowest = min(position[2] for position in goal.position.values())
        poses = {
            name: ((0.5 + rng.uniform(-SPREAD, SPREAD), rng.uniform(-SPREAD, SPREAD), lowest), goal.orientation[name])
            for name in names
        }
        yield f"all blocks scattered, {number}", goal.moved(poses)


def verdicts(program: Program) -> str:
    """The code's verdict on every state of the bank."""
    task = load(program.code, program.goal_code)[0]()
    world = World(program.task.assets)
    history = tuple(state_of(scene, world) for scene in program.path[:-1])
    judged = judge_each(task, history, [state for _, state in bank(program)])
    return "".join("1" if judgement.success else "0" for judgement in judged)


def recorded(version: Version) -> str:
    """The verdicts of a version on disk."""
    return verdicts(load_program(version.directory, version.schema))


def differences(version: Version, record: str | None) -> tuple[Diagnostic, ...]:
    """How a version differs, under the installed rpg and MuJoCo, from what was recorded when it was verified.

    An error: it no longer passes its gates, its goal judges a state otherwise, or task.yaml gives other code. A note:
    the same gates are passed with other figures.
    """
    program = load_program(version.directory, version.schema)
    found: list[Diagnostic] = []
    if version.snapshot.backend == "lower" and not lowered(version):
        found.append(_changed(version, "gives-other-code", "task.yaml gives other code than when it was written"))
    reports = validate_program(program)
    found += _gates(version, program, reports)
    if admitted(reports) and record is not None:
        found += _goal(version, program, record)
    return tuple(found)


def _gates(version: Version, program: Program, reports: tuple[GateReport, ...]) -> Iterator[Diagnostic]:
    if not admitted(reports):
        failed = reports[-1]
        why = next((diagnostic.message for diagnostic in failed.failures), "")
        yield _changed(version, "gate-no-longer-passed", f"the gate {failed.name} is no longer passed: {why}")
        return
    before, after = version.log.splitlines(), render_log(program, reports).splitlines()
    changed = [new for new in after if new not in before]
    if changed:
        lines = "; ".join(" ".join(line.split()) for line in changed)
        yield _changed(version, "figures-changed", f"the gates measure other figures: {lines}", note=True)


def _goal(version: Version, program: Program, record: str) -> Iterator[Diagnostic]:
    now = verdicts(program)
    if len(now) != len(record):
        yield _changed(version, "goal-changed", "the states on record are of another kind; build the task again")
        return
    states = [what for what, _ in bank(program)]
    other = [(what, new) for what, old, new in zip(states, record, now, strict=True) if old != new]
    if other:
        what, new = other[0]
        verb = "holds now where it did not" if new == "1" else "does not hold now where it did"
        yield _changed(version, "goal-changed", f"the goal {verb} in {len(other)} of {len(now)} states, first: {what}")


def _changed(version: Version, code: str, message: str, *, note: bool = False) -> Diagnostic:
    place = f"{version.family}/{version.directory.name}"
    return Diagnostic(
        code=code,
        severity="note" if note else "error",
        message=f"{place}: {message}",
        facts={"path": place},
        origin="upgrade",
    )
