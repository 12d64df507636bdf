"""rpg log: how a family's versions came about."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rpg.cli.options import WORKSPACE, Json, Quiet, Task, Tasks, find

if TYPE_CHECKING:
    from rpg.store import Version

EXAMPLE = "rpg log red-on-blue"


def run(task: Task, tasks: Tasks = WORKSPACE, as_json: Json = False, quiet: Quiet = False) -> None:
    """Show the versions of TASK's family: which came from which, by what request, and which is current."""
    from rpg.cli.output import Output
    from rpg.cli.tree import lineage_tree
    from rpg.store import Family

    out = Output(as_json, quiet)
    family = Family(find(task, tasks).directory.parent)
    versions, head = family.versions(), family.head()
    out.document({"family": family.name, "head": head.number, "versions": [_entry(v) for v in versions]})
    out.result.print(lineage_tree(family.name, versions, head))


def _entry(version: Version) -> dict[str, Any]:
    snapshot = version.snapshot
    steering = snapshot.steering
    return {
        "version": version.number,
        "hash": version.hash,
        "directory": str(version.directory),
        "parent": snapshot.parent,
        "description": snapshot.snapshot.description,
        "goal_text": snapshot.snapshot.goal_summary,
        "code_hash": snapshot.snapshot.code_hash,
        "steering": steering.model_dump(mode="json") if steering else None,
    }
