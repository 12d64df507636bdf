"""What a batch reports: a line for every entry."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

from rpg.batch.entries import Entry

MOST_REASONS = 3
"""Errors of one entry that are shown."""


@dataclass(frozen=True)
class Line:
    """One entry in the report.

    `outcome`: "current" (nothing to do), "built", "same" (rebuilt aside to the same bytes), "differs", "refused",
    "failed". `detail`: what differs, or why not. `rejected`: the directory of what failed, within the workspace.
    """

    entry: Entry
    outcome: str
    family: str = ""
    detail: str = ""
    diagnostics: tuple[dict[str, Any], ...] = ()
    rejected: str = ""

    @property
    def good(self) -> bool:
        return self.outcome in ("current", "built", "same")


@dataclass
class Report:
    """Every entry's line, in the order of the lists. `upgraded`: the versions that changed since the last batch."""

    lines: list[Line] = field(default_factory=list)
    upgraded: str = ""

    def count(self, outcome: str) -> int:
        return sum(line.outcome == outcome for line in self.lines)

    @property
    def good(self) -> bool:
        return all(line.good for line in self.lines)


def ended(
    entry: Entry, outcome: str, diagnostics: tuple[dict[str, Any], ...], turn: int = 0, rejected: str = ""
) -> Line:
    """The line of an entry that was refused or failed at its `turn`-th edit (0: at its instruction)."""
    detail = "\n".join(_reasons(diagnostics))
    if turn:
        detail = f"edit {turn}, {entry.edits[turn - 1]!r}: {detail}"
    if rejected:
        detail += f"\nkept for looking into: {rejected}"
    return Line(entry, outcome, detail=detail, diagnostics=diagnostics, rejected=rejected)


def _reasons(diagnostics: tuple[dict[str, Any], ...]) -> Iterator[str]:
    """The first errors, each with its hint."""
    errors = [d for d in diagnostics if d.get("severity") == "error"]
    for error in errors[:MOST_REASONS]:
        yield str(error.get("message", ""))
        if error.get("hint"):
            yield f"  hint: {error['hint']}"
    if len(errors) > MOST_REASONS:
        yield f"and {len(errors) - MOST_REASONS} more"
