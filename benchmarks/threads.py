"""Whether threaded rollouts would help a compile: the resets of the gates stepped one after the other, and at once.

`python benchmarks/threads.py` prints, for scenes of several sizes, the time of eight starts that are each stepped for a
control step (what the gates do) and for a hundred, by `mj_step` in turn and by `mujoco.rollout` on two threads.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable

os.environ.setdefault("MUJOCO_GL", "disable")

import mujoco
import numpy as np
from bench import SIZES, schema_of
from mujoco.rollout import Rollout

from rpg.blocks.constants import SUBSTEPS
from rpg.blocks.physics import Physics
from rpg.passes.validate import Measures
from rpg.passes.validate.load import load
from rpg.pipeline import compile_schema

STARTS = Measures().resets
THREADS = 2
FULL = mujoco.mjtState.mjSTATE_FULLPHYSICS


def best(work: Callable[[], object], repeats: int = 5) -> float:
    """The least wall time (ms) of several runs."""
    times = []
    for _ in range(repeats):
        begun = time.perf_counter()
        work()
        times.append(1000 * (time.perf_counter() - begun))
    return min(times)


def measure(count: int, steps: int) -> tuple[float, float, bool]:
    """Milliseconds one after the other and on threads, and whether both end in the same bits."""
    program = compile_schema(schema_of(count)).program
    assert program is not None
    task = load(program.code, program.goal_code)[0]()
    states = [task.reset(seed) for seed in range(STARTS)]
    physics = [Physics(task.world, task.model) for _ in states]
    begin = np.zeros((STARTS, mujoco.mj_stateSize(task.model, FULL)))
    for index, (state, one) in enumerate(zip(states, physics, strict=True)):
        one.write(state)
        mujoco.mj_getState(one.model, one.data, begin[index], FULL)
    ends = np.zeros_like(begin)

    def in_turn() -> None:
        for index, one in enumerate(physics):
            mujoco.mj_resetData(one.model, one.data)
            mujoco.mj_setState(one.model, one.data, begin[index], FULL)
            mujoco.mj_step(one.model, one.data, SUBSTEPS * steps)
            mujoco.mj_getState(one.model, one.data, ends[index], FULL)

    datas = [mujoco.MjData(task.model) for _ in range(THREADS)]
    with Rollout(nthread=THREADS) as pool:
        threaded = best(lambda: pool.rollout([task.model] * STARTS, datas, begin, nstep=SUBSTEPS * steps))
        found = pool.rollout([task.model] * STARTS, datas, begin, nstep=SUBSTEPS * steps)[0][:, -1]
    alone = best(in_turn)
    return alone, threaded, bool((found == ends).all())


def main() -> None:
    """Print a line for every size and length."""
    for steps in (1, 100):
        for count in SIZES:
            alone, threaded, same = measure(count, steps)
            print(
                f"{STARTS} starts of {count:2} blocks, {steps:3} control steps: {alone:8.2f} ms in turn, "
                f"{threaded:8.2f} ms on {THREADS} threads, {'the same' if same else 'other'} bits",
                flush=True,
            )


if __name__ == "__main__":
    main()
