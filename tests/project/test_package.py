"""The package can be built: what pyproject.toml names is there, and versions agree."""

from __future__ import annotations

import tomllib
from pathlib import Path

import rpg

ROOT = Path(__file__).resolve().parents[2]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())


def test_what_the_wheel_includes_is_there() -> None:
    included = PROJECT["tool"]["hatch"]["build"]["targets"]["wheel"]["force-include"]
    for directory in included:
        assert any((ROOT / directory).iterdir()), f"{directory} is empty"


def test_top_level_directories_ship() -> None:
    included = PROJECT["tool"]["hatch"]["build"]["targets"]["wheel"]["force-include"]
    for name in ("library", "examples", "schemas"):
        directory = ROOT / name
        assert name in included or not directory.is_dir() or not any(directory.iterdir()), f"{name} does not ship"


def test_versions_agree() -> None:
    assert PROJECT["project"]["version"] == rpg.__version__
    assert f"## {rpg.__version__}" in (ROOT / "CHANGELOG.md").read_text()
