"""Words that mean the same in one place: verbs of making and placing, what is thought of a figure, how it is wished,
how many, when, which way along a line, where on the table, what must not be."""

from __future__ import annotations

from functools import cache
from pathlib import Path

import pytest
import yaml

from rpg.ir.schema import TaskSchema
from rpg.passes.schema.ambiguity import same
from rpg.passes.schema.frontend import BuiltinFrontEnd

TABLE = yaml.safe_load(Path(__file__).with_suffix(".yaml").with_stem("one_of_many_words").read_text(encoding="utf-8"))
SAID = [
    (frame.replace("{}", word), row.get("plainly") or frame.replace("{}", row["like"]))
    for row in TABLE
    for frame in ([row["said"]] if isinstance(row["said"], str) else row["said"])
    for word in row["with"].split(" | ")
]


@cache
def _plain(text: str) -> TaskSchema | None:
    return BuiltinFrontEnd().read(text)[0]


@pytest.mark.parametrize(("said", "plainly"), SAID)
def test_the_same_task(said: str, plainly: str) -> None:
    task, _ = BuiltinFrontEnd().read(said)
    expected = _plain(plainly)
    assert task is not None and expected is not None and same(task, expected)
