"""rpg verify: whether a workspace can be trusted."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rpg.cli.options import WORKSPACE, Json, Quiet, Tasks, load_mujoco, workspace

if TYPE_CHECKING:
    from rpg.store import Family

EXAMPLE = "rpg verify red-on-blue"
Everything = Annotated[bool, typer.Option("--all", help="The whole workspace; after an upgrade, also what it changed.")]
Some = Annotated[list[str] | None, typer.Argument(metavar="[TASK]...", help="Tasks; all of the workspace without one.")]


def run(
    task: Some = None,
    everything: Everything = False,
    tasks: Tasks = WORKSPACE,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Check every version of the families of TASKs: hashes of files, lineage, HEAD, and that the code is what
    task.yaml gives. With --all, where rpg.lock names other versions of rpg or MuJoCo, the gates of every task run
    again, and goals are compared with their verdicts on record. Exit status 1 if anything differs."""
    load_mujoco()
    from rich.text import Text

    from rpg.cli.output import Output
    from rpg.cli.upgraded import changes
    from rpg.loading import verify

    out = Output(as_json, quiet)
    families = _families([] if everything else task or [], tasks)
    found = {family.name: verify(family) for family in families}
    news = changes(out, workspace(tasks), families, found) if everything else ""
    count = sum(len(family.directories()) for family in families)
    said = [diagnostic for problems in found.values() for diagnostic in problems]
    bad = [diagnostic for diagnostic in said if diagnostic.severity == "error"]
    out.document(
        {
            "status": "differs" if bad else "sound",
            "upgraded": news or None,
            "versions": count,
            "families": {
                name: [problem.model_dump(mode="json") for problem in problems] for name, problems in found.items()
            },
        }
    )
    if news:
        out.result.print(f"verified by other versions before: {news}", highlight=False)
    for problem in said:
        color = "bold red" if problem.severity == "error" else "yellow"
        out.result.print(Text.assemble((problem.code, color), f": {problem.message}"), soft_wrap=True)
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
