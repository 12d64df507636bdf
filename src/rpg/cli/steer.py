"""rpg steer: a sentence that changes a task, into a new version with its proof."""

from __future__ import annotations

from typing import Annotated

import typer

from rpg.cli.options import WORKSPACE, Json, NoPictures, Quiet, Task, Tasks, clean, find, load_mujoco, workspace

EXAMPLE = 'rpg steer red-on-blue "Add a green block on top"'
Edit = Annotated[str, typer.Argument(metavar="EDIT", help="What is to change, in English.")]
From = Annotated[
    str | None, typer.Option("--from", metavar="VERSION", help="Start from this version instead of the current one.")
]


def run(
    task: Task,
    edit: Edit,
    source: From = None,
    tasks: Tasks = WORKSPACE,
    no_pictures: NoPictures = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Change TASK by a sentence. Prints what kind of change it is, the version it started from, what it preserved,
    and where the new version is. Exit status 3 if the sentence is refused; nothing has changed then."""
    load_mujoco()
    from rpg.cli.output import Output
    from rpg.cli.progress import progress
    from rpg.cli.steered import print_steered
    from rpg.pipeline import CompileOptions
    from rpg.steering import steer, steered_summary
    from rpg.store import resolve, resolve_family

    out = Output(as_json, quiet)
    version = find(task, tasks)
    if source is not None:
        family = resolve_family(workspace(tasks), task)
        version = resolve(workspace(tasks), f"{family.name}@{source.removeprefix('v')}")
    with progress(out) as listen:
        done = steer(version, clean(edit), CompileOptions(pictures=not no_pictures, listen=listen))
    out.document(steered_summary(done))
    print_steered(out, done)
    out.finish({"admitted": 0, "failed": 1, "refused": 3}[done.status])
