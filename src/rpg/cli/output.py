"""Where output goes: results to stdout, everything else to stderr, nothing that was not asked for."""

from __future__ import annotations

import json
import sys
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rich.console import Console


@dataclass(frozen=True)
class Output:
    """What a command writes to. With `as_json`, stdout gets one document and nothing else; `quiet` drops what is
    said to people beyond errors."""

    as_json: bool = False
    quiet: bool = False

    @cached_property
    def people(self) -> Console:
        """The console for results as people read them; stderr where stdout is for JSON."""
        from rich.console import Console

        return Console(stderr=self.as_json, quiet=self.quiet, highlight=False, soft_wrap=False)

    @cached_property
    def errors(self) -> Console:
        """The console for what went wrong."""
        from rich.console import Console

        return Console(stderr=True, highlight=False)

    def document(self, data: Any) -> None:
        """Write the JSON document, if that is what was asked for."""
        if self.as_json:
            sys.stdout.write(json.dumps(data, ensure_ascii=False, indent=2) + "\n")

    def finish(self, status: int) -> None:
        """Leave with an exit status other than 0."""
        if status:
            sys.stdout.flush()
            raise SystemExit(status)
