"""Random tasks of several parts read back as the same task; `python -m tests.english.run` tries many more."""

from __future__ import annotations

import pytest

from rpg.ir.schema import TaskSchema
from tests.english.run import compositions, difference

COUNT = 120


@pytest.mark.parametrize(("title", "schema"), list(compositions(COUNT)))
def test_a_description_reads_back_as_the_same_task(title: str, schema: TaskSchema) -> None:
    assert not difference(schema), title
