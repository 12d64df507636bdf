"""Passes and their manager: one direction, one bookkeeping.

A pass is a frozen dataclass whose fields are its options. The manager checks what crosses each boundary, times and
records every pass and stops at the first one that yields nothing. Loops are controllers, not passes.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from rpg.core.diagnostics import Diagnostic, Refusal

Listener = Callable[[str, str], None]
"""Hears (pass or gate, what it is about to do or has done) while a compile runs."""


def silent(_stage: str, _text: str) -> None:
    """A listener that does nothing."""


@dataclass(frozen=True)
class Context:
    """What passes share besides the item: who listens to progress, and how thoroughly to measure."""

    listen: Listener = silent
    options: Any = None


@dataclass(frozen=True)
class Report:
    """What a pass found: diagnostics, and whatever else it has to tell."""

    diagnostics: tuple[Diagnostic, ...] = ()
    found: Any = None


class Pass(Protocol):
    """One step of the compiler. Its options are its fields."""

    @property
    def name(self) -> str:
        """A short name, unique among the passes of a pipeline."""

    def run(self, item: Any, context: Context) -> tuple[Any | None, Report]:
        """The item for the next pass (None: it stops here) and the report."""


@dataclass(frozen=True)
class Record:
    """One pass as it ran. `seconds` is for people and benchmarks, never written to an artifact."""

    name: str
    report: Report
    seconds: float


@dataclass(frozen=True)
class Run:
    """What came out of a pipeline: the last item (None where a pass stopped), and each pass as it ran."""

    item: Any | None
    records: tuple[Record, ...]

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """Everything that was found, in the order of the passes."""
        return tuple(diagnostic for record in self.records for diagnostic in record.report.diagnostics)


@dataclass(frozen=True)
class Manager:
    """Runs passes in order. A Refusal raised inside a pass stops it with its diagnostics.

    `verify` raises where an item must not cross a boundary: that is a bug of the pass before it. It is not asked again
    about what a pass hands on as it came.
    """

    passes: Sequence[Pass]
    verify: Callable[[str, Any], None] | None = None

    def run(self, item: Any, context: Context | None = None) -> Run:
        """Send `item` through the passes."""
        context = context or Context()
        records: list[Record] = []
        for step in self.passes:
            context.listen(step.name, "start")
            begun, before = time.perf_counter(), item
            try:
                item, report = step.run(item, context)
            except Refusal as refusal:
                item, report = None, Report(refusal.diagnostics)
            records.append(Record(step.name, report, time.perf_counter() - begun))
            if item is None:
                break
            if self.verify and item is not before:
                self.verify(step.name, item)
        return Run(item, tuple(records))
