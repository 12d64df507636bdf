"""rpg compile: an instruction, or a task.yaml, into a verified task."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rpg.cli.options import WORKSPACE, Json, NoPictures, Quiet, Tasks, clean, load_mujoco, workspace

if TYPE_CHECKING:
    from rpg.core.passes import Listener
    from rpg.pipeline import CompileOptions, Outcome

EXAMPLE = 'rpg compile "Stack the red block on the blue block" --seed 3'
SETTINGS = {"allow_extra_args": True}
"""Words without quotes are told from a mistake of another kind."""

Instruction = Annotated[str | None, typer.Argument(metavar="[INSTRUCTION]", help="What is to be done, in English.")]
Name = Annotated[str | None, typer.Option("--name", metavar="NAME", help="The family's name; made up without it.")]
SeedOption = Annotated[
    int | None, typer.Option("--seed", min=0, metavar="N", help="Another seed, other states; 0 without it.")
]
Author = Annotated[str | None, typer.Option("--author", metavar="WHO", help="Recorded in task.yaml.")]
Source = Annotated[
    Path | None, typer.Option("--from", metavar="task.yaml", help="Build from this file instead of an instruction.")
]


def run(
    context: typer.Context,
    instruction: Instruction = None,
    name: Name = None,
    seed: SeedOption = None,
    author: Author = None,
    source: Source = None,
    tasks: Tasks = WORKSPACE,
    no_pictures: NoPictures = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Compile INSTRUCTION into version 0 of a family of tasks: schema, code, a goal state, and the checks that they
    passed. Prints what was understood and where the task is. Exit status 3 if the instruction is refused, with the
    reason; 1 if a check fails."""
    load_mujoco()
    from rpg.cli.output import Output
    from rpg.cli.progress import progress
    from rpg.cli.summary import print_outcome
    from rpg.core.diagnostics import UsageError
    from rpg.publishing import publish, summary

    if context.args:
        words = clean(" ".join([instruction or "", *context.args]))
        raise UsageError(f'put the instruction in quotes: rpg compile "{words}"')
    out = Output(as_json, quiet)
    with progress(out) as listen:
        options = _options(name, seed, author, not no_pictures, listen)
        outcome = _compiled(instruction, source, options, seed)
        place = publish(outcome, workspace(tasks), explicit=name is not None)
    out.document(summary(outcome, place))
    print_outcome(out, outcome, place)
    out.finish({"admitted": 0, "failed": 1, "refused": 3}[outcome.status])


def _options(
    name: str | None, seed: int | None, author: str | None, pictures: bool, listen: Listener
) -> CompileOptions:
    from rpg.core.diagnostics import UsageError
    from rpg.ir.schema import NAME
    from rpg.pipeline import CompileOptions

    if name is not None and not (re.fullmatch(NAME, name) and len(name) <= 60):
        raise UsageError(
            f"--name {name!r}: a name is lower-case words and numbers joined by hyphens, as in red-on-blue"
        )
    author = clean(author) if author is not None else None
    if author is not None and not author.isprintable():
        raise UsageError("--author: a name has no control characters in it")
    return CompileOptions(name=name, seed=seed or 0, author=author, pictures=pictures, listen=listen)


def _compiled(instruction: str | None, source: Path | None, options: CompileOptions, seed: int | None) -> Outcome:
    from rpg.core.diagnostics import UsageError
    from rpg.pipeline import compile_instruction, compile_schema
    from rpg.store import read_schema

    if (instruction is None) == (source is None):
        raise UsageError('give an instruction, as in rpg compile "Stack the red block on the blue one", or --from FILE')
    if source is None:
        return compile_instruction(clean(instruction or ""), options)
    told = {"name": options.name, "author": options.author, "seed": seed}
    changes = {field: value for field, value in told.items() if value is not None}
    return compile_schema(read_schema(source).model_copy(update=changes), options)
