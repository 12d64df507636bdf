"""Putting versions into a workspace: whole or not at all, by any number of processes at once.

A version is written into a hidden directory beside its destination, synced, and renamed. Numbers and names are given
out under one lock per workspace, which is held for renames only; the kernel drops it when its holder dies. A hidden
directory that nobody holds a lock on was left by a writer that was killed, and is removed by the next one.
"""

from __future__ import annotations

import fcntl
import os
import shutil
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

from rpg.core.diagnostics import UsageError
from rpg.core.digest import digest_of, sha256
from rpg.store.layout import HEAD, Family, Version, Workspace, version_name
from rpg.store.records import CODE, HASHED, PICTURES, SNAPSHOT, Snapshot, SteeringMeta, TaskSnapshot, seal

LOCK = ".lock"
ASIDE = ".new-"
Files = Mapping[str, bytes]


@dataclass(frozen=True)
class Content:
    """What a version is made of. `files` are the hashed ones, `pictures` the others; `steering` is None for a base."""

    files: Files
    description: str
    assets_used: tuple[str, ...]
    goal_summary: str
    pictures: Files
    steering: SteeringMeta | None = None
    backend: str = "lower"

    def sealed(self, number: int) -> Snapshot:
        """The snapshot of this content as version `number`."""
        missing = sorted(set(HASHED) - set(self.files))
        if missing:
            raise ValueError(f"a version needs {', '.join(missing)}")
        snapshot = TaskSnapshot(
            version_id=number,
            description=self.description,
            assets_used=self.assets_used,
            goal_summary=self.goal_summary,
            code_hash=sha256(self.files[CODE]),
        )
        digests = {name: sha256(data) for name, data in self.files.items()}
        return seal(snapshot, digests, self.steering, self.backend)


@dataclass(frozen=True)
class Written:
    """A version in the workspace; `existed` if the very same one was there before."""

    version: Version
    existed: bool


def write_base(workspace: Workspace, name: str, content: Content, *, explicit: bool = False) -> Written:
    """Write version 0 of a new family called `name`.

    The very same version under that name is found again rather than written. Another task under that name is an error
    if the user chose it (`explicit`); else the family is called `name-2`, `name-3`, ...
    """
    snapshot = content.sealed(0)
    _make_root(workspace)
    if _find_base(workspace, name, snapshot, explicit).directories():
        return _found_again(workspace, name, content, snapshot)
    with _aside(workspace.root, workspace) as draft:
        _fill(draft / version_name(0, snapshot.hash), content, snapshot)
        _write(draft / HEAD, (version_name(0, snapshot.hash) + "\n").encode())
        _sync(draft)
        with _locked(workspace):
            family = _find_base(workspace, name, snapshot, explicit)
            fresh = not family.directories()
            if fresh:
                draft.rename(family.directory)
                _sync(workspace.root)
    if not fresh:
        return _found_again(workspace, name, content, snapshot)
    return Written(_version(family, snapshot), existed=False)


def write_version(family: Family, content: Content) -> Written:
    """Write the next version of `family` and make it the current one.

    The very same snapshot is found again rather than written, and becomes the current one.
    """
    workspace = Workspace(family.directory.parent)
    with _aside(family.directory, workspace) as draft, _locked(workspace):
        versions = family.versions()
        number = max((version.number for version in versions), default=-1) + 1
        snapshot = content.sealed(number)
        twin = next((v for v in versions if snapshot.hash.startswith(v.short_hash) and v.hash == snapshot.hash), None)
        if twin is None:
            _fill(draft, content, snapshot)
            target = family.directory / version_name(number, snapshot.hash)
            draft.rename(target)
            _sync(family.directory)
            twin = _version(family, snapshot)
            existed = False
        else:
            existed = True
        _write_head(family, twin)
    return Written(twin, existed)


def set_head(version: Version) -> None:
    """Make `version` the current one of its family."""
    family = Family(version.directory.parent)
    with _locked(Workspace(family.directory.parent)):
        _write_head(family, version)


