"""What a compile is doing, shown while it does it, on a terminal."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rpg.cli.output import Output
    from rpg.core.passes import Listener

WORDS = {
    "schema": "reading the instruction",
    "feasibility": "checking that it can be done",
    "arrange": "looking for a goal state",
    "codegen": "writing code",
    "pictures": "drawing",
}
"""What each pass does, in words."""


@contextmanager
def progress(out: Output) -> Iterator[Listener]:
    """A listener that keeps one line on the terminal up to date, and takes it away at the end."""
    console = out.asides
    if console.quiet or not console.is_terminal:
        yield lambda stage, text: None
        return
    with console.status("starting") as status:
        yield lambda stage, text: status.update(WORDS.get(stage, f"{stage}: {text}"))
