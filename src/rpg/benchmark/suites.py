"""The suites that ship with the package."""

from __future__ import annotations

from importlib.resources import as_file, files
from typing import Literal

from rpg.batch.entries import Entry, read_entries

Suite = Literal["sessions", "policy", "library"]
SUITES: tuple[Suite, ...] = ("sessions", "policy", "library")


def read_suite(suite: Suite) -> tuple[Entry, ...]:
    """The entries of a suite, in its order."""
    with as_file(files("rpg.benchmark").joinpath(f"suites/{suite}.yaml")) as path:
        return read_entries([str(path)])
