"""rpg session: an instruction and its edits, from a file or as they are typed."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from rpg.cli.options import WORKSPACE, Json, NoPictures, Quiet, Tasks, load_mujoco, workspace

if TYPE_CHECKING:
    from rpg.cli.output import Output
    from rpg.pipeline import CompileOptions
    from rpg.store import Workspace

EXAMPLE = "rpg session examples/sessions.yaml --only progressive_tower"
File = Annotated[Path | None, typer.Argument(metavar="[FILE.yaml]", help="Sessions; without it, type them.")]
Only = Annotated[str | None, typer.Option("--only", metavar="NAME", help="Run this session of the file alone.")]
KeepGoing = Annotated[
    bool, typer.Option("--keep-going", "-k", help="Go on with the next edit where one is refused, instead of stopping.")
]
TaskName = Annotated[str | None, typer.Option("--task", metavar="TASK", help="Go on with this task when typing.")]


def run(
    file: File = None,
    only: Only = None,
    keep_going: KeepGoing = False,
    task: TaskName = None,
    tasks: Tasks = WORKSPACE,
    no_pictures: NoPictures = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Run the sessions of FILE: each has a name, a base instruction, and edits that are applied in turn. Without a
    file, type an instruction, then edits; `undo`, `log`, `show` and `quit` work as you would expect."""
    load_mujoco()
    from rpg.cli.output import Output
    from rpg.pipeline import CompileOptions

    out = Output(as_json, quiet)
    options = CompileOptions(pictures=not no_pictures)
    if file is not None:
        _scripted(out, file, only, keep_going, workspace(tasks), options)
        return
    from rpg.cli.prompt import converse

    out.finish(converse(out, workspace(tasks), task, options, sys.stdin.isatty()))


def _scripted(
    out: Output, file: Path, only: str | None, keep_going: bool, place: Workspace, options: CompileOptions
) -> None:
    from rpg.core.diagnostics import UsageError
    from rpg.sessions import read_sessions, run_session

    sessions = read_sessions(file)
    chosen = [session for session in sessions if only is None or session.name == only]
    if not chosen:
        names = ", ".join(str(session.name) for session in sessions)
        raise UsageError(f"{file} has no session called {only!r}; it has {names}")
    documents: list[dict[str, Any]] = []
    status = 0
    for session in chosen:
        _title(out, session.name or session.base)
        turns = []
        for turn in run_session(session, place, options, keep_going=keep_going):
            turns.append(turn.document())
            _print_turn(out, turn)
            status = max(status, turn.exit_status)
        documents.append({"name": session.name, "turns": turns})
    out.document({"sessions": documents})
    out.finish(status)


def _title(out: Output, name: str) -> None:
    if not out.as_json and not out.quiet:
        out.result.rule(name, align="left")


def _print_turn(out: Output, turn: Any) -> None:
    from rpg.cli.steered import print_steered
    from rpg.cli.summary import print_outcome

    if out.as_json:
        return
    if not out.quiet:
        out.result.print(f"» {turn.text}", markup=False)
    if turn.base is not None:
        print_outcome(out, turn.base, turn.place)
    else:
        print_steered(out, turn.steered)
