"""What a user is told when a command cannot do what was asked, and the exit status that says so to scripts."""

from __future__ import annotations

import sys
from typing import Any, Protocol, runtime_checkable

from rpg.cli import exits
from rpg.cli.output import as_text
from rpg.core.diagnostics import Refusal, Unavailable, UsageError


def report(error: Exception, *, as_json: bool) -> int | None:
    """Tell the user about `error`; the exit status, or None for what is no user's mistake but a bug."""
    status = _status(error)
    if status is None:
        return None
    message = _message(error)
    if as_json:
        data: dict[str, Any] = {"status": "refused" if status == exits.REFUSED else "error", "message": message}
        if isinstance(error, Refusal):
            data |= {"diagnostics": [d.model_dump(mode="json") for d in error.diagnostics]}
        sys.stdout.write(as_text(data))
    if isinstance(error, _Misused):
        error.show()
        return status
    for line in message.splitlines() or [""]:
        sys.stderr.write(f"rpg: {line}\n")
    return status


@runtime_checkable
class _Misused(Protocol):
    """What the parser of the command line raises; which library it comes with depends on the version of Typer."""

    exit_code: int

    def format_message(self) -> str: ...

    def show(self) -> None: ...


def _status(error: Exception) -> int | None:
    if isinstance(error, _Misused):
        return exits.USAGE
    if isinstance(error, UsageError | OSError):
        return exits.USAGE
    if isinstance(error, Refusal):
        return exits.REFUSED
    if isinstance(error, Unavailable):
        return exits.UNAVAILABLE
    return None


def _message(error: Exception) -> str:
    if isinstance(error, _Misused):
        return error.format_message()
    if isinstance(error, OSError) and error.filename:
        return f"{error.filename}: {error.strerror}"
    if isinstance(error, OSError) and error.strerror:
        return error.strerror
    return str(error)
