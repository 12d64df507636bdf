"""The `rpg` command line: one thin file per command, each imported only when it is used."""

from __future__ import annotations

import sys


def start() -> None:
    """The program `rpg`. An interrupt ends it quietly from its first moment on."""
    try:
        from rpg.cli.main import main
    except KeyboardInterrupt:
        sys.exit(130)
    main()
