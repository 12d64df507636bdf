"""The options that commands share, so that they are spelled and explained alike everywhere."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from rpg.store import Version, Workspace

Task = Annotated[str, typer.Argument(metavar="TASK", help="A directory, family, family@2, or the start of a hash.")]
Tasks = Annotated[
    Path, typer.Option("--tasks", metavar="DIR", envvar="RPG_TASKS", help="The workspace that holds the tasks.")
]
Json = Annotated[bool, typer.Option("--json", help="Write one JSON document to stdout.")]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="Say nothing but errors and results asked for.")]
NoPictures = Annotated[bool, typer.Option("--no-pictures", help="Draw nothing.")]
Seed = Annotated[int, typer.Option("--seed", min=0, metavar="N", help="The seed of the reset.")]
WORKSPACE = Path("tasks")
"""Where tasks are unless --tasks or RPG_TASKS says otherwise."""


def find(task: str, tasks: Path) -> Version:
    """The version that a TASK argument names."""
    from rpg.store import resolve

    return resolve(workspace(tasks), task)


def workspace(tasks: Path) -> Workspace:
    """The workspace that --tasks names."""
    from rpg.store import Workspace

    return Workspace(tasks)


def clean(argument: str) -> str:
    """An argument as text that can be written anywhere: bytes that were no UTF-8 become replacement characters."""
    return argument.encode("utf-8", "surrogateescape").decode("utf-8", "replace")


def load_mujoco() -> None:
    """Import MuJoCo without a window system behind it."""
    from rpg.headless import load_mujoco

    load_mujoco()
