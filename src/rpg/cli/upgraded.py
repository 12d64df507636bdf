"""What `rpg verify --all` does once other versions of rpg or MuJoCo are installed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from rpg.cli.output import Output
    from rpg.core.diagnostics import Diagnostic
    from rpg.store import Family, Workspace

Found = dict[str, tuple["Diagnostic", ...]]


def changes(out: Output, workspace: Workspace, families: Sequence[Family], found: Found) -> str:
    """Add to `found`, by family, what an upgrade changed; the versions that changed, empty for none.

    Tasks without a record get one. Where no task means anything else, rpg.lock names the new versions from then on.
    """
    from rpg.batch.ledger import confirm, read_ledger, upgraded
    from rpg.upgrade import differences, recorded

    ledger = read_ledger(workspace)
    news = upgraded(ledger)
    record = dict(ledger.verdicts)
    for family in families:
        if any(problem.severity == "error" and problem.code != "does-not-lower" for problem in found[family.name]):
            continue
        for version in family.versions():
            if news:
                out.asides.print(f"{version}", markup=False)
                found[family.name] += differences(version, record.get(version.hash))
            if version.hash not in record:
                record[version.hash] = recorded(version)
    if not any(problem.severity == "error" for problems in found.values() for problem in problems):
        confirm(workspace, record)
    return news
