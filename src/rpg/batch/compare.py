"""How a family that was rebuilt aside differs from the one in the workspace, as a diff that people read."""

from __future__ import annotations

from collections.abc import Mapping
from difflib import unified_diff

from rpg.store import Family
from rpg.store.layout import HEAD
from rpg.store.records import PICTURES, SNAPSHOT

MAX_LINES = 40
"""Lines of a diff that are shown for one family."""


def differences(family: Family, tree: Mapping[str, bytes]) -> str:
    """A unified diff from the workspace's files to the rebuilt ones; empty where every byte agrees.

    Pictures depend on the machine's graphics and are left out.
    """
    there = {path.name: path for path in family.directories()}
    if not there:
        return f"{family.name} is not in the workspace"
    rebuilt = {path: data for path, data in tree.items() if path != HEAD and path.split("/")[-1] not in PICTURES}
    numbers = {directory.split("-")[0]: directory for directory in there}
    lines: list[str] = []
    for path, data in sorted(rebuilt.items(), key=lambda item: (item[0].endswith(SNAPSHOT), item[0])):
        directory, name = path.split("/")
        counterpart = there.get(directory) or there.get(numbers.get(directory.split("-")[0], ""))
        if counterpart is None:
            lines.append(f"{family.name}/{path} is not in the workspace")
            continue
        old = (counterpart / name).read_bytes() if (counterpart / name).is_file() else None
        if old != data:
            lines += _diff(f"{family.name}/{counterpart.name}/{name}", old, data)
    if len(lines) > MAX_LINES:
        lines = [*lines[:MAX_LINES], f"... and {len(lines) - MAX_LINES} lines more"]
    return "\n".join(lines)


def _diff(title: str, old: bytes | None, new: bytes) -> list[str]:
    if old is None:
        return [f"{title} is missing"]
    before, after = (data.decode(errors="backslashreplace").splitlines() for data in (old, new))
    lines = unified_diff(before, after, title, "rebuilt", lineterm="", n=1)
    return list(lines) or [f"{title} differs in its line ends"]
