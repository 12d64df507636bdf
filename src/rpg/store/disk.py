"""Writing so that a file or a directory is there whole or not at all, and lasts.

A draft is written in a hidden directory beside its destination, synced, and renamed. Renames happen under one lock per
workspace; the kernel drops it when its holder dies. A hidden directory that nobody holds a lock on was left by a
writer that was killed, and is removed by the next one.
"""

from __future__ import annotations

import fcntl
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from rpg.store.layout import Workspace

LOCK = ".lock"
ASIDE = ".new-"


def replace_file(path: Path, data: bytes) -> None:
    """Put `data` at `path` in one step."""
    descriptor, name = tempfile.mkstemp(prefix=ASIDE, dir=path.parent)
    os.close(descriptor)
    draft = Path(name)
    try:
        draft.chmod(0o644)
        write_file(draft, data)
        draft.replace(path)
    finally:
        draft.unlink(missing_ok=True)
    sync(path.parent)


def write_file(path: Path, data: bytes) -> None:
    with path.open("wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())


def sync(directory: Path) -> None:
    """Make renames and new names in `directory` last."""
    descriptor = os.open(directory, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


@contextmanager
def locked(workspace: Workspace) -> Iterator[None]:
    """Hold the workspace's lock."""
    with (workspace.root / LOCK).open("ab") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


@contextmanager
def aside(parent: Path, workspace: Workspace) -> Iterator[Path]:
    """A hidden directory to write in; its lock says that its writer lives. It is removed unless it was renamed."""
    with locked(workspace):
        _sweep(parent)
        draft = Path(tempfile.mkdtemp(prefix=ASIDE, dir=parent))
        descriptor = os.open(draft, os.O_RDONLY)
        fcntl.flock(descriptor, fcntl.LOCK_EX)
    try:
        draft.chmod(0o755)
        yield draft
    except OSError as error:
        # A write that finds no room does not say where it was.
        error.filename = error.filename or str(workspace.root)
        raise
    finally:
        os.close(descriptor)
        shutil.rmtree(draft, ignore_errors=True)


def _sweep(parent: Path) -> None:
    """Remove what killed writers left in `parent`. The workspace's lock must be held."""
    for path in parent.glob(ASIDE + "*"):
        with suppress(OSError):
            descriptor = os.open(path, os.O_RDONLY)
            try:
                fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
                shutil.rmtree(path) if path.is_dir() else path.unlink()
            finally:
                os.close(descriptor)
