"""rpg view: a task in MuJoCo's interactive viewer."""

from __future__ import annotations

from typing import Annotated

import typer

from rpg.cli.options import WORKSPACE, Json, Quiet, Seed, Task, Tasks, find, load_mujoco

EXAMPLE = "rpg view red-on-blue --goal"


def run(
    task: Task,
    goal: Annotated[bool, typer.Option("--goal", help="Show a goal state instead of a start.")] = False,
    seed: Seed = 0,
    tasks: Tasks = WORKSPACE,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Open TASK in MuJoCo's interactive viewer, at the reset of --seed or in its goal state. Double-click a block, then
    drag it with Ctrl and the right mouse button. Close the window, or press Ctrl-C, to end."""
    load_mujoco()
    from rpg.cli.health import has_display
    from rpg.cli.output import Output
    from rpg.core.diagnostics import Unavailable
    from rpg.loading import load_version

    version = find(task, tasks)
    if not has_display():
        raise Unavailable(
            "there is no display to open a window on (DISPLAY and WAYLAND_DISPLAY are not set); "
            f"rpg render {task} writes pictures instead"
        )
    from rpg.viewing import show

    loaded = load_version(version)
    shown = (loaded.goal_class if goal else loaded.task_class)(textures=True)
    shown.reset(seed)
    Output(as_json, quiet).document({"task": str(version), "seed": seed, "goal": goal})
    show(shown)
