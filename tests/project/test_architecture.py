"""Which room may import which, what starting the command line loads, and how long files and functions are."""

from __future__ import annotations

import ast
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "src" / "rpg"
FILES = sorted(PACKAGE.rglob("*.py"))

BASE = {"core", "ir", "blocks"}
MEETING = {path.stem for path in PACKAGE.glob("*.py")} | {"batch", "benchmark", "gallery"}
"""Where everything meets: these may import every room but the command line."""
MAY_IMPORT: dict[str, set[str]] = {
    "core": set(),
    "ir": {"core"},
    "blocks": {"core", "ir"},
    "env": BASE,
    "llm": {"core"},
    "language": BASE,
    "passes.schema": BASE | {"language", "llm"},
    "passes.codegen": BASE | {"llm"},
    "passes.validate": BASE | {"env"},
    "passes.repair": BASE | {"llm"},
    "steer": BASE | {"language", "llm"},
    "store": {"core", "ir"},
    "evaluate": BASE | {"env", "store"},
    "cli": {"core", "ir", "store", "steer", "evaluate"} | MEETING,
}
"""Rooms, and the rooms besides itself that each may import. Edits share the grammar of instructions."""
OUTSIDE: dict[str, set[str]] = {
    "core": {"pydantic"},
    "ir": {"pydantic"},
    "llm": {"pydantic", "litellm"},
    "store": {"pydantic", "pydantic_core", "yaml", "networkx"},
    "cli": {"typer", "rich", "mujoco"},
}
"""Packages that rooms may import, where that is limited."""
MAX_FILE, MAX_FUNCTION = 400, 60


def room(module: str) -> str:
    """The room of a module `rpg.…`: its first part, or two for the passes."""
    parts = module.split(".")[1:]
    return ".".join(parts[:2]) if parts[:1] == ["passes"] else (parts or [""])[0]


def module_of(path: Path) -> str:
    parts = path.relative_to(PACKAGE.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


class Outline(NamedTuple):
    """The modules that a file imports, and how long its functions are."""

    imports: list[str]
    lengths: list[tuple[str, int]]


@cache
def outline(path: Path) -> Outline:
    """Each file is parsed once, and not all of it is kept."""
    found = Outline([], [])
    inner: list[ast.AST] = [ast.parse(path.read_text())]
    for node in inner:  # expressions are passed over: nothing is imported or defined in them
        inner += [below for below in ast.iter_child_nodes(node) if not isinstance(below, ast.expr)]
        if isinstance(node, ast.Import):
            found.imports.extend(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: write imports in full"
            inside = [f"rpg.{alias.name}" for alias in node.names if node.module == "rpg" and is_module(alias.name)]
            found.imports.extend(inside or [str(node.module)])
        elif isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            found.lengths.append((node.name, (node.end_lineno or 0) - node.lineno + 1))
    return found


def is_module(name: str) -> bool:
    """Whether `rpg` has a module or a room of that name."""
    return (PACKAGE / name).is_dir() or (PACKAGE / f"{name}.py").is_file()


ROOMS = sorted({room(module_of(path)) for path in FILES})


def files_of(own: str) -> list[Path]:
    """The files of a room."""
    return [path for path in FILES if room(module_of(path)) == own]


@pytest.mark.parametrize("own", ROOMS)
def test_imports_point_one_way(own: str) -> None:
    rooms = MAY_IMPORT.get(own, set(MAY_IMPORT) | MEETING - {"cli"})
    for path in files_of(own):
        for imported in outline(path).imports:
            if imported.split(".")[0] == "rpg":
                assert room(imported) in rooms | {own, ""}, f"{path} must not import {imported}"
            elif own in OUTSIDE and imported.split(".")[0] not in sys.stdlib_module_names:
                assert imported.split(".")[0] in OUTSIDE[own], f"{path} must not import {imported}"


def test_every_room_has_its_rule() -> None:
    rooms = {room(module_of(path)) for path in FILES if path.parent != PACKAGE}
    assert rooms - {"passes"} <= set(MAY_IMPORT) | MEETING


HEAVY = ("mujoco", "numpy", "pydantic", "litellm", "networkx", "gymnasium", "yaml", "rich")


def loaded_after(code: str) -> set[str]:
    script = f"import sys\n{code}\nprint(*sorted(m for m in sys.modules if '.' not in m))"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    return set(done.stdout.splitlines()[-1].split())


@pytest.mark.parametrize(
    "code",
    [
        "import rpg",
        "import rpg.cli.main",
        "from rpg.cli.main import run\nassert run(['--help']) == 0",
    ],
)
def test_starting_up_loads_nothing_heavy(code: str) -> None:
    assert not loaded_after(code) & set(HEAVY)


def test_help_of_a_command_does_not_load_what_the_command_needs() -> None:
    loaded = loaded_after("from rpg.cli.main import COMMANDS, run\nfor c in COMMANDS: assert run([c, '--help']) == 0")
    assert not loaded & {"mujoco", "numpy", "litellm", "networkx", "gymnasium", "yaml"}


def test_work_without_a_model_does_not_load_one() -> None:
    assert "litellm" not in loaded_after("import rpg.pipeline, rpg.loading, rpg.store")


@pytest.mark.parametrize("own", ROOMS)
def test_files_and_functions_stay_short(own: str) -> None:
    for path in files_of(own):
        assert len(path.read_text().splitlines()) <= MAX_FILE, path
        for name, length in outline(path).lengths:
            assert length <= MAX_FUNCTION, f"{path}: {name} has {length} lines"
