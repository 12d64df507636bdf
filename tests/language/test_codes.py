"""Every code of the language: its example brings it about, and the remedy is read."""

import pytest

from rpg.core.codes import feasibility, language
from rpg.core.codes.base import Code
from rpg.passes.schema.frontend import BuiltinFrontEnd

CODES = (*language.CODES, *feasibility.CODES)


@pytest.mark.parametrize("code", [c for c in CODES if c.example], ids=lambda c: c.id)
def test_example_is_refused_with_its_code(code: Code) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(code.example)
    assert schema is None
    assert code.id in [d.code for d in diagnostics], diagnostics


@pytest.mark.parametrize("code", [c for c in CODES if c.remedy], ids=lambda c: c.id)
def test_remedy_is_read(code: Code) -> None:
    schema, diagnostics = BuiltinFrontEnd().read(code.remedy)
    assert schema is not None, diagnostics
