"""rpg show: a task explained."""

from __future__ import annotations

from rpg.cli.options import WORKSPACE, Json, Quiet, Seed, Task, Tasks, find, load_mujoco

EXAMPLE = "rpg show red-on-blue --seed 3"


def run(task: Task, seed: Seed = 0, tasks: Tasks = WORKSPACE, as_json: Json = False, quiet: Quiet = False) -> None:
    """Explain TASK: what it understood of its instruction, its assets as the reset of --seed has them, its start,
    its goal, and the assumptions taken."""
    load_mujoco()
    from rpg.cli.explain import print_task
    from rpg.cli.output import Output
    from rpg.explain import explained, goal_outline
    from rpg.loading import load_version

    out = Output(as_json, quiet)
    loaded = load_version(find(task, tasks))
    data = explained(loaded, seed)
    out.document(data)
    print_task(out.result, loaded, data, goal_outline(loaded.schema))
