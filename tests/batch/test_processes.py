"""Batches in processes that are killed, interrupted, or break down."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from itertools import permutations
from multiprocessing import forkserver
from pathlib import Path
from random import Random

import pytest

from rpg.batch import work
from rpg.batch.entries import Entry
from rpg.batch.ledger import LOCKFILE
from rpg.batch.pool import LocalPool
from rpg.batch.run import run_batch
from rpg.core.diagnostics import UsageError
from rpg.language.lexicon import COLORS
from rpg.store import Workspace, adopt
from tests.batch.test_run import ROW, STACK, Here, batch, contents, entries

LIST = [
    "put the red block on the blue block",
    "put the green block on the blue block",
    "put the pink block on the blue block",
    "put the red block to the left of the blue block",
    "put the green block to the left of the pink block",
    "put the black block behind the blue block",
]


LONG = [f"put the {a} block on the {b} block" for a, b in permutations(COLORS, 2)]
"""So many that none of them is through before a signal comes."""


def start(root: Path, *more: str, lines: Sequence[str] = LIST) -> subprocess.Popen[bytes]:
    (root / "list.txt").write_text("\n".join(lines))
    command = [sys.executable, "-m", "rpg", "batch", str(root / "list.txt"), "--jobs", "2", "--no-pictures"]
    return subprocess.Popen(
        [*command, "--tasks", str(root / "w"), *more],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        start_new_session=True,
    )


def wait_for(root: Path, families: int) -> None:
    """Until so many families are in place, or half a minute has passed."""
    for _ in range(600):
        if len(list((root / "w").glob("*/HEAD"))) >= families:
            return
        time.sleep(0.05)


def test_a_killed_batch_resumes_to_the_same_bytes(tmp_path: Path) -> None:
    rng = Random(1)
    for families in (0, 2):
        process = start(tmp_path)
        wait_for(tmp_path, families)
        time.sleep(rng.uniform(0.0, 0.3))
        process.kill()
        process.communicate()
    last = start(tmp_path)
    out, _ = last.communicate(timeout=120)
    assert last.returncode == 0, out
    items = tuple(Entry(f"list:{i}", text) for i, text in enumerate(LIST, 1))
    batch(tmp_path / "whole", items)
    assert contents(tmp_path / "w") == contents(tmp_path / "whole")


def test_ctrl_c_leaves_what_is_finished_and_says_nothing(tmp_path: Path) -> None:
    process = start(tmp_path, lines=LONG)
    wait_for(tmp_path, 1)
    os.killpg(process.pid, signal.SIGINT)
    _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    assert b"Traceback" not in err
    done = {path.parent.name for path in (tmp_path / "w").glob("*/HEAD")}
    assert done
    assert all(f'"family": "{name}"' in (tmp_path / "w" / LOCKFILE).read_text() for name in done)
    assert not list((tmp_path / "w").glob(".new-*"))


def test_a_killed_worker_costs_no_entry() -> None:
    results = LocalPool(1).map([(entry, False) for entry in entries(*LIST)])
    found = [next(results)]
    server = forkserver._forkserver._forkserver_pid  # type: ignore[attr-defined]
    workers = Path(f"/proc/{server}/task/{server}/children").read_text().split()
    os.kill(int(workers[-1]), signal.SIGKILL)
    found += list(results)
    assert [result.status for result in found] == ["admitted"] * len(LIST)


def test_pictures_are_drawn_by_workers(tmp_path: Path) -> None:
    report = run_batch(entries(STACK), Workspace(tmp_path), LocalPool(1))
    assert report.good
    pictures = sorted(path.name for path in tmp_path.rglob("*.png"))
    assert pictures == ["goal.png", "initial.png"]
    assert all(path.read_bytes().startswith(b"\x89PNG") for path in tmp_path.rglob("*.png"))


def test_an_error_in_one_entry_is_its_own_and_tried_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    whole = work._built

    def built(entry: Entry, pictures: bool) -> work.Result:
        if entry.instruction == STACK:
            raise NameError("ref")
        return whole(entry, pictures)

    monkeypatch.setattr(work, "_built", built)
    report, _ = batch(tmp_path, entries(STACK, ROW))
    assert [line.outcome for line in report.lines] == ["failed", "built"]
    assert "NameError" in report.lines[0].detail and "ref" in report.lines[0].detail
    monkeypatch.undo()
    report, built_now = batch(tmp_path, entries(STACK, ROW))
    assert [line.outcome for line in report.lines] == ["built", "current"] and built_now == [STACK]


def test_a_full_disk_ends_the_batch_and_keeps_what_is_finished(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    batch(tmp_path, entries(STACK))
    before = contents(tmp_path)

    def full(path: Path, data: bytes) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(adopt, "write_file", full)
    with pytest.raises(UsageError, match="No space left on device"):
        batch(tmp_path, entries(STACK, ROW))
    assert contents(tmp_path) == before


def test_entries_of_one_family_do_not_push_each_other_out(tmp_path: Path) -> None:
    session = Entry("list:2", STACK, edits=("Add a green block on top",))
    for items in ((entries(STACK)), (*entries(STACK), session)):
        batch(tmp_path, items)
    here = Here()
    report = run_batch((*entries(STACK), session), Workspace(tmp_path), here, pictures=False)
    assert here.built == [] and report.good
