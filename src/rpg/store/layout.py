"""Where things are in a workspace: families, their versions, HEAD. Reading only."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

from pydantic import ValidationError

from rpg.core.diagnostics import UsageError
from rpg.store.records import CODE, GOAL_CODE, LOG, SNAPSHOT, SOURCE, Snapshot

if TYPE_CHECKING:
    from rpg.ir.schema import TaskSchema

HEAD = "HEAD"
REJECTED = ".rejected"
DEFAULT_WORKSPACE = "tasks"
VERSION_NAME = re.compile(r"v(\d+)-([0-9a-f]{7})")


def version_name(number: int, digest: str) -> str:
    """Directory name of a version from its number and its snapshot hash."""
    return f"v{number}-{digest[:7]}"


@dataclass(frozen=True)
class Version:
    """One version of a family, by its directory. Its files are read when asked for, once."""

    directory: Path
    family: str
    number: int
    short_hash: str

    @cached_property
    def snapshot(self) -> Snapshot:
        """The contents of snapshot.json; a UsageError where it cannot be read."""
        path = self.directory / SNAPSHOT
        try:
            return Snapshot.model_validate_json(path.read_bytes())
        except OSError as error:
            raise UsageError(f"cannot read {path}: {error.strerror}") from error
        except ValidationError as error:
            problem = error.errors()[0]
            place = ".".join(str(part) for part in problem["loc"])
            raise UsageError(f"{path} is damaged: {place + ': ' if place else ''}{problem['msg']}") from error

    @property
    def hash(self) -> str:
        """Full hex digest of the snapshot."""
        return self.snapshot.hash

    @cached_property
    def schema(self) -> TaskSchema:
        """The task that task.yaml describes."""
        from rpg.store.taskfile import read_schema

        return read_schema(self.directory / SOURCE)

    @property
    def code(self) -> str:
        return self._text(CODE)

    @property
    def goal_code(self) -> str:
        return self._text(GOAL_CODE)

    @property
    def log(self) -> str:
        return self._text(LOG)

    def _text(self, name: str) -> str:
        path = self.directory / name
        try:
            return path.read_bytes().decode()
        except OSError as error:
            raise UsageError(f"cannot read {path}: {error.strerror}") from error
        except UnicodeDecodeError as error:
            raise UsageError(f"{path} is damaged: it is not UTF-8 text") from error

    def __str__(self) -> str:
        return f"{self.family}@{self.number}"


def version_at(directory: Path) -> Version | None:
    """The version that `directory` holds, judged by its name and its snapshot.json."""
    match = VERSION_NAME.fullmatch(directory.name)
    if match is None or not (directory / SNAPSHOT).is_file():
        return None
    return Version(directory, directory.parent.name, int(match[1]), match[2])


@dataclass(frozen=True)
class Family:
    """One base instruction and every version steered from it."""

    directory: Path

    @property
    def name(self) -> str:
        return self.directory.name

    def directories(self) -> tuple[Path, ...]:
        """Every directory named like a version, whole or not, by number."""
        if not self.directory.is_dir():
            return ()
        found = [(VERSION_NAME.fullmatch(path.name), path) for path in self.directory.iterdir()]
        named = [(int(match[1]), path.name, path) for match, path in found if match]
        return tuple(path for _, _, path in sorted(named))

    def versions(self) -> tuple[Version, ...]:
        """Every version, by number."""
        found = (version_at(path) for path in self.directories())
        return tuple(version for version in found if version)

    def head(self) -> Version:
        """The current version."""
        versions = {version.directory.name: version for version in self.versions()}
        if not versions:
            raise UsageError(f"{self.directory} holds no version of a task")
        named = self.head_name()
        if named not in versions:
            known = ", ".join(versions)
            hint = f"rpg checkout {self.directory} {max(version.number for version in versions.values())} sets it"
            raise UsageError(f"{self.directory / HEAD} names no version of {self.name} (there are {known}); {hint}")
        return versions[named]

    def head_name(self) -> str:
        """What HEAD says; empty where there is none."""
        try:
            return (self.directory / HEAD).read_text(encoding="utf-8", errors="replace").strip()
        except OSError:
            return ""


@dataclass(frozen=True)
class Workspace:
    """A directory of families. Names that begin with a dot are not families."""

    root: Path

    @property
    def rejected(self) -> Path:
        """Where tasks that did not pass are kept for looking into."""
        return self.root / REJECTED

    def family(self, name: str) -> Family:
        return Family(self.root / name)

    def families(self) -> tuple[Family, ...]:
        """Every family that has a version, by name."""
        if not self.root.is_dir():
            return ()
        paths = sorted(path for path in self.root.iterdir() if path.is_dir() and not path.name.startswith("."))
        return tuple(family for family in map(Family, paths) if family.directories())
