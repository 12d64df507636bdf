"""The examples of the language reference compile to what they are examples of."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from rpg.ir import goal as g
from rpg.ir.walk import children
from rpg.passes.schema.frontend import BuiltinFrontEnd

EXAMPLES = Path(__file__).parents[2] / "docs" / "language_examples.yaml"
PAIRS = [(kind, text) for kind, texts in yaml.safe_load(EXAMPLES.read_text(encoding="utf-8")).items() for text in texts]


def kinds(goal: g.Goal) -> set[str]:
    return {goal.kind}.union(*(kinds(child) for child in children(goal)))


@pytest.mark.parametrize(("kind", "text"), PAIRS)
def test_examples_compile_to_their_condition(kind: str, text: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text, name=None, seed=0, author=None)
    assert schema is not None, diagnostics
    assert kind in kinds(schema.goal)
