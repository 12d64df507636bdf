"""From what a user types for a task to a version: a directory, `family`, `family@2`, or the start of a hash."""

from __future__ import annotations

import difflib
import re
from pathlib import Path

from rpg.core.diagnostics import UsageError
from rpg.store.layout import Family, Version, Workspace, version_at

MIN_PREFIX = 4
_HASH = re.compile(rf"[0-9a-f]{{{MIN_PREFIX},64}}")


def resolve(workspace: Workspace, text: str) -> Version:
    """The version that `text` names; a UsageError with the nearest names where there is none, or several."""
    if "/" not in text:
        name, at, wanted = text.partition("@")
        family = workspace.family(name)
        if name and not name.startswith(".") and family.directories():
            return _version_of(family, wanted) if at else family.head()
        if _HASH.fullmatch(text):
            found = _by_hash(workspace, text)
            if found:
                return found
    path = Path(text)
    if text and path.is_dir():
        return _in_directory(path)
    raise UsageError(_unknown(workspace, text))


def resolve_family(workspace: Workspace, text: str) -> Family:
    """The family of the task that `text` names, found even where its HEAD is broken."""
    family = workspace.family(text.partition("@")[0]) if "/" not in text else Family(Path(text).resolve())
    if family.name and not family.name.startswith(".") and family.directories():
        return family
    return Family(resolve(workspace, text).directory.parent)


def _in_directory(path: Path) -> Version:
    directory = path.resolve()
    version = version_at(directory)
    if version:
        return version
    family = Family(directory)
    if family.versions():
        return family.head()
    if (directory / "task.yaml").is_file():
        raise UsageError(
            f"{path} holds a task.yaml but no finished version; build one: rpg compile --from {path}/task.yaml"
        )
    if Workspace(directory).families():
        raise UsageError(f"{path} is a workspace, not a task; name one of its tasks, or pass --tasks {path}")
    raise UsageError(f"{path} holds no task")


def _version_of(family: Family, wanted: str) -> Version:
    versions = family.versions()
    if wanted.lower() == "head":
        return family.head()
    if wanted.removeprefix("v").isdecimal():
        found = [version for version in versions if version.number == int(wanted.removeprefix("v"))]
    elif _HASH.fullmatch(wanted):
        found = [version for version in versions if _matches(version, wanted)]
    else:
        raise UsageError(
            f"{family.name}@{wanted}: after the @ stands a version's number or hash, as in {family.name}@0"
        )
    if len(found) > 1:
        raise UsageError(f"{family.name}@{wanted} could be {', '.join(v.directory.name for v in found)}")
    if not found:
        known = ", ".join(str(version.number) for version in versions)
        raise UsageError(f"{family.name} has no version {wanted}; it has {known}")
    return found[0]


def _by_hash(workspace: Workspace, prefix: str) -> Version | None:
    found = [v for family in workspace.families() for v in family.versions() if _matches(v, prefix)]
    if len({version.hash for version in found}) > 1:
        raise UsageError(f"{prefix} could be {', '.join(map(str, found[:5]))}; type more of the hash")
    return found[0] if found else None


def _matches(version: Version, prefix: str) -> bool:
    if len(prefix) <= len(version.short_hash):
        return version.short_hash.startswith(prefix)
    return prefix.startswith(version.short_hash) and version.hash.startswith(prefix)


def _unknown(workspace: Workspace, text: str) -> str:
    """What to say when nothing is called `text`."""
    names = [family.name for family in workspace.families()]
    if not workspace.root.is_dir():
        return f"no task {text!r}: there is no workspace at {workspace.root} yet; rpg compile makes one"
    if not names:
        return f"no task {text!r}: the workspace {workspace.root} is empty"
    near = difflib.get_close_matches(text.partition("@")[0], names, n=3)
    if near:
        return f"no task {text!r} in {workspace.root}; did you mean {' or '.join(near)}?"
    shown = ", ".join(names[:8]) + (f" and {len(names) - 8} more" if len(names) > 8 else "")
    return f"no task {text!r} in {workspace.root}; there are {shown}"
