"""The `rpg` command line: one thin file per command, each imported only when it is used."""

from __future__ import annotations

import gc
import sys

SELDOM = 200_000
"""The garbage collector looks for what can be let go after as many new objects. What is made at a start is kept, and
to look through it after every few hundred would take a tenth of the time of a short command."""


def start() -> None:
    """The program `rpg`. An interrupt ends it quietly from its first moment on."""
    gc.set_threshold(SELDOM)
    try:
        from rpg.cli.main import main
    except KeyboardInterrupt:
        sys.exit(130)
    main()
