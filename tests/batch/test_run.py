"""Batches against a workspace, in this process: names, what is rebuilt, what a check finds, what a kill leaves."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from rpg import pipeline
from rpg.batch import ledger as ledger_module
from rpg.batch.entries import Entry
from rpg.batch.ledger import LOCKFILE
from rpg.batch.lines import Report
from rpg.batch.pool import Job
from rpg.batch.reports import as_data, as_junit, as_markdown
from rpg.batch.run import run_batch
from rpg.batch.work import Result, build
from rpg.core.diagnostics import UsageError
from rpg.ir.artifact import GateReport, Program
from rpg.passes.validate.findings import failure
from rpg.store import Workspace

STACK = "Stack the red block on the yellow block"
ROW = "Place the red block to the left of the blue block"
NONSENSE = "Frobnicate the wug"


@dataclass
class Here:
    """Builds in this process, and counts."""

    built: list[str] = field(default_factory=list)
    stop_after: int | None = None

    def map(self, jobs: Sequence[Job]) -> Generator[Result, None, None]:
        for entry, pictures in jobs:
            if self.stop_after is not None and len(self.built) >= self.stop_after:
                raise KeyboardInterrupt
            self.built.append(entry.instruction)
            yield build(entry, pictures)


def entries(*instructions: str, names: bool = False) -> tuple[Entry, ...]:
    return tuple(
        Entry(f"list:{i}", text, name=f"task-{i}" if names else None) for i, text in enumerate(instructions, 1)
    )


def batch(root: Path, items: tuple[Entry, ...], *, check: bool = False) -> tuple[Report, list[str]]:
    here = Here()
    return run_batch(items, Workspace(root), here, pictures=False, check=check), here.built


def contents(root: Path) -> dict[str, bytes]:
    return {str(p.relative_to(root)): p.read_bytes() for p in sorted(root.rglob("*")) if p.is_file()}


def test_only_what_is_new_is_built(tmp_path: Path) -> None:
    first, built = batch(tmp_path, entries(STACK, NONSENSE))
    assert [line.outcome for line in first.lines] == ["built", "refused"]
    assert built == [STACK, NONSENSE]
    before = contents(tmp_path)
    second, built = batch(tmp_path, entries(STACK, NONSENSE, ROW))
    assert [line.outcome for line in second.lines] == ["current", "refused", "built"]
    assert built == [ROW]
    assert {k: v for k, v in contents(tmp_path).items() if k in before and k != LOCKFILE} == {
        k: v for k, v in before.items() if k != LOCKFILE
    }


def test_a_flipped_byte_is_built_again(tmp_path: Path) -> None:
    batch(tmp_path, entries(STACK))
    before = contents(tmp_path)
    code = next(tmp_path.rglob("code.py"))
    code.write_bytes(code.read_bytes().replace(b"red", b"rad", 1))
    report, _ = batch(tmp_path, entries(STACK), check=True)
    assert [line.outcome for line in report.lines] == ["differs"]
    assert "rad" in report.lines[0].detail and "code.py" in report.lines[0].detail
    report, built = batch(tmp_path, entries(STACK))
    assert built == [STACK] and report.good
    assert contents(tmp_path) == before


def test_a_check_changes_nothing(tmp_path: Path) -> None:
    report, _ = batch(tmp_path / "none", entries(STACK), check=True)
    assert report.lines[0].outcome == "differs"
    assert not (tmp_path / "none").exists()
    batch(tmp_path, entries(STACK))
    before = contents(tmp_path)
    report, _ = batch(tmp_path, entries(STACK), check=True)
    assert [line.outcome for line in report.lines] == ["same"]
    assert contents(tmp_path) == before


def test_a_named_entry_replaces_its_own_family_only(tmp_path: Path) -> None:
    batch(tmp_path, entries(STACK, names=True))
    old = {path.name for path in (tmp_path / "task-1").glob("v*")}
    batch(tmp_path, entries(ROW, names=True))
    new = {path.name for path in (tmp_path / "task-1").glob("v*")}
    assert len(new) == 1 and new != old
    (tmp_path / "task-1" / "v1-0000000").mkdir()
    report, _ = batch(tmp_path, entries(STACK, names=True))
    assert report.lines[0].outcome == "failed" and "task-1" in report.lines[0].detail
    assert (tmp_path / "task-1" / next(iter(new))).is_dir()


def test_names_follow_the_order_of_the_lists(tmp_path: Path) -> None:
    same_name = entries(STACK, STACK + " ", "Put the red block on the yellow block")
    report, _ = batch(tmp_path, same_name)
    again, _ = batch(tmp_path, same_name)
    assert [line.family for line in report.lines] == [line.family for line in again.lines]
    assert report.lines[0].family == "red-on-yellow"


def test_an_interrupted_batch_resumes_to_the_same_bytes(tmp_path: Path) -> None:
    items = entries(STACK, ROW, "Stack the blue block on the red block")
    with pytest.raises(KeyboardInterrupt):
        run_batch(items, Workspace(tmp_path / "a"), Here(stop_after=2), pictures=False)
    report, built = batch(tmp_path / "a", items)
    assert [line.outcome for line in report.lines] == ["current", "current", "built"]
    assert len(built) == 1
    batch(tmp_path / "b", items)
    assert contents(tmp_path / "a") == contents(tmp_path / "b")


def test_another_mujoco_builds_everything_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    batch(tmp_path, entries(STACK))
    monkeypatch.setattr(ledger_module, "mujoco_version", lambda: "9.9.9")
    report, built = batch(tmp_path, entries(STACK))
    assert built == [STACK] and "9.9.9" in report.upgraded


def test_a_damaged_ledger_is_said_to_be(tmp_path: Path) -> None:
    (tmp_path / LOCKFILE).write_text("{")
    with pytest.raises(UsageError, match=r"rpg\.lock is damaged"):
        batch(tmp_path, entries(STACK))


def test_a_session_becomes_one_family(tmp_path: Path) -> None:
    session = Entry("list:1", "Stack the blue block on the red block", edits=("Add a green block on top",))
    report, _ = batch(tmp_path, (session,))
    assert report.good
    family = tmp_path / report.lines[0].family
    assert len(list(family.glob("v*"))) == 2
    assert (family / "HEAD").read_text().startswith("v1-")


def test_entries_on_one_line_are_told_apart(tmp_path: Path) -> None:
    (first,) = entries(STACK)
    assert batch(tmp_path, (first,))[1] == [STACK]
    second = Entry(first.place, ROW)
    report, built = batch(tmp_path, (first, second))
    assert [line.outcome for line in report.lines] == ["current", "built"] and built == [ROW]


def test_what_failed_is_kept_for_looking_into(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def validate(program: Program, **_: object) -> tuple[GateReport, ...]:
        return (GateReport.of("goal-state", [failure("goal-state", "goal-not-kept", "goal", "the stack falls")]),)

    monkeypatch.setattr(pipeline, "validate", validate)
    report, _ = batch(tmp_path, entries(STACK))
    monkeypatch.undo()
    (line,) = report.lines
    assert line.outcome == "failed" and line.rejected.startswith(".rejected/red-on-yellow-")
    assert "the stack falls" in line.detail and line.rejected in line.detail
    kept = tmp_path / line.rejected
    assert sorted(path.name for path in kept.iterdir()) == [
        "code.py",
        "goal_state_code.py",
        "task.yaml",
        "validation.log",
    ]
    assert "the stack falls" in (kept / "validation.log").read_text()
    assert not list(tmp_path.glob("*/HEAD"))
    again, built = batch(tmp_path, entries(STACK))
    assert built == [] and again.lines[0] == line
    assert as_data(again)["entries"][0]["rejected"] == line.rejected


def test_a_refused_edit_is_named(tmp_path: Path) -> None:
    session = Entry("list:1", "Stack the blue block on the red block", edits=("Add a green block on top", NONSENSE))
    for _ in range(2):
        report, _ = batch(tmp_path, (session,))
        assert report.lines[0].outcome == "refused"
        assert report.lines[0].detail.startswith(f"edit 2, {NONSENSE!r}: ")
        assert "hint:" in report.lines[0].detail
    assert not list(tmp_path.glob("*/HEAD"))


def test_reports_say_what_is_not_in_order(tmp_path: Path) -> None:
    report, _ = batch(tmp_path, entries(STACK, NONSENSE))
    data = as_data(report)
    assert data["counts"] == {"built": 1, "refused": 1} and not data["good"]
    junit = as_junit(report).decode()
    assert 'tests="2"' in junit and 'failures="1"' in junit and NONSENSE in junit
    assert NONSENSE in as_markdown(report) and STACK not in as_markdown(report)
