"""The surface that generated code uses keeps pace with the goal language."""

from __future__ import annotations

import inspect

import pytest

import rpg.env
from rpg.env import BlockTask
from rpg.ir.node import Node
from rpg.ir.walk import ATOMS


@pytest.mark.parametrize("atom", ATOMS, ids=lambda atom: atom.__name__)
def test_every_atom_has_a_method_with_its_fields_and_defaults(atom: type[Node]) -> None:
    fields = {name: info for name, info in atom.model_fields.items() if name not in ("kind", "span")}
    method = inspect.signature(getattr(BlockTask, fields and atom.model_fields["kind"].default))
    parameters = {name: p for name, p in method.parameters.items() if name != "self"}
    assert set(parameters) == set(fields)
    for name, info in fields.items():
        assert (parameters[name].default is inspect.Parameter.empty) == info.is_required()
        if not info.is_required():
            assert parameters[name].default == info.default
            assert parameters[name].kind is inspect.Parameter.KEYWORD_ONLY


def test_every_atom_can_be_imported_from_the_surface() -> None:
    assert {atom.__name__ for atom in ATOMS} <= set(rpg.env.__all__)
