"""A process that writes versions as fast as it can: `python -m tests.store.writer ROOT NAME COUNT`."""

from __future__ import annotations

import sys
from pathlib import Path

from rpg.store import SteeringMeta, Workspace, write_base, write_version
from tests.store.conftest import make_content


def main(root: str, name: str, count: int) -> None:
    """Write a base and `count` versions; every directory is printed once it is there."""
    workspace = Workspace(Path(root))
    base = write_base(workspace, "shared", make_content()).version
    print(base.directory.name, flush=True)
    for number in range(count):
        meta = SteeringMeta(request=f"{name} {number}", intent="TWEAK", reference=0, parent=base.hash)
        print(write_version(workspace.family("shared"), make_content(steering=meta)).version.directory.name, flush=True)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], int(sys.argv[3]))
