"""What a worker does with an entry: a family in memory, made in a directory of its own, so that workers never meet."""

from __future__ import annotations

import os
import signal
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from rpg.batch.entries import Entry
from rpg.core.diagnostics import Diagnostic

Status = Literal["admitted", "refused", "failed"]


@dataclass(frozen=True)
class Result:
    """What became of an entry. `tree`: the family's files by path, empty unless admitted; `diagnostics` as data."""

    status: Status
    family: str = ""
    tree: dict[str, bytes] = field(default_factory=dict, repr=False)
    diagnostics: tuple[dict[str, Any], ...] = ()


def warm() -> None:
    """Prepare a worker: import what every entry needs; leave Ctrl-C to the parent."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    import rpg.passes.schema.frontend
    import rpg.steering  # noqa: F401


def build(entry: Entry, pictures: bool) -> Result:
    """Compile an entry and apply its edits. Never raises for what an instruction may contain."""
    from rpg.pipeline import CompileOptions, compile_instruction
    from rpg.publishing import publish
    from rpg.steering import steer
    from rpg.store import Workspace, Written

    options = CompileOptions(name=entry.name, seed=entry.seed, author=entry.author, pictures=pictures)
    with tempfile.TemporaryDirectory(prefix="rpg-", dir=_scratch()) as root:
        outcome = compile_instruction(entry.instruction, options)
        place = publish(outcome, Workspace(Path(root)))
        found = list(outcome.diagnostics)
        if not isinstance(place, Written):
            return Result(outcome.status, diagnostics=_data(found))
        version = place.version
        for edit in entry.edits:
            done = steer(version, edit, options)
            found += done.diagnostics
            if done.version is None:
                return Result("refused" if done.status == "refused" else "failed", diagnostics=_data(found))
            version = done.version
        return Result("admitted", version.family, _tree(version.directory.parent), _data(found))


def _data(diagnostics: list[Diagnostic]) -> tuple[dict[str, Any], ...]:
    return tuple(diagnostic.model_dump(mode="json") for diagnostic in diagnostics)


def _scratch() -> str | None:
    """Memory, where the system offers it: what is made there is copied away at once."""
    return "/dev/shm" if os.access("/dev/shm", os.W_OK) else None


def _tree(directory: Path) -> dict[str, bytes]:
    """Every file of a family by its path inside it."""
    files = sorted(path for path in directory.rglob("*") if path.is_file())
    return {path.relative_to(directory).as_posix(): path.read_bytes() for path in files}
