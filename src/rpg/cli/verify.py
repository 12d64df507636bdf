"""rpg verify: whether a workspace can be trusted."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rpg.cli.options import WORKSPACE, Json, Quiet, Tasks, load_mujoco, workspace

if TYPE_CHECKING:
    from rpg.store import Family

EXAMPLE = "rpg verify red-on-blue"
Some = Annotated[list[str] | None, typer.Argument(metavar="[TASK]...", help="Tasks; all of the workspace without one.")]


def run(task: Some = None, tasks: Tasks = WORKSPACE, as_json: Json = False, quiet: Quiet = False) -> None:
    """Check every version of the families of TASKs: hashes of files, lineage, HEAD, and that the code is what
    task.yaml gives. Exit status 1 if anything differs."""
    load_mujoco()
    from rich.text import Text

    from rpg.cli.output import Output
    from rpg.loading import verify

    out = Output(as_json, quiet)
    families = _families(task or [], tasks)
    found = {family.name: verify(family) for family in families}
    count = sum(len(family.directories()) for family in families)
    bad = [diagnostic for problems in found.values() for diagnostic in problems]
    out.document(
        {
            "status": "differs" if bad else "sound",
            "versions": count,
            "families": {
                name: [problem.model_dump(mode="json") for problem in problems] for name, problems in found.items()
            },
        }
    )
    for problem in bad:
        out.result.print(Text.assemble((problem.code, "bold red"), f": {problem.message}"), soft_wrap=True)
    if not bad:
        of = f"{_number(count, 'version')} of {_number(len(families), 'task')}"
        out.result.print(Text.assemble(("✓ ", "green"), f"{of}: nothing differs"))
    out.finish(1 if bad else 0)


def _number(count: int, what: str) -> str:
    return f"{count} {what}{'s' * (count != 1)}"


def _families(names: list[str], tasks: Path) -> list[Family]:
    """The families of the tasks named, each once; all of the workspace where none is named."""
    from rpg.core.diagnostics import UsageError
    from rpg.store import resolve_family

    if not names:
        if not tasks.is_dir():
            raise UsageError(f"there is no workspace at {tasks}")
        return list(workspace(tasks).families())
    return list(dict.fromkeys(resolve_family(workspace(tasks), name) for name in names))
