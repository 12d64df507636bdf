"""Diagnostics: what is wrong, where in the user's words, and what would work, as data.

The terminal, JSON output, repair agents, batch statistics and tests all read the same object.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Literal

from pydantic import BaseModel, ConfigDict

Severity = Literal["error", "warning", "note"]
Span = tuple[int, int]
"""Half-open range of characters in the instruction."""


class Label(BaseModel):
    """A further place in the instruction that a diagnostic speaks of."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    span: Span
    text: str = ""


class Diagnostic(BaseModel):
    """One finding.

    `code` is listed in `rpg.core.codes`; `span` is the place in the instruction; `labels` are further places (the
    other half of a contradiction); `hint` says what would work; `facts` are measured values with their units in the
    key (`gap_m`, `tilt_deg`); `origin` names the pass, gate or agent that reports.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    code: str
    severity: Severity = "error"
    message: str
    span: Span | None = None
    labels: tuple[Label, ...] = ()
    hint: str | None = None
    facts: dict[str, Any] = {}
    origin: str = ""


class Refusal(Exception):
    """A user's request that cannot be carried out; carries the diagnostics that say why. Exit code 3."""

    def __init__(self, diagnostics: Iterable[Diagnostic]) -> None:
        self.diagnostics = tuple(diagnostics)
        super().__init__("; ".join(d.message for d in self.diagnostics))


class UsageError(Exception):
    """Bad usage or unreadable input: exit code 2. The message is for people and says what would work."""


class Unavailable(Exception):
    """Something the command needs is missing on this machine: exit code 4. The message names what to install."""
