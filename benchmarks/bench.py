"""Measures speed, each figure beside the least that MuJoCo or Python need for the same work, and what it may be.

`python benchmarks/bench.py` prints a table; `--json` prints the figures as data. Times are processor times.
"""

from __future__ import annotations

import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from functools import partial
from pathlib import Path
from unittest.mock import patch

os.environ.setdefault("MUJOCO_GL", "disable")

import mujoco
import numpy as np

from rpg.benchmark.suites import SUITES, read_suite
from rpg.blocks.constants import SUBSTEPS
from rpg.blocks.heaps import dropped
from rpg.blocks.physics import QUIET_STEPS, Physics
from rpg.blocks.scene import build_spec
from rpg.blocks.state import World
from rpg.env import BlockTask
from rpg.env.gym import BlockEnv
from rpg.evaluate.recorded import judge_lines
from rpg.ir.assets import Color, ColoredCube
from rpg.ir.goal import Goal, Grid, On, Pyramid, Row
from rpg.ir.schema import TaskSchema
from rpg.passes.repair.placing import state_of
from rpg.passes.validate import Measures
from rpg.passes.validate.load import load
from rpg.pipeline import CompileOptions, Outcome, compile_instruction, compile_schema
from rpg.publishing import publish
from rpg.steering import steer
from rpg.store import Workspace, Written, dump_schema

COLORS: tuple[Color, ...] = ("red", "orange", "yellow", "green", "cyan", "blue", "purple", "pink", "brown", "black")
SIZES = (2, 5, 14, 27)
STATES = 10_000
STATES_PER_SECOND = 5_000
DEMO = "put red on yellow"
STEERS = (
    ("put the red block on the yellow block", "add a green block on top"),
    ("arrange the red, green, blue and yellow blocks in a row", "make the red block white"),
    ("build a pyramid of 14 red blocks", "make the blocks blue"),
)
"""A first instruction, and an edit of it."""


Clock = Callable[[], float]


@dataclass(frozen=True)
class Figure:
    """A measured time in seconds beside its floor; `most`: what it may be, in seconds, or `most_ratio` floors."""

    what: str
    value: float
    floor: float | None = None
    floor_is: str = ""
    most: float | None = None
    most_ratio: float | None = None

    @property
    def ratio(self) -> float | None:
        return self.value / self.floor if self.floor else None

    @property
    def within(self) -> bool | None:
        """Is it within its budget? None where it has none."""
        if self.most_ratio is not None and self.ratio is not None:
            return self.ratio <= self.most_ratio
        return None if self.most is None else self.value <= self.most


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


def median_time(work: Callable[[], object], repeats: int, clock: Clock = time.process_time) -> float:
    """Median time of `work`, after one run that does not count: processor time of this process, unless told otherwise,
    so that figures can be compared on a machine that does other things."""
    work()
    times = []
    for _ in range(repeats):
        begun = clock()
        work()
        times.append(clock() - begun)
    return statistics.median(times)


def alternately(one: Callable[[], object], other: Callable[[], object], repeats: int) -> tuple[float, float]:
    """Median processor times of two kinds of work that take turns, so that both meet the same machine."""
    times: tuple[list[float], list[float]] = ([], [])
    for _ in range(repeats):
        for work, taken in zip((one, other), times, strict=True):
            begun = time.process_time()
            work()
            taken.append(time.process_time() - begun)
    return statistics.median(times[0]), statistics.median(times[1])


