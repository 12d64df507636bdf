"""What a worker does with an entry: a family as files in memory, so that workers never meet."""

from __future__ import annotations

import os
import signal
import tempfile
import time
import traceback
from collections.abc import Iterable
from dataclasses import dataclass, field
from multiprocessing import parent_process
from multiprocessing.connection import wait
from pathlib import Path
from threading import Thread
from typing import TYPE_CHECKING, Any, Literal

from rpg.batch.entries import Entry
from rpg.core.diagnostics import Diagnostic, Refusal, UsageError

if TYPE_CHECKING:
    from rpg.pipeline import CompileOptions, Outcome

Status = Literal["admitted", "refused", "failed"]
GRACE = 5.0
"""Seconds in which a worker whose parent was killed may tidy up."""


@dataclass(frozen=True)
class Result:
    """What became of an entry. `diagnostics` as data; `turn`: at which of its sentences it ended, 0 the first.

    `tree`: the family's files by path; of an entry that failed, the files that did not pass; else empty. `verdicts`:
    of its versions' goals, by snapshot hash, for the record. `lasting`: the next build would end alike; what a crash
    or a full disk ended is tried again.
    """

    status: Status
    family: str = ""
    tree: dict[str, bytes] = field(default_factory=dict, repr=False)
    diagnostics: tuple[dict[str, Any], ...] = ()
    verdicts: dict[str, str] = field(default_factory=dict)
    turn: int = 0
    lasting: bool = True


def warm() -> None:
    """Prepare a worker: import what every entry needs; leave Ctrl-C to the parent, and go when the parent is gone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, _end)
    parent = parent_process()
    if parent is not None:
        Thread(target=_follow, args=(parent.sentinel,), daemon=True).start()
    import rpg.batch.preload  # noqa: F401


def _end(signum: int, frame: object) -> None:
    raise SystemExit(128 + signum)


def _follow(sentinel: int) -> None:
    """End this process once the one that `sentinel` stands for was killed: first in order, then at all costs."""
    wait([sentinel])
    os.kill(os.getpid(), signal.SIGTERM)
    time.sleep(GRACE)
    os._exit(1)


def build(entry: Entry, pictures: bool) -> Result:
    """Compile an entry and apply its edits. Nothing that goes wrong with it is raised."""
    try:
        return _built(entry, pictures)
    except Refusal as refusal:
        return Result("refused", diagnostics=_data(refusal.diagnostics))
    except UsageError as error:
        return Result("failed", diagnostics=(_broken("entry-fails", str(error)),))
    except Exception as error:
        frame = traceback.extract_tb(error.__traceback__)[-1]
        where = f"{type(error).__name__} in {Path(frame.filename).name}, line {frame.lineno}: {error}"
        return lost("worker-breaks", f"the process that built this entry broke down: {where}")


def lost(code: str, message: str) -> Result:
    """An entry that came to nothing for no fault of its own."""
    return Result("failed", diagnostics=(_broken(code, message),), lasting=False)


def _broken(code: str, message: str) -> dict[str, Any]:
    return Diagnostic(code=code, message=message, origin="batch").model_dump(mode="json")


def _built(entry: Entry, pictures: bool) -> Result:
    from rpg.pipeline import CompileOptions, compile_instruction
    from rpg.publishing import content_of
    from rpg.store.adopt import base_tree
    from rpg.upgrade import verdicts

    options = CompileOptions(name=entry.name, seed=entry.seed, author=entry.author, pictures=pictures)
    outcome = compile_instruction(entry.instruction, options)
    if outcome.status != "admitted" or outcome.schema is None:
        return _not_admitted(outcome.status, outcome, outcome.diagnostics)
    if entry.edits:
        return _steered(entry, outcome, options)
    content = content_of(outcome)
    assert outcome.program is not None
    record = {content.sealed(0).hash: verdicts(outcome.program)}
    return Result("admitted", outcome.schema.name, base_tree(content), _data(outcome.diagnostics), record)


def _steered(entry: Entry, outcome: Outcome, options: CompileOptions) -> Result:
    """The base with its edits, which need it on disk: in a directory of its own."""
    from rpg.publishing import publish
    from rpg.steering import steer
    from rpg.store import Family, Workspace, Written
    from rpg.upgrade import recorded

    with tempfile.TemporaryDirectory(prefix="rpg-", dir=_scratch()) as root:
        place = publish(outcome, Workspace(Path(root)))
        assert isinstance(place, Written)
        version, found = place.version, list(outcome.diagnostics)
        for turn, edit in enumerate(entry.edits, 1):
            done = steer(version, edit, options)
            if done.version is None:
                status: Status = "refused" if done.status == "refused" else "failed"
                return _not_admitted(status, done.outcome, done.diagnostics, turn)
            found += done.diagnostics
            version = done.version
        family = Family(version.directory.parent)
        record = {version.hash: recorded(version) for version in family.versions()}
        return Result("admitted", family.name, _tree(family.directory), _data(found), record)


def _not_admitted(status: Status, outcome: Outcome | None, found: Iterable[Diagnostic], turn: int = 0) -> Result:
    """A result without a family; what failed comes with its files, to be looked into."""
    from rpg.publishing import files_of

    if status != "failed" or outcome is None or outcome.program is None:
        return Result(status, diagnostics=_data(found), turn=turn)
    return Result(status, outcome.program.task.name, files_of(outcome), _data(found), turn=turn)


def _data(diagnostics: Iterable[Diagnostic]) -> tuple[dict[str, Any], ...]:
    return tuple(diagnostic.model_dump(mode="json") for diagnostic in diagnostics)


def _scratch() -> str | None:
    """Memory, where the system offers it: what is made there is copied away at once."""
    return "/dev/shm" if os.access("/dev/shm", os.W_OK) else None


def _tree(directory: Path) -> dict[str, bytes]:
    """Every file of a family by its path inside it."""
    files = sorted(path for path in directory.rglob("*") if path.is_file())
    return {path.relative_to(directory).as_posix(): path.read_bytes() for path in files}
