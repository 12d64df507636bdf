"""Words that mean the same in one place: verbs of making and placing, what is thought of a figure, how it is wished."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from rpg.passes.schema.ambiguity import same
from rpg.passes.schema.frontend import BuiltinFrontEnd

TABLE = yaml.safe_load(Path(__file__).with_suffix(".yaml").with_stem("one_of_many_words").read_text(encoding="utf-8"))
SAID = [(row["said"].format(word), row["plainly"]) for row in TABLE for word in row["with"].split(" | ")]


@pytest.mark.parametrize(("said", "plainly"), SAID)
def test_the_same_task(said: str, plainly: str) -> None:
    task, _ = BuiltinFrontEnd().read(said)
    expected, _ = BuiltinFrontEnd().read(plainly)
    assert task is not None and expected is not None and same(task, expected)
