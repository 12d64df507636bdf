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
from tests.corpus.entries import LOADER

FILE = Path(__file__).with_name("one_of_many_words.yaml")
TABLE = yaml.load(FILE.read_text(encoding="utf-8"), Loader=LOADER)
SAID = [
    (frame.replace("{}", word), row.get("plainly") or frame.replace("{}", row["like"]))
    for row in TABLE
    for frames, words in [([row["said"]] if isinstance(row["said"], str) else row["said"], row["with"].split(" | "))]
    for n in range(max(len(frames), len(words)))
    for frame, word in [(frames[n % len(frames)], words[n % len(words)])]
]
"""Every word in one of the sentences of its row, and every sentence with one word at least."""


@cache
def _plain(text: str) -> TaskSchema | None:
    return BuiltinFrontEnd().read(text)[0]


@pytest.mark.parametrize(("said", "plainly"), SAID)
def test_the_same_task(said: str, plainly: str) -> None:
    task, _ = BuiltinFrontEnd().read(said)
    expected = _plain(plainly)
    assert task is not None and expected is not None and same(task, expected)
