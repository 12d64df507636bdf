"""rpg gallery: one HTML page of all tasks."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from rpg.cli.options import WORKSPACE, Json, Quiet, Tasks, workspace

EXAMPLE = "rpg gallery --out gallery.html"
Directory = Annotated[Path | None, typer.Argument(metavar="[DIR]", help="The workspace to show; as --tasks.")]
Out = Annotated[Path | None, typer.Option("--out", metavar="FILE", help="Where the page goes; gallery.html in DIR.")]


def run(
    directory: Directory = None,
    target: Out = None,
    tasks: Tasks = WORKSPACE,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Write one self-contained HTML page of all tasks: pictures of start and goal, the goal in words, checks,
    assumptions, and each family's lineage with what its edits preserved. It loads nothing from anywhere."""
    from rpg.cli.output import Output
    from rpg.core.diagnostics import UsageError
    from rpg.gallery import gallery_page
    from rpg.store import replace_file

    out = Output(as_json, quiet)
    place = workspace(directory or tasks)
    if not place.root.is_dir():
        raise UsageError(f"there is no workspace {place.root}; compile a task first, or name another directory")
    page, problems = gallery_page(place)
    path = target or place.root / "gallery.html"
    replace_file(path, page.encode())
    for problem in problems:
        out.errors.print(f"left out: {problem}", markup=False)
    out.document({"page": str(path), "bytes": len(page.encode()), "left_out": list(problems)})
    out.result.print(str(path), soft_wrap=True, markup=False)
