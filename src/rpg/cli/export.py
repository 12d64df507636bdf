"""rpg export: a task's scene for any MuJoCo user."""

from __future__ import annotations

from enum import StrEnum
from pathlib import Path
from typing import Annotated

import typer

from rpg.cli.options import WORKSPACE, Json, Quiet, Seed, Task, Tasks, find, load_mujoco

EXAMPLE = "rpg export red-on-blue --format mjcf --out scene"


class Format(StrEnum):
    """What a task can be written as."""

    mjcf = "mjcf"


Target = Annotated[
    Path | None, typer.Option("--out", metavar="DIR", help="Where to; <family>-mjcf without it.", show_default=False)
]


def run(
    task: Task,
    format: Annotated[Format, typer.Option("--format", help="What to write.")] = Format.mjcf,
    out: Target = None,
    seed: Seed = 0,
    tasks: Tasks = WORKSPACE,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Write the scene of TASK as MJCF with its textures, loadable by plain MuJoCo. Its keyframes are the start (the
    reset of --seed) and a goal state."""
    load_mujoco()
    from rpg.cli.output import Output
    from rpg.exporting import export_mjcf
    from rpg.loading import load_version

    console = Output(as_json, quiet)
    version = find(task, tasks)
    directory = out or Path(f"{version.family}-{format.value}")
    files = export_mjcf(load_version(version), directory, seed)
    console.document({"directory": str(directory), "files": [str(path) for path in files]})
    console.result.print(f"{directory / 'scene.xml'} and {len(files) - 1} textures")
