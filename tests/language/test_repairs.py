"""Refusals name the structured repair that would mend them."""

from __future__ import annotations

import pytest

from rpg.passes.schema.frontend import BuiltinFrontEnd

CASES = {
    "Arrange 27 letter blocks in alphabetical order": "REDUCE_LABELS_PRESERVE_GEOMETRY",
    "Spell the word CAT with the letters C, A and B": "SWITCH_TO_SPATIAL_ONLY",
    "Arrange three red blocks in alphabetical order": "SWITCH_ORDERING_PATTERN",
}


@pytest.mark.parametrize("text", CASES)
def test_a_refusal_names_its_repair(text: str) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(text)
    assert schema is None
    assert [d.facts.get("repair") for d in diagnostics if d.severity == "error"] == [CASES[text]]
