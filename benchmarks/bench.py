"""Measures speed, each figure beside the least that MuJoCo or Python need for the same work.

`python benchmarks/bench.py` prints a table; `--json` prints the figures as data.
"""

from __future__ import annotations

import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from pathlib import Path

os.environ.setdefault("MUJOCO_GL", "disable")

import mujoco
import numpy as np

from rpg.blocks.constants import SUBSTEPS
from rpg.blocks.physics import Physics
from rpg.blocks.scene import build_spec
from rpg.blocks.state import World
from rpg.env.gym import BlockEnv
from rpg.evaluate.recorded import judge_lines
from rpg.ir.assets import Color, ColoredCube
from rpg.ir.goal import Goal, Grid, On, Pyramid, Row
from rpg.ir.schema import TaskSchema
from rpg.passes.repair.placing import state_of
from rpg.passes.validate import Measures
from rpg.passes.validate.load import load
from rpg.pipeline import Outcome, compile_instruction, compile_schema
from rpg.publishing import publish
from rpg.steering import steer
from rpg.store import Workspace, Written, dump_schema

COLORS: tuple[Color, ...] = ("red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink", "brown", "black")
SIZES = (2, 5, 14, 27)
STATES = 10_000
STEERS = (
    ("put the red block on the yellow block", "add a green block on top"),
    ("arrange the red, green, blue and yellow blocks in a row", "make the red block white"),
    ("build a pyramid of 14 red blocks", "make the blocks blue"),
)
"""A first instruction, and an edit of it."""


@dataclass(frozen=True)
class Figure:
    """A measured time in seconds (or a rate) beside its floor."""

    what: str
    value: float
    unit: str
    floor: float | None = None
    floor_is: str = ""

    @property
    def ratio(self) -> float | None:
        return self.value / self.floor if self.floor else None


def schema_of(count: int) -> TaskSchema:
    """A task of `count` blocks: one on another, a row, a pyramid, a cube."""
    assets = tuple(ColoredCube(name=f"block_{i}", color=COLORS[i % len(COLORS)]) for i in range(count))
    names = tuple(asset.name for asset in assets)
    goals: dict[int, Goal] = {
        2: On(a=names[0], b=names[1]),
        5: Row(blocks=names),
        14: Pyramid(blocks=names, base=(3, 3)),
        27: Grid(blocks=names, rows=3, columns=3, layers=3),
    }
    return TaskSchema(name=f"blocks-{count}", instruction=f"{count} blocks", assets=assets, goal=goals[count])


def median_time(work: Callable[[], object], repeats: int) -> float:
    """Median wall time of `work`, after one run that does not count."""
    work()
    times = []
    for _ in range(repeats):
        begun = time.perf_counter()
        work()
        times.append(time.perf_counter() - begun)
    return statistics.median(times)


def mandated(outcome: Outcome) -> Callable[[], None]:
    """The least physics that the gates call for: one spec compile, the smoke steps, the goal's settling and holding,
    and the settling of every reset, as raw MuJoCo calls."""
    program, measures = outcome.program, Measures()
    assert program is not None
    task = load(program.code, program.goal_code)[0]()
    goal = state_of(program.path[-1], World(program.task.assets))
    starts = [task.reset(seed) for seed in range(measures.resets)]

    def work() -> None:
        physics = Physics(goal.world, build_spec(program.task.assets).compile())
        physics.write(goal)
        mujoco.mj_step(physics.model, physics.data, SUBSTEPS * (measures.settle_steps + measures.hold_steps))
        for start in starts:
            physics.write(start)
            mujoco.mj_step(physics.model, physics.data, SUBSTEPS * 4)
        physics.write(starts[0])
        mujoco.mj_step(physics.model, physics.data, SUBSTEPS * measures.smoke_steps)

    return work


def compiles() -> Iterator[Figure]:
    for count in SIZES:
        schema = schema_of(count)
        repeats = 7 if count < 20 else 3
        outcome = compile_schema(schema)
        warm = median_time(lambda schema=schema: compile_schema(schema), repeats)  # type: ignore[misc]
        floor = median_time(mandated(outcome), repeats)
        yield Figure(f"warm compile, {count} blocks", warm, "s", floor, "MuJoCo's share of it")


