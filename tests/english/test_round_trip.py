"""What a schema is described as compiles back to the same task."""

from __future__ import annotations

import pytest

from rpg.blocks.english import describe
from rpg.blocks.equivalence import equivalent
from rpg.passes.schema.frontend import BuiltinFrontEnd
from tests.english.schemas import random_schema


@pytest.mark.parametrize("seed", range(150))
def test_description_of_a_random_schema_compiles_to_an_equivalent_task(seed: int) -> None:
    schema = random_schema(seed)
    text = describe(schema)
    read, diagnostics = BuiltinFrontEnd().read(text, name=None, seed=0, author=None)
    assert read is not None, f"{text}\n{diagnostics}"
    assert equivalent(schema, read), f"{text}\n{read.goal}"
