"""Passes and their manager: one direction, one bookkeeping.

A pass is a frozen dataclass whose fields are its options. The manager checks what crosses each boundary, times and
records every pass and stops at the first one that yields nothing. Loops are controllers, not passes.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

from rpg.core.diagnostics import Diagnostic

Listener = Callable[[str, str], None]
"""Hears (pass or gate, what it is about to do or has done) while a compile runs."""


def silent(_stage: str, _text: str) -> None:
    """A listener that does nothing."""


@dataclass(frozen=True)
class Context:
    """What passes share besides the item: who listens to progress."""

    listen: Listener = silent


@dataclass(frozen=True)
class Report:
    """What a pass found: diagnostics, and figures worth keeping."""

    diagnostics: tuple[Diagnostic, ...] = ()
    figures: dict[str, Any] = field(default_factory=dict)


class Pass(Protocol):
    """One step of the compiler, text -> schema -> program -> validated program."""

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
class Manager:
    """Runs passes in order. `verify` raises on an item that must not cross a boundary."""

    passes: Sequence[Pass]
    verify: Callable[[str, Any], None] | None = None

    def run(self, item: Any, context: Context | None = None) -> tuple[Any | None, tuple[Record, ...]]:
        """Send `item` through the passes; the last item (None where a pass stopped) and what each pass reported."""
        context = context or Context()
        records: list[Record] = []
        for step in self.passes:
            context.listen(step.name, "start")
            begun = time.perf_counter()
            item, report = step.run(item, context)
            records.append(Record(step.name, report, time.perf_counter() - begun))
            if item is None:
                break
            if self.verify:
                self.verify(step.name, item)
        return item, tuple(records)