def steers() -> Iterator[Figure]:
    """Steers beside the compile of the sentence that they lead to, both in processor time and with publishing."""
    for base, edit in STEERS:
        with tempfile.TemporaryDirectory() as directory:
            root = Path(directory)
            steered, compiled = [], []
            for number in range(8):
                first = publish(compile_instruction(base), Workspace(root / str(number)))
                assert isinstance(first, Written)
                begun = time.process_time()
                done = steer(first.version, edit)
                steered.append(time.process_time() - begun)
                assert done.outcome is not None and done.outcome.schema is not None
                sentence = done.outcome.schema.instruction
                begun = time.process_time()
                publish(compile_instruction(sentence), Workspace(root / f"{number} compiled"))
                compiled.append(time.process_time() - begun)
        warm = (statistics.median(times[1:]) for times in (steered, compiled))
        yield Figure(f"warm steer, {edit}", next(warm), "s", next(warm), "compile of its result")


def rpg(*arguments: str) -> Callable[[], object]:
    return lambda: subprocess.run([sys.executable, "-m", "rpg", *arguments], check=True, capture_output=True)


def processes() -> Iterator[Figure]:
    bare = median_time(lambda: subprocess.run([sys.executable, "-c", ""], check=True), 7)
    yield Figure("rpg --help", median_time(rpg("--help"), 7), "s", bare, "an empty Python")
    imports = [sys.executable, "-c", "import mujoco, numpy, pydantic"]
    libraries = median_time(lambda: subprocess.run(imports, check=True, capture_output=True), 5)
    with tempfile.TemporaryDirectory() as directory:
        source = Path(directory, "task.yaml")
        source.write_text(dump_schema(schema_of(5)))
        common = ("--no-pictures", "-q", "--from", str(source), "--tasks")
        places = (str(Path(directory, str(number))) for number in range(100))
        cold = median_time(lambda: rpg("compile", *common, next(places))(), 5)
    yield Figure("cold compile, 5 blocks", cold, "s", libraries, "importing mujoco, numpy, pydantic")


def running() -> Iterator[Figure]:
    outcome = compile_schema(schema_of(5))
    assert outcome.program is not None
    task_class = load(outcome.program.code, outcome.program.goal_code)[0]
    task = task_class()
    state = task.reset(0)
    poses = {n: {"position": list(p), "orientation": list(state.orientation[n])} for n, p in state.position.items()}
    line = json.dumps({"objects": poses}).encode()
    parse = median_time(lambda: [json.loads(line) for _ in range(STATES)], 3)
    judged = median_time(lambda: sum(1 for _ in judge_lines(task, [line] * STATES, "bench", 0)), 3)
    yield Figure(f"rpg check, {STATES:,} states of 5 blocks", judged, "s", parse, "parsing their JSON")
    seeds = iter(range(10_000))
    yield Figure("reset, 5 blocks", median_time(lambda: task.reset(next(seeds)), 200), "s")
    env = BlockEnv(task_class)
    env.reset(seed=0)
    action = np.zeros(7, dtype=np.float32)
    stepped = median_time(lambda: env.step(action), 400)
    model, data = env.unwrapped.task.model, env.unwrapped.task.data
    raw = median_time(lambda: mujoco.mj_step(model, data, SUBSTEPS), 400)
    yield Figure("env step, 5 blocks", stepped, "s", raw, f"{SUBSTEPS} calls of mj_step")


def shown(figure: Figure) -> str:
    """One line of the table."""
    floor = f"{1000 * figure.floor:9.2f} ms  {figure.floor_is}" if figure.floor else ""
    ratio = f"{figure.ratio:5.1f}x" if figure.ratio else "      "
    return f"{figure.what:36} {1000 * figure.value:9.2f} ms  {ratio} {floor}".rstrip()


def main() -> None:
    """Print every figure as it is measured."""
    found = []
    for group in (processes, compiles, steers, running):
        for figure in group():
            found.append(figure)
            if "--json" not in sys.argv:
                print(shown(figure), flush=True)
    if "--json" in sys.argv:
        print(json.dumps([asdict(figure) | {"ratio": figure.ratio} for figure in found], indent=2))


if __name__ == "__main__":
    main()
