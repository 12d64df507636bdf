"""Taking a finished family, made elsewhere, into a workspace: the versions that differ are replaced, nothing else."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path

from rpg.core.diagnostics import UsageError
from rpg.store.disk import aside, locked, sync, write_file
from rpg.store.layout import HEAD, Family, Workspace, version_name
from rpg.store.records import PICTURES, SNAPSHOT
from rpg.store.write import Content

Tree = Mapping[str, bytes]
"""The files of a family by their path inside it: `HEAD`, `v0-3f9a1c2/task.yaml`, ..."""


@dataclass(frozen=True)
class Adopted:
    """Where a family went, and whether anything in the workspace changed."""

    family: Family
    changed: bool


class Draft:
    """A family written and synced in a hidden directory of a workspace, which waits to be put in its place.

    Writing drafts takes no turns, so that many can be under way while the disk works.
    """

    def __init__(self, workspace: Workspace, tree: Tree) -> None:
        self.workspace = workspace
        self.made = {path.split("/")[0] for path in tree} - {HEAD}
        with ExitStack() as stack:
            self.directory = stack.enter_context(aside(workspace.root, workspace))
            for directory in sorted(self.made):
                (self.directory / directory).mkdir()
            for path, data in tree.items():
                write_file(self.directory / path, data)
            for directory in sorted(self.made):
                sync(self.directory / directory)
            sync(self.directory)
            self._stack = stack.pop_all()

    def close(self) -> None:
        """Remove what was not put in place."""
        self._stack.close()

    def place(self, name: str, *, explicit: bool = False, replaceable: Collection[str] = ()) -> Adopted:
        """Put the family into the workspace as `name` (`name-2`, ... where another task has that name).

        `replaceable` are directory names of versions that may go where the family of that name holds nothing else.
        With `explicit` no other name will do: UsageError where that one is taken.
        """
        try:
            with locked(self.workspace):
                family = _place(self.workspace, name, self.made, explicit, replaceable)
                present = {path.name for path in family.directories()}
                if not present:
                    self.directory.rename(family.directory)
                    sync(self.workspace.root)
                    return Adopted(family, changed=True)
                obsolete = present if present <= set(replaceable) else set()
                return Adopted(family, _merge(self.directory, family, self.made, obsolete))
        finally:
            self.close()


def base_tree(content: Content) -> dict[str, bytes]:
    """The files of a family whose only version is the base `content`."""
    snapshot = content.sealed(0)
    directory = version_name(0, snapshot.hash)
    files = {**content.files, **content.pictures, SNAPSHOT: snapshot.text().encode()}
    return {HEAD: f"{directory}\n".encode(), **{f"{directory}/{name}": data for name, data in sorted(files.items())}}


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