def write_rejected(workspace: Workspace, name: str, files: Files) -> Path:
    """Keep what did not pass, for looking into; returns its directory. The same content has the same directory."""
    _make_root(workspace)
    workspace.rejected.mkdir(exist_ok=True)
    digest = digest_of({file: sha256(data) for file, data in files.items()})
    target = workspace.rejected / f"{name}-{digest[:7]}"
    with _aside(workspace.rejected, workspace) as draft:
        for file, data in files.items():
            _write(draft / file, data)
        with _locked(workspace):
            if target.exists():
                shutil.rmtree(target)
            draft.rename(target)
    return target


def _make_root(workspace: Workspace) -> None:
    try:
        workspace.root.mkdir(parents=True, exist_ok=True)
        (workspace.root / LOCK).touch()
    except OSError as error:
        raise UsageError(f"cannot write to {workspace.root}: {error.strerror}; choose another --tasks DIR") from error


def _find_base(workspace: Workspace, name: str, snapshot: Snapshot, explicit: bool) -> Family:
    """The family that holds this very base already, or the first free one."""
    family = workspace.family(name)
    suffix = 2
    while _occupied(family):
        bases = [version for version in family.versions() if version.number == 0]
        if any(snapshot.hash.startswith(base.short_hash) and base.hash == snapshot.hash for base in bases):
            return family
        if explicit:
            raise UsageError(
                f"there is another task called {name!r} in {workspace.root}; choose another --name, or leave it out"
            )
        family = workspace.family(f"{name}-{suffix}")
        suffix += 1
    return family


def _occupied(family: Family) -> bool:
    """Whether there is anything at the family's place; an empty directory can be renamed over."""
    path = family.directory
    return path.exists() and not (path.is_dir() and next(path.iterdir(), None) is None)


def _found_again(workspace: Workspace, name: str, content: Content, snapshot: Snapshot) -> Written:
    """The version that is there already, with pictures added that it lacks."""
    with _locked(workspace):
        version = _version(_find_base(workspace, name, snapshot, False), snapshot)
        for file, data in content.pictures.items():
            if not (version.directory / file).exists():
                replace_file(version.directory / file, data)
    return Written(version, existed=True)


def _version(family: Family, snapshot: Snapshot) -> Version:
    number = snapshot.snapshot.version_id
    return Version(family.directory / version_name(number, snapshot.hash), family.name, number, snapshot.hash[:7])


def _fill(directory: Path, content: Content, snapshot: Snapshot) -> None:
    """Write every file of a version and sync it."""
    directory.mkdir(exist_ok=True)
    unknown = sorted(set(content.pictures) - set(PICTURES))
    if unknown:
        raise ValueError(f"not a picture of a version: {unknown[0]}")
    for name, data in {**content.files, **content.pictures, SNAPSHOT: snapshot.text().encode()}.items():
        _write(directory / name, data)
    _sync(directory)


def _write_head(family: Family, version: Version) -> None:
    replace_file(family.directory / HEAD, (version.directory.name + "\n").encode())


def replace_file(path: Path, data: bytes) -> None:
    """Put `data` at `path` in one step."""
    descriptor, name = tempfile.mkstemp(prefix=ASIDE, dir=path.parent)
    os.close(descriptor)
    draft = Path(name)
    try:
        draft.chmod(0o644)
        _write(draft, data)
        draft.replace(path)
    finally:
        draft.unlink(missing_ok=True)
    _sync(path.parent)


def _write(path: Path, data: bytes) -> None:
    with path.open("wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())


def _sync(directory: Path) -> None:
    """Make renames and new names in `directory` last."""
    descriptor = os.open(directory, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


@contextmanager
def _locked(workspace: Workspace) -> Iterator[None]:
    """Hold the workspace's lock."""
    with (workspace.root / LOCK).open("ab") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield


@contextmanager
def _aside(parent: Path, workspace: Workspace) -> Iterator[Path]:
    """A hidden directory to write in; its lock says that its writer lives. It is removed unless it was renamed."""
    with _locked(workspace):
        _sweep(parent)
        draft = Path(tempfile.mkdtemp(prefix=ASIDE, dir=parent))
        descriptor = os.open(draft, os.O_RDONLY)
        fcntl.flock(descriptor, fcntl.LOCK_EX)
    try:
        draft.chmod(0o755)
        yield draft
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
