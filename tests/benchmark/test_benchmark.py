"""The benchmark's suites, figures and page."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest

from rpg.benchmark.agreement import Ratings, agreement, read_ratings
from rpg.benchmark.measure import Turn, measure, share
from rpg.benchmark.page import page
from rpg.benchmark.suites import SUITES, read_suite
from rpg.benchmark.table import as_data, as_latex, rows
from rpg.cli.main import run
from rpg.core.diagnostics import UsageError


def turn(case: str, ok: bool) -> Turn:
    return Turn(case=case, number=0, words="w", task_success=ok, compiled=ok, smoke=ok)


def test_the_suites_have_the_published_sizes() -> None:
    tasks = {suite: sum(1 + len(entry.edits) for entry in read_suite(suite)) for suite in SUITES}
    assert tasks == {"sessions": 26, "policy": 22, "library": 10}
    assert len(read_suite("sessions")) == 10


def test_a_share_has_the_normal_interval() -> None:
    turns = [turn(str(i), i < 8) for i in range(10)]
    found = share(turns, "compiled")
    assert found.percent == pytest.approx(80.0)
    assert found.half_width == pytest.approx(24.8, abs=0.05)


def test_the_table_sets_ours_beside_the_published_figures() -> None:
    turns = [turn("a", True)]
    assert rows(turns)[1][1:] == ("100.0 ± 0.0", ["100.0 ± 0.0", "80.0 ± 24.8", "80.0 ± 24.8"])
    assert as_latex("sessions", turns).count(r"\pm") == 12
    assert as_latex("policy", turns).count(r"\pm") == 3 and "{lc}" in as_latex("policy", turns)
    assert as_data("policy", turns)["published"] == {}


def test_kappa_of_a_worked_example() -> None:
    votes = [{"a": True, "b": True, "c": False, "d": False}, {"a": True, "b": False, "c": False, "d": True}]
    found = agreement([Ratings(rater=str(i), verdicts=v) for i, v in enumerate(votes)])
    assert (found.raters, found.tasks, found.accepted, found.unanimous) == (2, 4, 50.0, 50.0)
    assert found.kappa == pytest.approx(0.0)
    same = agreement([Ratings(rater=str(i), verdicts={"a": True, "b": False}) for i in range(3)])
    assert same.kappa == pytest.approx(1.0)
    assert agreement([Ratings(rater="x", verdicts={"a": True})] * 2).kappa is None


def test_an_edit_is_shown_with_what_was_said_before_it(tmp_path: Path) -> None:
    turns = [
        Turn(case=case, number=number, words=f"{case} {number}", directory=str(tmp_path), task_success=True)
        for case in ("a", "b")
        for number in range(3)
    ]
    data = re.search(r'id="tasks">(.*?)</script>', page(turns), re.DOTALL)
    assert data is not None
    assert [task["before"] for task in json.loads(data[1])] == [
        [],
        ["a 0"],
        ["a 0", "a 1"],
        [],
        ["b 0"],
        ["b 0", "b 1"],
    ]


def test_verdicts_are_set_beside_the_published_ones(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    files = []
    for rater, verdict in (("Ann", True), ("Bob", False)):
        files.append(tmp_path / f"{rater}.json")
        files[-1].write_text(json.dumps({"rater": rater, "verdicts": {"a/0": True, "a/1": verdict}}))
    arguments = [part for path in files for part in ("--verdicts", str(path))]
    assert run(["bench", *arguments]) == 0
    said = capsys.readouterr().out
    assert "75.0 % of verdicts say right; 2 people judged 2 tasks" in said and "GenSim 70.0 ± 28.4" in said
    assert run(["bench", "--json", *arguments]) == 0
    assert json.loads(capsys.readouterr().out)["published"]["Cursor"] == [80.0, 24.8]


def test_a_file_that_is_no_export_is_said_to_be_none(tmp_path: Path) -> None:
    path = tmp_path / "x.json"
    path.write_text("{}")
    with pytest.raises(UsageError, match="no export"):
        read_ratings([path])


def test_a_session_is_measured_turn_by_turn(tmp_path: Path) -> None:
    entries = [entry for entry in read_suite("policy") if entry.name == "red-on-yellow-stack"]
    (found,) = measure(tuple(entries), tmp_path, False, lambda title: None)
    assert found.task_success and found.compiled and found.smoke
    assert "red block" in found.goal_text


def test_the_page_holds_its_data_and_nothing_from_elsewhere(tmp_path: Path) -> None:
    (tmp_path / "goal.png").write_bytes(b"\x89PNG")
    words = "Stack </script><b>two</b> blocks"
    html = page([Turn(case="a", number=0, words=words, directory=str(tmp_path), task_success=True)])
    data = re.search(r'id="tasks">(.*?)</script>', html, re.DOTALL)
    assert data is not None
    task = json.loads(data[1])[0]
    assert task["words"] == words and list(task["pictures"]) == ["goal"]
    assert not re.search(r"https?://", html)
