"""What a batch reports: a line for every entry."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from rpg.batch.entries import Entry


@dataclass(frozen=True)
class Line:
    """One entry in the report.

    `outcome`: "current" (nothing to do), "built", "same" (rebuilt aside to the same bytes), "differs", "refused",
    "failed". `detail`: what differs, or why not.
    """

    entry: Entry
    outcome: str
    family: str = ""
    detail: str = ""
    diagnostics: tuple[dict[str, Any], ...] = ()

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


def reason(diagnostics: tuple[dict[str, Any], ...]) -> str:
    """The first error's message."""
    errors = [d for d in diagnostics if d.get("severity") == "error"]
    return str((errors or [{}])[0].get("message", ""))
