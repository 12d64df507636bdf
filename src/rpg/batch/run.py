"""A batch from its entries to its report."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from rpg import __version__
from rpg.batch.compare import differences
from rpg.batch.entries import Entry
from rpg.batch.ledger import Ledger, Made, mujoco_version, read_ledger, record, up_to_date
from rpg.batch.pool import Executor
from rpg.batch.work import Result
from rpg.core.diagnostics import UsageError
from rpg.store import Workspace
from rpg.store.adopt import adopt
from rpg.store.write import make_root

SAVE_EVERY = 25
"""Entries between two writings of the ledger."""


@dataclass(frozen=True)
class Line:
    """One entry in the report.

    `outcome`: "current" (nothing to do), "built", "same" (rebuilt aside to the same bytes), "differs", "refused",
    "failed". `detail`: what differs, or why not.
    """

    entry: Entry
    outcome: str
    family: str = ""
    detail: str = ""
    diagnostics: tuple[dict[str, Any], ...] = ()

    @property
    def good(self) -> bool:
        return self.outcome in ("current", "built", "same")


@dataclass
class Report:
    """Every entry's line, in the order of the lists. `upgraded`: the versions that changed since the last batch."""

    lines: list[Line] = field(default_factory=list)
    upgraded: str = ""

    def count(self, outcome: str) -> int:
        return sum(line.outcome == outcome for line in self.lines)

    @property
    def good(self) -> bool:
        return all(line.good for line in self.lines)


Listener = Callable[[Line], None]


def run_batch(
    entries: tuple[Entry, ...],
    workspace: Workspace,
    executor: Executor,
    *,
    pictures: bool = True,
    check: bool = False,
    listen: Listener = lambda line: None,
) -> Report:
    """Bring a workspace up to date with `entries`; with `check`, build them aside and say what differs.

    Families are put in place one by one in the order of the lists, so that names do not depend on who was faster, and
    what is finished stays when the batch is interrupted.
    """
    if not check:
        make_root(workspace)
    ledger = read_ledger(workspace)
    upgraded = _upgrade(ledger)
    trusted = not (check or upgraded)
    current = {e.place for e in entries if trusted and up_to_date(workspace, ledger.entries.get(e.digest), pictures)}
    results = executor.map([(entry, pictures and not check) for entry in entries if entry.place not in current])
    keeper = _Keeper(workspace, ledger, pictures)
    report = Report(upgraded=upgraded)
    try:
        for entry in entries:
            if entry.place in current:
                line = _unchanged(entry, ledger.entries[entry.digest])
            elif check:
                line = _compared(entry, next(results), workspace, ledger)
            else:
                line = keeper.keep(entry, next(results))
            report.lines.append(line)
            listen(line)
    finally:
        keeper.save()
    return report


class _Keeper:
    """Puts results into the workspace and remembers them in the ledger, every so often."""

    def __init__(self, workspace: Workspace, ledger: Ledger, pictures: bool) -> None:
        self.workspace, self.ledger, self.pictures = workspace, ledger, pictures
        self.made: dict[str, Made] = {}

    def keep(self, entry: Entry, result: Result) -> Line:
        line, made = self._kept(entry, result)
        if made is not None:
            self.made[entry.digest] = made
        if len(self.made) >= SAVE_EVERY:
            self.save()
        return line

    def _kept(self, entry: Entry, result: Result) -> tuple[Line, Made | None]:
        if result.status != "admitted":
            made = Made(status=result.status, title=entry.title, diagnostics=result.diagnostics)
            return Line(entry, result.status, detail=_reason(result.diagnostics), diagnostics=result.diagnostics), made
        name = entry.name or result.family
        try:
            place = adopt(
                self.workspace,
                name,
                result.tree,
                explicit=entry.name is not None,
                replaceable=self.ledger.versions_of(name) if entry.name else (),
            )
        except UsageError as error:
            return Line(entry, "failed", detail=str(error)), None
        versions = tuple(sorted({path.split("/")[0] for path in result.tree if "/" in path}))
        made = Made(
            status="admitted", title=entry.title, family=place.family.name, versions=versions, pictures=self.pictures
        )
        return Line(entry, "built", place.family.name, diagnostics=result.diagnostics), made

    def save(self) -> None:
        if self.made:
            self.ledger = record(self.workspace, self.made)
            self.made = {}


def _unchanged(entry: Entry, made: Made) -> Line:
    outcome = "current" if made.status == "admitted" else made.status
    return Line(entry, outcome, made.family, _reason(made.diagnostics), made.diagnostics)


def _compared(entry: Entry, result: Result, workspace: Workspace, ledger: Ledger) -> Line:
    """What a rebuild of an entry and the workspace say of each other."""
    before = ledger.entries.get(entry.digest)
    if result.status != "admitted":
        if before is None or before.status == result.status:
            return Line(entry, result.status, detail=_reason(result.diagnostics), diagnostics=result.diagnostics)
        return Line(entry, "differs", before.family, f"was {before.status}, is {result.status} now")
    name = before.family if before and before.family else entry.name or result.family
    found = differences(workspace.family(name), result.tree)
    return Line(entry, "differs" if found else "same", name, found)


def _upgrade(ledger: Ledger) -> str:
    """Which versions have changed since the ledger was written; empty for none."""
    pairs = [("rpg", ledger.rpg, __version__), ("MuJoCo", ledger.mujoco, mujoco_version())]
    return ", ".join(f"{what} {old} -> {new}" for what, old, new in pairs if old != new)


def _reason(diagnostics: tuple[dict[str, Any], ...]) -> str:
    errors = [d for d in diagnostics if d.get("severity") == "error"]
    return str((errors or [{}])[0].get("message", ""))
