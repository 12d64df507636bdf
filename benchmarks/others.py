"""Other simulators' stacking tasks, and ours, on one machine: create, reset, step.

robosuite, dm_control and gymnasium-robotics need an older MuJoCo than rpg is best with, so that this script runs in an
environment of its own and starts ours with the Python that OURS names:

    make bench-others

prints how that environment is made. A package that is missing is said to be so.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from collections.abc import Callable
from typing import Any

os.environ.setdefault("MUJOCO_GL", "egl")
RESETS, STEPS = 5, 500

Timed = dict[str, float]


def timed(create: Callable[[], Any], reset: Callable[[Any], Any], step: Callable[[Any], Any]) -> Timed:
    """Seconds to create and to reset (mean of RESETS), and environment steps per second, in processor time."""
    begun = time.process_time()
    env = create()
    created = time.process_time()
    for _ in range(RESETS):
        reset(env)
    reset_done = time.process_time()
    for _ in range(STEPS):
        step(env)
    rate = STEPS / (time.process_time() - reset_done)
    return {"create_s": created - begun, "reset_s": (reset_done - created) / RESETS, "steps_per_s": rate}


def robosuite() -> Timed:
    import numpy as np
    import robosuite as suite

    options = {"has_renderer": False, "has_offscreen_renderer": False, "use_camera_obs": False, "ignore_done": True}
    return timed(
        lambda: suite.make("Stack", robots="Panda", **options), lambda e: e.reset(), lambda e: e.step(np.zeros(7))
    )


def fetch() -> Timed:
    import gymnasium
    import gymnasium_robotics
    import numpy as np

    gymnasium.register_envs(gymnasium_robotics)
    return timed(
        lambda: gymnasium.make("FetchPickAndPlace-v4", max_episode_steps=10**6),
        lambda e: e.reset(seed=0),
        lambda e: e.step(np.zeros(4, dtype=np.float32)),
    )


def dm_control() -> Timed:
    import numpy as np
    from dm_control import suite

    return timed(
        lambda: suite.load("stacker", "stack_2"),
        lambda e: e.reset(),
        lambda e: e.step(np.zeros(e.action_spec().shape)),
    )


def ours() -> Timed:
    import numpy as np

    from rpg.env.gym import BlockEnv
    from rpg.passes.validate.load import load
    from rpg.pipeline import compile_instruction

    program = compile_instruction("put the red block on the blue block").program
    assert program is not None
    task_class = load(program.code, program.goal_code)[0]
    action = np.zeros(7, dtype=np.float32)
    return timed(lambda: BlockEnv(task_class), lambda e: e.reset(seed=0), lambda e: e.step(action))


OTHERS = {
    "robosuite Stack": robosuite,
    "dm_control stacker stack_2": dm_control,
    "FetchPickAndPlace-v4": fetch,
}


def there(python: str) -> dict[str, Timed | str]:
    """Ours, measured by this script under another Python."""
    done = subprocess.run([python, __file__, "--ours"], capture_output=True, text=True, check=False)
    return json.loads(done.stdout) if done.returncode == 0 else {"rpg": done.stderr.strip().splitlines()[-1]}


def main() -> None:
    """Print a line for every environment."""
    if "--ours" in sys.argv:
        print(json.dumps({"rpg, one block on another": ours()}))
        return
    found: dict[str, Timed | str] = there(os.environ.get("OURS", sys.executable))
    for name, measure in OTHERS.items():
        try:
            found[name] = measure()
        except ImportError as error:
            found[name] = f"not measured: {error}"
    for name, figures in found.items():
        if isinstance(figures, str):
            print(f"{name:28} {figures}")
        else:
            print(
                f"{name:28} create {1000 * figures['create_s']:8.1f} ms   reset {1000 * figures['reset_s']:7.2f} ms   "
                f"{figures['steps_per_s']:7.0f} steps/s"
            )


if __name__ == "__main__":
    main()
