"""The entry point: which commands there are, and what becomes of errors.

Nothing heavy is imported here. A command's module is imported when the command is used, and imports what it needs
inside its function.
"""

from __future__ import annotations

import os
import signal
import sys
from importlib import import_module
from io import TextIOWrapper
from pathlib import Path
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from rpg.cli import exits

COMMANDS = {
    "compile": "Compile an instruction into a verified task.",
    "batch": "Compile lists of instructions and sessions, and keep them up to date.",
    "steer": "Change a task by a sentence, into a new version with its proof.",
    "session": "Run a scripted session, or one that you type.",
    "bench": "Measure the compiler on its benchmark, beside published figures.",
    "show": "Explain a task: its assets, start, goal and checks.",
    "check": "Judge given states by a task's goal.",
    "validate": "Run a task's gates again.",
    "verify": "Check hashes, lineage, and that code still follows from task.yaml.",
    "log": "Show how a family's versions came about.",
    "diff": "Show what differs between two versions.",
    "checkout": "Make another version of a family the current one.",
    "render": "Draw a task's start and goal.",
    "gallery": "Write one HTML page of all tasks.",
    "view": "Open a task in MuJoCo's interactive viewer.",
    "export": "Write a task's scene for any MuJoCo user.",
    "doctor": "Say what works on this machine and what to install for the rest.",
}
"""Every command with its summary; the module of the same name has a function `run` and an `EXAMPLE`."""

CONTEXT = {"help_option_names": ["-h", "--help"]}


class Commands(TyperGroup):
    """A group that imports a command when it is asked for."""

    def list_commands(self, ctx: Any) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: Any, cmd_name: str) -> Any:
        if cmd_name not in COMMANDS:
            return None
        module = import_module(f"rpg.cli.{cmd_name}")
        command = typer.Typer(add_completion=False, rich_markup_mode=None, context_settings=CONTEXT)
        settings = CONTEXT | getattr(module, "SETTINGS", {})
        example = f"Example: {module.EXAMPLE}"
        registered = command.command(cmd_name, context_settings=settings, short_help=COMMANDS[cmd_name], epilog=example)
        registered(module.run)
        return typer.main.get_command(command)

    def format_commands(self, ctx: Any, formatter: Any) -> None:
        """The list of commands, without importing one of them."""
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))


app = typer.Typer(
    cls=Commands,
    help="Compile sentences into verified MuJoCo manipulation tasks.",
    epilog='Example: rpg compile "Stack the red block on the blue block"',
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    context_settings=CONTEXT,
)


def _version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import version

        sys.stdout.write(f"rpg {version('roboplayground')}\n")
        raise typer.Exit


@app.callback()
def _group(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Show the version and exit.")
    ] = False,
) -> None:
    """Compile sentences into verified MuJoCo manipulation tasks."""


def main() -> None:
    """Run the command line and leave the process with its exit status."""
    interrupts: list[int] = []

    def interrupt(number: int, _: object) -> None:
        interrupts.append(number)
        raise KeyboardInterrupt

    signal.signal(signal.SIGINT, interrupt)
    for name in ("stdout", "stderr"):
        if getattr(sys, name) is None:  # whoever started this process closed it
            setattr(sys, name, Path(os.devnull).open("w"))  # noqa: SIM115
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):  # a terminal or file of another encoding gets what it can show
            stream.reconfigure(errors="surrogateescape" if stream.encoding.lower() == "utf-8" else "replace")
    try:
        status = run(sys.argv[1:])
    except Exception:
        if not interrupts:  # an import that is interrupted may fail in a way of its own
            raise
        status = exits.INTERRUPTED
    sys.exit(status)


def run(arguments: list[str]) -> int:
    """Run one command; its exit status. A reader that closes the pipe early is no news: nothing is said about it."""
    try:
        status = _run(arguments)
        sys.stdout.flush()
        return status
    except BrokenPipeError:
        _leave_stdout()
        return exits.NO
    except OSError as error:
        _leave_stdout()
        sys.stderr.write(f"rpg: cannot write the output: {error.strerror}\n")
        return exits.USAGE


def _leave_stdout() -> None:
    """Write what is left for stdout nowhere: it takes nothing more."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _run(arguments: list[str]) -> int:
    try:
        status = app(args=_command_first(arguments), prog_name="rpg", standalone_mode=False)
        return status if isinstance(status, int) else 0
    except SystemExit as done:
        return done.code if isinstance(done.code, int) else int(done.code is not None)
    except KeyboardInterrupt:
        return exits.INTERRUPTED
    except BrokenPipeError:
        raise
    except Exception as error:
        from rpg.cli.errors import report

        known = report(error, as_json="--json" in arguments)
        if known is None:
            raise
        return known


def _command_first(arguments: list[str]) -> list[str]:
    """The arguments with options that every command has moved behind the command, where they may be written too."""
    leading: list[str] = []
    rest = list(arguments)
    while (rest and rest[0] in ("--json", "-q", "--quiet", "--tasks")) or (rest and rest[0].startswith("--tasks=")):
        leading.append(rest.pop(0))
        if leading[-1] == "--tasks" and rest:
            leading.append(rest.pop(0))
    return [rest[0], *leading, *rest[1:]] if rest else leading
