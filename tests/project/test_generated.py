"""Exported schemas and generated pages are those of the code, and say what is true."""

from __future__ import annotations

import importlib.util
import json
import re
from pathlib import Path
from types import ModuleType

import jsonschema
import pytest
import yaml

from rpg.core.codes import CODES
from rpg.store import dump_schema
from tests.store.test_taskfile import RICH

ROOT = Path(__file__).resolve().parents[2]


def generator() -> ModuleType:
    spec = importlib.util.spec_from_file_location("generate", ROOT / "docs" / "generate.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_generated_files_are_up_to_date() -> None:
    for path, text in generator().generated().items():
        assert (ROOT / path).read_text() == text, f"{path} is out of date: make docs"


def test_a_task_file_fits_its_schema() -> None:
    schema = json.loads((ROOT / "schemas" / "task.schema.json").read_text())
    jsonschema.validate(yaml.safe_load(dump_schema(RICH)), schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({"format": 1, "name": "x"}, schema)


def test_every_code_is_documented() -> None:
    page = (ROOT / "docs" / "reference" / "diagnostics.md").read_text()
    assert set(re.findall(r"^### (\S+)$", page, re.MULTILINE)) == set(CODES)
    for code in CODES.values():
        assert re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", code.id)
        assert code.title and code.explanation


def test_every_code_that_is_reported_is_registered() -> None:
    reported: set[str] = set()
    for path in (ROOT / "src" / "rpg").rglob("*.py"):
        reported |= set(re.findall(r'\bcode="([a-z0-9]+(?:-[a-z0-9]+)*)"', path.read_text()))
    assert reported <= set(CODES), f"not in rpg.core.codes: {sorted(reported - set(CODES))}"