def processes_time() -> float:
    """Processor time of the processes that this one has started and seen the end of."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def mandated(outcome: Outcome) -> Callable[[], None]:
    """The least physics that the gates call for, as raw MuJoCo calls that keep everything awake: the scene compiled, a
    look at every reset (where blocks start on each other, after they have settled; heaps fall first, between walls and
    until they lie still, but for those falls that leave no heap), the smoke steps, the goal settled and held. The
    process that repeats resets for the gate of determinism works beside this one; it is left out here as it is in the
    figure."""
    program, measures = outcome.program, Measures()
    assert program is not None
    task = load(program.code, program.goal_code)[0]()
    goal = state_of(program.path[-1], World(program.task.assets))
    with patch("rpg.blocks.initial.dropped", wraps=dropped) as fall:
        starts = [(task.reset(seed), fall.call_args) for seed in range(measures.resets)]
    look = 1 + (QUIET_STEPS if program.task.init.arranged and not program.task.init.heaps else 0)

    def work() -> None:
        physics = Physics(goal.world, build_spec(program.task.assets).compile())
        for start, fallen in starts:
            if fallen is not None:
                dropped(*fallen.args)
            physics.write(start)
            mujoco.mj_step(physics.model, physics.data, SUBSTEPS * look)
        physics.write(starts[0][0])
        mujoco.mj_step(physics.model, physics.data, SUBSTEPS * measures.smoke_steps)
        physics.write(goal)
        mujoco.mj_step(physics.model, physics.data, SUBSTEPS * (measures.settle_steps + measures.hold_steps))

    return work


def compiles() -> Iterator[Figure]:
    for count in SIZES:
        schema = schema_of(count)
        outcome = compile_schema(schema)
        warm, floor = alternately(partial(compile_schema, schema), mandated(outcome), 25 if count < 20 else 7)
        yield Figure(f"warm compile, {count} blocks", warm, floor, "MuJoCo's share, awake", most_ratio=1.3)


def sentences() -> Iterator[Figure]:
    """Compiles of what people say: of one sentence, and of all that a suite begins with. Paraphrases are apart: each
    takes about as long as the sentence to read, and says nothing about whether the task is right."""
    suites = {f"the {suite} suite": [e.instruction for e in read_suite(suite)] for suite in SUITES}
    for what, said in {f'"{DEMO}"': [DEMO], **suites}.items():
        plain, phrased, floor = 0.0, 0.0, 0.0
        for text in said:
            raw = mandated(compile_instruction(text))
            for options in (CompileOptions(paraphrases=0), CompileOptions()):
                work = partial(compile_instruction, text, options)
                one, other = alternately(work, raw, 7)
                if options.paraphrases:
                    phrased += one / len(said)
                else:
                    plain, floor = plain + one / len(said), floor + other / len(said)
        yield Figure(f"warm compile, {what}", plain, floor, "MuJoCo's share, awake", most_ratio=2.0)
        yield Figure("… with two paraphrases read back", phrased, floor, "MuJoCo's share, awake")


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
        yield Figure(f"warm steer, {edit}", next(warm), next(warm), "compile of its result", most_ratio=1.5)


def rpg(*arguments: str) -> Callable[[], object]:
    return lambda: subprocess.run([sys.executable, "-m", "rpg", *arguments], check=True, capture_output=True)


def processes() -> Iterator[Figure]:
    def timed(work: Callable[[], object], repeats: int) -> float:
        return median_time(work, repeats, processes_time)

    bare = timed(lambda: subprocess.run([sys.executable, "-c", ""], check=True), 7)
    yield Figure("rpg --help", timed(rpg("--help"), 7), bare, "an empty Python")
    imports = [sys.executable, "-c", "import mujoco, numpy, pydantic"]
    libraries = timed(lambda: subprocess.run(imports, check=True, capture_output=True), 5)
    for count in SIZES:
        with tempfile.TemporaryDirectory() as directory:
            source = Path(directory, "task.yaml")
            source.write_text(dump_schema(schema_of(count)))
            common = ("--no-pictures", "-q", "--from", str(source), "--tasks")
            places = (str(Path(directory, str(number))) for number in range(100))
            cold = timed(lambda common=common, places=places: rpg("compile", *common, next(places))(), 3)  # type: ignore[misc]
        yield Figure(f"cold compile, {count} blocks", cold, libraries, "importing mujoco, numpy, pydantic")


def running() -> Iterator[Figure]:
    for count in SIZES:
        outcome = compile_schema(schema_of(count))
        assert outcome.program is not None
        yield from _running(count, load(outcome.program.code, outcome.program.goal_code)[0])


def _running(count: int, task_class: type[BlockTask]) -> Iterator[Figure]:
    task = task_class()
    state = task.reset(0)
    poses = {n: {"position": list(p), "orientation": list(state.orientation[n])} for n, p in state.position.items()}
    line = json.dumps({"objects": poses}).encode()
    parse = median_time(lambda: [json.loads(line) for _ in range(STATES)], 1)
    judged = median_time(lambda: sum(1 for _ in judge_lines(task, [line] * STATES, "bench", 0)), 1)
    title = f"rpg check, {STATES:,} states of {count} blocks"
    yield Figure(title, judged, parse, "parsing their JSON", most=STATES / STATES_PER_SECOND if count == 5 else None)
    seeds = iter(range(10_000))
    reset = median_time(lambda: task.reset(next(seeds)), 200)
    yield Figure(f"reset, {count} blocks", reset, most=0.001 if count == 5 else None)
    env = BlockEnv(task_class)
    env.reset(seed=0)
    action = np.zeros(7, dtype=np.float32)
    model, data = env.unwrapped.task.model, env.unwrapped.task.data
    stepped, raw = alternately(lambda: env.step(action), lambda: mujoco.mj_step(model, data, SUBSTEPS), 400)
    yield Figure(f"env step, {count} blocks", stepped, raw, f"{SUBSTEPS} calls of mj_step", most_ratio=1.1)


def shown(figure: Figure) -> str:
    """One line of the table."""
    ratio = f"{figure.ratio:5.2f}x" if figure.ratio else ""
    floor = f"{1000 * figure.floor:9.2f} ms  {figure.floor_is}" if figure.floor else ""
    most = f"{figure.most_ratio}x" if figure.most_ratio else f"{1000 * figure.most:g} ms" if figure.most else ""
    verdict = "" if figure.within is None else f"{'within' if figure.within else 'OVER'} {most}"
    return f"{figure.what:38} {1000 * figure.value:9.2f} ms  {ratio:6} {verdict:14} {floor}".rstrip()


def main() -> None:
    """Print every figure as it is measured."""
    found = []
    for group in (processes, compiles, sentences, steers, running):
        for figure in group():
            found.append(figure)
            if "--json" not in sys.argv:
                print(shown(figure), flush=True)
    if "--json" in sys.argv:
        print(
            json.dumps(
                [asdict(figure) | {"ratio": figure.ratio, "within": figure.within} for figure in found], indent=2
            )
        )


if __name__ == "__main__":
    main()
