"""rpg bench: the compiler's own benchmark, beside published figures."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from rpg.cli.options import Json, NoPictures, Quiet, load_mujoco

if TYPE_CHECKING:
    from rpg.benchmark.measure import Turn
    from rpg.cli.output import Output

EXAMPLE = "rpg bench --out bench"

SuiteOption = Annotated[
    Literal["sessions", "policy", "library"],
    typer.Option("--suite", help="Ten sessions of 26 tasks; 22 tasks for policies; the ten reference tasks."),
]
Target = Annotated[Path, typer.Option("--out", metavar="DIR", help="Where tasks, tables and the page go.")]
Verdicts = Annotated[
    list[Path] | None, typer.Option("--verdicts", metavar="FILE", help="An export of the page; give several of them.")
]


def run(
    suite: SuiteOption = "sessions",
    out: Target = Path("bench"),
    verdicts: Verdicts = None,
    no_pictures: NoPictures = False,
    as_json: Json = False,
    quiet: Quiet = False,
) -> None:
    """Build every task of a suite and measure it: did it pass every gate, do both files compile on their own, do reset
    and ten steps run in a fresh process. Writes table.json, table.tex and page.html, a page of pictures to judge; with
    --verdicts, says instead how far the people who judged agree. Exit status 1 if a task did not come about."""
    load_mujoco()
    from rpg.cli.output import Output

    console = Output(as_json, quiet)
    if verdicts:
        _agreement(console, verdicts)
        return
    turns = _measure(console, suite, out, not no_pictures)
    _write(console, suite, out, turns)
    console.finish(0 if all(turn.task_success and turn.compiled and turn.smoke for turn in turns) else 1)


def _measure(console: Output, suite: Literal["sessions", "policy", "library"], out: Path, pictures: bool) -> list[Turn]:
    import shutil

    from rpg.benchmark.measure import measure
    from rpg.benchmark.suites import read_suite
    from rpg.core.diagnostics import UsageError

    root = out / suite
    try:
        if root.exists():
            shutil.rmtree(root)
        root.mkdir(parents=True)
    except OSError as error:
        raise UsageError(f"cannot write to {root}: {error.strerror}; choose another --out DIR") from error
    return measure(read_suite(suite), root, pictures, lambda title: console.asides.print(title, soft_wrap=True))


def _write(console: Output, suite: str, out: Path, turns: list[Turn]) -> None:
    import json

    from rich.table import Table

    from rpg.benchmark.page import page
    from rpg.benchmark.table import PUBLISHED, as_data, as_latex, rows
    from rpg.store import replace_file

    data = as_data(suite, turns)
    replace_file(out / suite / "table.json", (json.dumps(data, indent=2, ensure_ascii=False) + "\n").encode())
    replace_file(out / suite / "table.tex", as_latex(suite, turns).encode())
    replace_file(out / suite / "page.html", page(turns).encode())
    console.document(data)
    table = Table("", "rpg", *(PUBLISHED if suite == "sessions" else ()))
    for title, ours, others in rows(turns):
        table.add_row(title, ours, *(others if suite == "sessions" else ()))
    console.result.print(table)
    for turn in turns:
        if not (turn.task_success and turn.compiled and turn.smoke):
            console.result.print(f"{turn.key}: {turn.words}\n    {turn.problem}", soft_wrap=True, markup=False)
    console.result.print(f"{len(turns)} tasks; pictures to judge: {out / suite / 'page.html'}", soft_wrap=True)


def _agreement(console: Output, paths: list[Path]) -> None:
    from dataclasses import asdict

    from rpg.benchmark.agreement import agreement, read_ratings
    from rpg.benchmark.table import VERIFIED

    found = agreement(read_ratings(paths))
    console.document({**asdict(found), "published": VERIFIED})
    kappa = "undefined" if found.kappa is None else f"{found.kappa:.2f}"
    console.result.print(
        f"{found.accepted:.1f} % of verdicts say right; {found.raters} people judged {found.tasks} tasks in common, "
        f"{found.unanimous:.1f} % of them unanimously; Fleiss' kappa {kappa}",
        soft_wrap=True,
    )
    published = ", ".join(f"{name} {percent:.1f} ± {half:.1f}" for name, (percent, half) in VERIFIED.items())
    console.result.print(f"published, accepted by people over the ten sessions: {published}", soft_wrap=True)
