"""rpg batch: lists of instructions and sessions into a workspace, rebuilt only where something changed."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rpg.cli.options import WORKSPACE, Json, NoPictures, Quiet, Tasks, workspace

if TYPE_CHECKING:
    from rpg.batch.lines import Line, Report
    from rpg.batch.pool import Executor
    from rpg.cli.output import Output

EXAMPLE = "rpg batch instructions.txt sessions.yaml --jobs 4 --junit report.xml"


class Where(StrEnum):
    """Where entries are built."""

    LOCAL = "local"
    RAY = "ray"


Files = Annotated[list[str], typer.Argument(metavar="FILE...", help="YAML, JSON lines or plain text; - is stdin.")]
Jobs = Annotated[int, typer.Option("--jobs", "-j", min=0, metavar="N", help="Workers; 0: one per core.")]
Shard = Annotated[str | None, typer.Option("--shard", metavar="I/N", help="Only the I-th of N parts of the entries.")]
Check = Annotated[bool, typer.Option("--check", help="Change nothing: rebuild aside and fail if any byte differs.")]
JUnit = Annotated[Path | None, typer.Option("--junit", metavar="FILE", help="Write a JUnit XML report.")]
Markdown = Annotated[Path | None, typer.Option("--markdown", metavar="FILE", help="Write a summary in Markdown.")]
Execute = Annotated[Where, typer.Option("--executor", help="This machine, or a Ray cluster.")]


def run(
    files: Files,
    jobs: Jobs = 0,
    shard: Shard = None,
    check: Check = False,
    junit: JUnit = None,
    markdown: Markdown = None,
    executor: Execute = Where.LOCAL,
    tasks: Tasks = WORKSPACE,
    no_pictures: NoPictures = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Compile every instruction and session of the FILEs into the workspace; what is up to date is left alone. One
    entry's failure does not stop the others. Exit status 1 if any entry was refused or failed, or, with --check, if
    the workspace is not what the lists give."""
    from rpg.batch.entries import read_entries
    from rpg.batch.entries import shard as part_of
    from rpg.batch.reports import as_data, as_junit, as_markdown
    from rpg.batch.run import run_batch
    from rpg.cli.output import Output

    out = Output(as_json, quiet)
    for report_file in (junit, markdown):
        _require_place(report_file)
    entries = read_entries(files)
    if shard is not None:
        entries = part_of(entries, shard)
    with _progress(out, len(entries)) as listen:
        report = run_batch(
            entries, workspace(tasks), _executor(executor, jobs), pictures=not no_pictures, check=check, listen=listen
        )
    if junit is not None:
        _write(junit, as_junit(report))
    if markdown is not None:
        _write(markdown, as_markdown(report).encode())
    out.document(as_data(report))
    _print(out, report)
    out.finish(0 if report.good else 1)


def _executor(where: Where, jobs: int) -> Executor:
    if where is Where.RAY:
        from rpg.batch.cluster import RayCluster

        return RayCluster()
    from rpg.batch.pool import LocalPool

    return LocalPool(jobs)


def _require_place(path: Path | None) -> None:
    """A report that has no place to go is said to have none before anything is built."""
    from rpg.core.diagnostics import UsageError

    if path is not None and not path.absolute().parent.is_dir():
        raise UsageError(f"cannot write {path}: there is no directory {path.parent}")
    if path is not None and path.is_dir():
        raise UsageError(f"cannot write {path}: it is a directory")


def _write(path: Path, data: bytes) -> None:
    from rpg.core.diagnostics import UsageError
    from rpg.store import replace_file

    try:
        replace_file(path, data)
    except OSError as error:
        raise UsageError(f"cannot write {path}: {error.strerror}") from error


@contextmanager
def _progress(out: Output, total: int) -> Iterator[Callable[[Line], None]]:
    """Counts on a terminal while the batch runs; elsewhere the report at the end has to do."""
    console = out.asides
    if console.quiet or not console.is_terminal:
        yield lambda line: None
        return
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (BarColumn(), MofNCompleteColumn(), TextColumn("{task.description}"), TimeRemainingColumn())
    counts = dict.fromkeys(("admitted", "refused", "failed"), 0)
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task("starting", total=total)

        def listen(line: Line) -> None:
            what = "admitted" if line.good else line.outcome
            counts[what] = counts.get(what, 0) + 1
            bar.update(task, advance=1, description=", ".join(f"{n} {what}" for what, n in counts.items()))

        yield listen


def _print(out: Output, report: Report) -> None:
    from rich.text import Text

    from rpg.batch.reports import OUTCOMES

    if report.upgraded:
        out.asides.print(f"verified by other versions before: {report.upgraded}")
    for line in report.lines:
        if not line.good:
            out.result.print(Text(f"{line.outcome:8} {line.entry.place}  {line.entry.title}"), soft_wrap=True)
            out.result.print(Text("\n".join(f"         {part}" for part in line.detail.splitlines())), soft_wrap=True)
    counts = ", ".join(f"{report.count(outcome)} {outcome}" for outcome in OUTCOMES if report.count(outcome))
    out.result.print(counts or "no entries")
