"""rpg render: pictures of a task's start and goal."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from rpg.cli.options import WORKSPACE, Json, Quiet, Seed, Task, Tasks, find, load_mujoco

EXAMPLE = "rpg render red-on-blue --seed 3 --out pictures"
Target = Annotated[
    Path | None,
    typer.Option("--out", metavar="DIR", help="Where to; beside the task's files without it.", show_default=False),
]


def run(
    task: Task,
    out: Target = None,
    seed: Seed = 0,
    tasks: Tasks = WORKSPACE,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Draw TASK: initial.png, the reset of --seed as the viewer sees it, and goal.png, a goal state."""
    load_mujoco()
    from rpg.cli.output import Output
    from rpg.loading import load_version
    from rpg.publishing import write_pictures

    console = Output(as_json, quiet)
    version = find(task, tasks)
    directory = out or version.directory
    files = write_pictures(load_version(version), directory, seed)
    console.document({"directory": str(directory), "files": [str(path) for path in files]})
    for path in files:
        console.result.print(str(path), soft_wrap=True)
