"""rpg check: a task's goal on states that somebody recorded."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Annotated

import typer

from rpg.cli.options import WORKSPACE, Json, Quiet, Seed, Task, Tasks, find, load_mujoco

EXAMPLE = "rpg check red-on-blue --states states.jsonl"
States = Annotated[
    Path, typer.Option("--states", metavar="FILE.jsonl", help="One state or trajectory a line; - reads from stdin.")
]


def run(
    task: Task, states: States, seed: Seed = 0, tasks: Tasks = WORKSPACE, as_json: Json = False, quiet: Quiet = False
) -> None:
    """Judge given states by the goal of TASK: one line of JSON in, one out, as they come.

    A line is {"objects": {name: {"position": [x, y, z], "orientation": [w, x, y, z]}}} or {"trajectory": [...]} of
    such states, the first of which is the start of the episode. The start of a single state is the reset of --seed.
    A state is taken to be at rest, with nothing held. Exit status 1 if any line is not a success.
    """
    load_mujoco()
    from rpg.cli.output import Output
    from rpg.evaluate.recorded import judge_lines
    from rpg.loading import load_version

    loaded = load_version(find(task, tasks))
    missed = False
    with _lines(states) as lines:
        live = states == Path("-")
        for success, line in judge_lines(loaded.task_class(), lines, str(states), seed):
            missed = missed or not success
            sys.stdout.write(line)
            if live:
                sys.stdout.flush()
    Output(as_json, quiet).finish(1 if missed else 0)


@contextmanager
def _lines(path: Path) -> Iterator[IO[bytes]]:
    if path == Path("-"):
        yield sys.stdin.buffer
    else:
        with path.open("rb") as file:
            yield file
