"""Where output goes: results to stdout, everything else to stderr, nothing that was not asked for."""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rich.console import Console


def as_text(data: Any, indent: int | None = None) -> str:
    """A JSON document as stdout can take it: characters that its encoding lacks are escaped."""
    text = json.dumps(data, ensure_ascii=False, indent=indent) + "\n"
    try:
        text.encode(sys.stdout.encoding or "utf-8")
    except UnicodeEncodeError:
        text = json.dumps(data, indent=indent) + "\n"
    return text


@dataclass(frozen=True)
class Output:
    """What a command writes to. With `as_json`, stdout gets one document and nothing else."""

    as_json: bool = False
    quiet: bool = False

    @cached_property
    def result(self) -> Console:
        """The console for what was asked for, as people read it; silent where JSON was asked for."""
        from rich.console import Console

        return Console(quiet=self.as_json, highlight=False, markup=False, emoji=False)

    @cached_property
    def asides(self) -> Console:
        """The console, on stderr, for what is worth knowing besides; `quiet` silences it."""
        from rich.console import Console

        return Console(stderr=True, quiet=self.quiet, highlight=False, markup=False, emoji=False)

    @cached_property
    def errors(self) -> Console:
        """The console, on stderr, for what stands in the way; never silent."""
        from rich.console import Console

        return Console(stderr=True, highlight=False, markup=False, emoji=False)

    def document(self, data: Any) -> None:
        """Write the JSON document, where JSON was asked for."""
        if self.as_json:
            sys.stdout.write(as_text(data, indent=2))

    def finish(self, status: int) -> None:
        """Leave with an exit status other than 0."""
        if status:
            sys.stdout.flush()
            raise SystemExit(status)
