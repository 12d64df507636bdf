"""Taking a finished family, made elsewhere, into a workspace: the versions that differ are replaced, nothing else."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from pathlib import Path

from rpg.core.diagnostics import UsageError
from rpg.store.disk import aside, locked, sync, write_file
from rpg.store.layout import HEAD, Family, Workspace
from rpg.store.records import PICTURES

Tree = Mapping[str, bytes]
"""The files of a family by their path inside it: `HEAD`, `v0-3f9a1c2/task.yaml`, ..."""


@dataclass(frozen=True)
class Adopted:
    """Where a family went, and whether anything in the workspace changed."""

    family: Family
    changed: bool


def adopt(
    workspace: Workspace, name: str, tree: Tree, *, explicit: bool = False, replaceable: Collection[str] = ()
) -> Adopted:
    """Put the family `tree` into the workspace as `name` (`name-2`, ... where another task has that name).

    `replaceable` are directory names of versions that may go where the family of that name holds nothing else. With
    `explicit` no other name will do: UsageError where that one is taken.
    """
    made = {path.split("/")[0] for path in tree} - {HEAD}
    with aside(workspace.root, workspace) as draft:
        for directory in sorted(made):
            (draft / directory).mkdir()
        for path, data in tree.items():
            write_file(draft / path, data)
        for directory in sorted(made):
            sync(draft / directory)
        sync(draft)
        with locked(workspace):
            family = _place(workspace, name, made, explicit, replaceable)
            present = {path.name for path in family.directories()}
            if not present:
                draft.rename(family.directory)
                sync(workspace.root)
                return Adopted(family, changed=True)
            changed = _merge(draft, family, made, present if present <= set(replaceable) else set())
            return Adopted(family, changed)


def _place(workspace: Workspace, name: str, made: set[str], explicit: bool, replaceable: Collection[str]) -> Family:
    """The family that holds this base already, or may be replaced by it, or the first free name."""
    base = next(directory for directory in made if directory.startswith("v0-"))
    number = 1
    while True:
        family = workspace.family(name if number == 1 else f"{name}-{number}")
        present = {path.name for path in family.directories()}
        if base in present or (present and present <= set(replaceable)):
            return family
        if not present and not (family.directory.exists() and any(family.directory.iterdir())):
            return family
        if explicit:
            raise UsageError(f"{family.directory} holds another task; choose another name, or move it away")
        number += 1


def _merge(draft: Path, family: Family, made: set[str], obsolete: set[str]) -> bool:
    """Bring the versions of `draft` into `family` where they differ; drop `obsolete` ones. The lock must be held."""
    changed = False
    for directory in sorted(made):
        target = family.directory / directory
        if _same(draft / directory, target):
            continue
        changed = True
        if target.exists():
            target.rename(draft / f"old-{directory}")
        (draft / directory).rename(target)
    for directory in sorted(obsolete - made):
        changed = True
        (family.directory / directory).rename(draft / f"old-{directory}")
    if changed or family.head_name() not in {path.name for path in family.directories()}:
        (draft / HEAD).replace(family.directory / HEAD)
        sync(family.directory)
    return changed


def _same(draft: Path, target: Path) -> bool:
    """Whether `target` has every file of `draft`, with the same bytes; pictures may differ between machines."""
    for file in sorted(path.name for path in draft.iterdir()):
        there = target / file
        if not there.is_file() or (file not in PICTURES and there.read_bytes() != (draft / file).read_bytes()):
            return False
    return target.is_dir()
