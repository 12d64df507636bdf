"""Misspelt instructions: the task of the right spelling, and diagnostics about the words as they were typed."""

from __future__ import annotations

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd


def test_the_task_is_that_of_the_right_spelling() -> None:
    typed = "Two red blocks lie on the mat. Afterwards they shoud be on teh tabel."
    task, _ = BuiltinFrontEnd().read(typed)
    meant, _ = BuiltinFrontEnd().read("Two red blocks lie on the mat. Afterwards they should be on the table.")
    assert task is not None and meant is not None
    assert (task.assets, task.init) == (meant.assets, meant.init)
    assert task.instruction == typed
    assert "read 'shoud' as 'should'" in task.assumptions and "read 'tabel' as 'table'" in task.assumptions


def test_places_in_the_goal_are_those_of_the_typed_text() -> None:
    typed = "stak teh red blokc on the bleu block"
    task, _ = BuiltinFrontEnd().read(typed)
    assert task is not None and task.goal.span == (0, len(typed))


@pytest.mark.parametrize(
    ("typed", "marked"),
    [
        ("stack teh red blok on the blue block and then the blue blok on the table in a circel of nothing", None),
        ("put the red blok on blue and blue on teh red blok", "red blok"),
        ("put teh red blok and teh greeen bloc on the blok", "the blok"),
    ],
)
def test_diagnostics_underline_what_was_typed(typed: str, marked: str | None) -> None:
    task, wrong = BuiltinFrontEnd().read(typed)
    assert task is None and wrong
    for found in wrong:
        spans = [span for span in (found.span, *(label.span for label in found.labels)) if span]
        assert all(0 <= begin < end <= len(typed) for begin, end in spans)
        assert marked is None or any(marked in typed[begin:end] for begin, end in spans)
