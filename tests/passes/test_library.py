"""The reference tasks are what their index makes of them, to the byte, and are looked up by what they hold."""

from __future__ import annotations

import ast

import pytest

from rpg.ir.walk import atoms
from rpg.library import Reference, build, place, references
from rpg.pipeline import is_lowered, load_program
from rpg.store import read_schema

ENTRIES = references(place())
KINDS = {
    "StackBlocks": {"on", "stack", "towers"},
    "StackBlocksOnTarget": {"stack", "towers"},
    "AlignBlocks": {"row"},
    "ArrangeLetters": {"row"},
    "ArrangeWord": {"spells"},
    "ArrangeNumbers": {"row"},
    "ArrangeEquation": {"equation"},
    "ArrangeShapes": {"figure"},
    "SequentialPlaceOnTarget": {"on_patch"},
    "RotateCube": {"facing", "turned"},
}


def test_there_are_ten() -> None:
    assert [entry.name for entry in ENTRIES] == list(KINDS)


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.name)
def test_files_are_what_the_index_makes_of_them(entry: Reference) -> None:
    directory = place() / entry.name
    found = {path.name: path.read_bytes().decode() for path in directory.iterdir()}
    assert found == build(entry)
    assert found["validation.log"].endswith("\nadmitted\n")


@pytest.mark.parametrize("entry", ENTRIES, ids=lambda entry: entry.name)
def test_attributes_fit_the_task(entry: Reference) -> None:
    directory = place() / entry.name
    task = read_schema(directory / "task.yaml")
    assert {type(asset).__name__ for asset in task.assets} == set(entry.asset)
    kinds = {atom.kind for atom in atoms(task.goal)}
    assert kinds & KINDS[entry.name]
    assert (entry.complexity == "hierarchical") == (task.goal.kind == "sequence")
    assert is_lowered(load_program(directory, task))
    assert f"class {entry.name}(BlockTask):" in (directory / "code.py").read_text()
    assert ast.get_docstring(ast.parse((directory / "code.py").read_text()).body[-1])  # type: ignore[arg-type]
