"""Putting versions into a workspace: whole or not at all, by any number of processes at once.

Numbers and names are given out under one lock per workspace, which is held for renames only.
"""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from rpg.core.diagnostics import UsageError
from rpg.core.digest import digest_of, sha256
from rpg.store.disk import LOCK, aside, locked, replace_file, sync, write_file
from rpg.store.layout import HEAD, Family, Version, Workspace, version_name
from rpg.store.records import CODE, HASHED, PICTURES, SNAPSHOT, Snapshot, SteeringMeta, TaskSnapshot, seal

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
    make_root(workspace)
    if _find_base(workspace, name, snapshot, explicit).directories():
        return _found_again(workspace, name, content, snapshot)
    with aside(workspace.root, workspace) as draft:
        _fill(draft / version_name(0, snapshot.hash), content, snapshot)
        write_file(draft / HEAD, (version_name(0, snapshot.hash) + "\n").encode())
        sync(draft)
        with locked(workspace):
            family = _find_base(workspace, name, snapshot, explicit)
            fresh = not family.directories()
            if fresh:
                draft.rename(family.directory)
                sync(workspace.root)
    if not fresh:
        return _found_again(workspace, name, content, snapshot)
    return Written(_version(family, snapshot), existed=False)


def write_version(family: Family, content: Content) -> Written:
    """Write the next version of `family` and make it the current one.

    The very same snapshot is found again rather than written, and becomes the current one.
    """
    workspace = Workspace(family.directory.parent)
    with aside(family.directory, workspace) as draft, locked(workspace):
        versions = family.versions()
        number = max((version.number for version in versions), default=-1) + 1
        snapshot = content.sealed(number)
        twin = next((v for v in versions if snapshot.hash.startswith(v.short_hash) and v.hash == snapshot.hash), None)
        if twin is None:
            _fill(draft, content, snapshot)
            target = family.directory / version_name(number, snapshot.hash)
            draft.rename(target)
            sync(family.directory)
            twin = _version(family, snapshot)
            existed = False
        else:
            existed = True
        _write_head(family, twin)
    return Written(twin, existed)


def set_head(version: Version) -> None:
    """Make `version` the current one of its family."""
    family = Family(version.directory.parent)
    with locked(Workspace(family.directory.parent)):
        _write_head(family, version)


def write_rejected(workspace: Workspace, name: str, files: Files) -> Path:
    """Keep what did not pass, for looking into; returns its directory. The same content has the same directory."""
    make_root(workspace)
    workspace.rejected.mkdir(exist_ok=True)
    digest = digest_of({file: sha256(data) for file, data in files.items()})
    target = workspace.rejected / f"{name}-{digest[:7]}"
    with aside(workspace.rejected, workspace) as draft:
        for file, data in files.items():
            write_file(draft / file, data)
        with locked(workspace):
            if target.exists():
                shutil.rmtree(target)
            draft.rename(target)
    return target


def make_root(workspace: Workspace) -> None:
    """Create the workspace if it is not there; UsageError where it cannot be written to."""
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
    with locked(workspace):
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
        write_file(directory / name, data)
    sync(directory)


def _write_head(family: Family, version: Version) -> None:
    replace_file(family.directory / HEAD, (version.directory.name + "\n").encode())
