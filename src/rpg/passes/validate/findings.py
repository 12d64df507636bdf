"""Failures as diagnostics: what failed, of which class, with the state and the words of the instruction."""

from __future__ import annotations

import traceback
from collections.abc import Iterable
from types import TracebackType
from typing import Any

from rpg.blocks.state import BlockState
from rpg.core.diagnostics import Diagnostic, Span
from rpg.ir.artifact import FailureClass

FILES = ("code.py", "goal_state_code.py")


def failure(
    gate: str,
    code: str,
    kind: FailureClass,
    message: str,
    *,
    span: Span | None = None,
    hint: str | None = None,
    **facts: Any,
) -> Diagnostic:
    """An error found by `gate`. `facts` go along; `kind` is what the repair agents are chosen by."""
    shown = {name: value for name, value in facts.items() if value is not None}
    return Diagnostic(code=code, message=message, span=span, hint=hint, facts={"class": kind, **shown}, origin=gate)


def refused(gate: str, diagnostic: Diagnostic, kind: FailureClass = "runtime") -> Diagnostic:
    """The diagnostic of a refusal that came up while `gate` ran the task."""
    return diagnostic.model_copy(update={"facts": {"class": kind, **diagnostic.facts}, "origin": gate})


def note(gate: str, code: str, message: str, span: Span | None = None, **facts: Any) -> Diagnostic:
    """Something worth knowing that fails nothing."""
    return Diagnostic(code=code, severity="note", message=message, span=span, facts=facts, origin=gate)


def poses(state: BlockState) -> dict[str, list[float]]:
    """Centres in metres, to a tenth of a millimetre."""
    return {name: [round(value, 4) for value in xyz] for name, xyz in state.position.items()}


def span_of(spans: Iterable[Span | None]) -> Span | None:
    """The first place in the instruction among `spans` that is known."""
    return next((span for span in spans if span), None)


def told(error: BaseException, sources: dict[str, str]) -> str:
    """The traceback of `error` through the generated files alone, with their lines."""
    lines = [
        f"{frame.f_code.co_filename}, line {number}: {_line(sources[frame.f_code.co_filename], number)}"
        for frame, number in traceback.walk_tb(_traceback(error))
        if frame.f_code.co_filename in sources
    ]
    return "\n".join([*lines, f"{type(error).__name__}: {error}"])


def place_of(error: BaseException, sources: dict[str, str]) -> tuple[str, int] | None:
    """The innermost generated file and line that `error` passed through."""
    found = None
    for frame, number in traceback.walk_tb(_traceback(error)):
        if frame.f_code.co_filename in sources:
            found = (frame.f_code.co_filename, number)
    return found


def _traceback(error: BaseException) -> TracebackType | None:
    return error.__traceback__


def _line(source: str, number: int) -> str:
    lines = source.splitlines()
    return lines[number - 1].strip() if 0 < number <= len(lines) else ""
