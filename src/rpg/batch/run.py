"""A batch from its entries to its report."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import closing, suppress

from rpg.batch.compare import differences
from rpg.batch.entries import Entry
from rpg.batch.keeper import Keeper
from rpg.batch.ledger import Ledger, Made, read_ledger, up_to_date, upgraded
from rpg.batch.lines import Line, Report, ended
from rpg.batch.pool import Executor
from rpg.batch.work import Result
from rpg.core.diagnostics import UsageError
from rpg.store import Workspace
from rpg.store.write import make_root

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
    news = upgraded(ledger)
    trusted = not (check or news)
    current = [trusted and up_to_date(workspace, ledger.entries.get(e.digest), pictures) for e in entries]
    stale = [entry for entry, done in zip(entries, current, strict=True) if not done]
    results = executor.map([(entry, pictures and not check) for entry in stale])
    report = Report(upgraded=news)
    lines = (
        _checked(entries, results, workspace, ledger)
        if check
        else _kept(entries, results, current, workspace, ledger, pictures)
    )
    with closing(results), closing(lines):
        for line in lines:
            report.lines.append(line)
            listen(line)
    return report


def _checked(
    entries: tuple[Entry, ...], results: Generator[Result, None, None], workspace: Workspace, ledger: Ledger
) -> Generator[Line, None, None]:
    return (_compared(entry, result, workspace, ledger) for entry, result in zip(entries, results, strict=True))


def _kept(
    entries: tuple[Entry, ...],
    results: Generator[Result, None, None],
    current: list[bool],
    workspace: Workspace,
    ledger: Ledger,
    pictures: bool,
) -> Generator[Line, None, None]:
    keeper = Keeper(workspace, ledger, pictures)
    try:
        for entry, done in zip(entries, current, strict=True):
            if done:
                yield from keeper.say(_unchanged(entry, ledger.entries[entry.digest]))
            else:
                yield from keeper.keep(entry, next(results))
        yield from keeper.finish()
    except OSError as error:
        raise UsageError(
            f"cannot write to {workspace.root}: {error.strerror}; what was finished is in place"
        ) from error
    finally:
        with suppress(OSError):
            keeper.close()


def _unchanged(entry: Entry, made: Made) -> Line:
    if made.status != "admitted":
        return ended(entry, made.status, made.diagnostics, made.turn, made.rejected)
    return Line(entry, "current", made.family)


def _compared(entry: Entry, result: Result, workspace: Workspace, ledger: Ledger) -> Line:
    """What a rebuild of an entry and the workspace say of each other."""
    before = ledger.entries.get(entry.digest)
    if result.status != "admitted":
        if before is None or before.status == result.status:
            return ended(entry, result.status, result.diagnostics, result.turn)
        return Line(entry, "differs", before.family, f"was {before.status}, is {result.status} now")
    name = before.family if before and before.family else entry.name or result.family
    found = differences(workspace.family(name), result.tree)
    return Line(entry, "differs" if found else "same", name, found)
