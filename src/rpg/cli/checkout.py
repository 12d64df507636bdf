"""rpg checkout: make another version of a family the current one."""

from __future__ import annotations

from typing import Annotated

import typer

from rpg.cli.options import WORKSPACE, Json, Quiet, Task, Tasks, workspace

EXAMPLE = "rpg checkout red-on-blue 0"
Wanted = Annotated[str, typer.Argument(metavar="VERSION", help="A version's number, or the start of its hash.")]


def run(task: Task, version: Wanted, tasks: Tasks = WORKSPACE, as_json: Json = False, quiet: Quiet = False) -> None:
    """Make VERSION of TASK's family the current one. Nothing is lost: later versions stay where they are."""
    from rpg.cli.output import Output
    from rpg.store import Workspace, resolve, resolve_family, set_head

    out = Output(as_json, quiet)
    family = resolve_family(workspace(tasks), task)
    found = resolve(Workspace(family.directory.parent), f"{family.name}@{version}")
    set_head(found)
    out.document(
        {"family": found.family, "version": found.number, "hash": found.hash, "directory": str(found.directory)}
    )
    out.result.print(f"{found.family} is now at version {found.number} ({found.short_hash})")
