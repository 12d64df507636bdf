"""rpg.lock: which versions verified a workspace, and what a batch made of each entry, so that nothing is made twice."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any, Literal

from pydantic import Field, ValidationError

from rpg import __version__
from rpg.core.diagnostics import UsageError
from rpg.ir.base import Record
from rpg.store import Workspace, replace_file, verify_family
from rpg.store.disk import locked

LOCKFILE = "rpg.lock"


class Made(Record):
    """What an entry became: the family and its version directories, or the diagnostics of a refusal or failure.

    `pictures`: whether its pictures were drawn. `turn`: the sentence at which it was refused or failed, 0 the first.
    `rejected`: where in the workspace the files are that did not pass.
    """

    status: Literal["admitted", "refused", "failed"]
    title: str
    family: str = ""
    versions: tuple[str, ...] = ()
    pictures: bool = False
    diagnostics: tuple[dict[str, Any], ...] = ()
    turn: int = 0
    rejected: str = ""


class Ledger(Record):
    """The contents of rpg.lock: the versions that verified the workspace, and what they found.

    `entries` are keyed by the digests of the entries; `verdicts`, by snapshot hash, are those of the goals on their
    banks of states (see `rpg.upgrade`).
    """

    format: Literal[1] = 1
    rpg: str = __version__
    mujoco: str
    entries: dict[str, Made] = Field({})
    verdicts: dict[str, str] = Field({})

    def text(self) -> str:
        return json.dumps(self.model_dump(mode="json"), indent=1, sort_keys=True, ensure_ascii=False) + "\n"

    def versions_of(self, family: str) -> frozenset[str]:
        """The version directories that batches have made in `family`."""
        return frozenset(name for made in self.entries.values() if made.family == family for name in made.versions)


def read_ledger(workspace: Workspace) -> Ledger:
    """The workspace's ledger; an empty one where there is none yet."""
    path = workspace.root / LOCKFILE
    try:
        return Ledger.model_validate_json(path.read_bytes())
    except FileNotFoundError:
        return Ledger(mujoco=mujoco_version(), entries={}, verdicts={})
    except OSError as error:
        raise UsageError(f"cannot read {path}: {error.strerror}") from error
    except ValidationError as error:
        raise UsageError(
            f"{path} is damaged ({error.errors()[0]['msg']}); remove it to build everything again"
        ) from error


def record(workspace: Workspace, made: Mapping[str, Made], verdicts: Mapping[str, str]) -> Ledger:
    """Add to the ledger what a batch made, and the versions that verified it. Other batches' entries stay."""
    with locked(workspace):
        before = read_ledger(workspace)
        fresh = {made_now.family for made_now in made.values() if made_now.family}
        kept = {d: old for d, old in before.entries.items() if old.family not in fresh or _there(workspace, old)}
        return _replace(workspace, before, {**kept, **made}, {**before.verdicts, **verdicts})


def confirm(workspace: Workspace, verdicts: Mapping[str, str]) -> Ledger:
    """Note that the installed versions verified all of the workspace, and what its goals were found to judge."""
    with locked(workspace):
        before = read_ledger(workspace)
        return _replace(workspace, before, before.entries, dict(verdicts))


def _replace(workspace: Workspace, before: Ledger, entries: dict[str, Made], verdicts: dict[str, str]) -> Ledger:
    after = Ledger(rpg=__version__, mujoco=mujoco_version(), entries=entries, verdicts=verdicts)
    if after != before or not (workspace.root / LOCKFILE).exists():
        replace_file(workspace.root / LOCKFILE, after.text().encode())
    return after


def _there(workspace: Workspace, made: Made) -> bool:
    """Whether the versions of an entry are in their family still: another entry may have taken its name."""
    return set(made.versions) <= {path.name for path in workspace.family(made.family).directories()}


def up_to_date(workspace: Workspace, made: Made | None, pictures: bool) -> bool:
    """Whether what the ledger says of an entry is still there, byte for byte."""
    if made is None or made.status != "admitted":
        return made is not None
    if not _there(workspace, made) or (pictures and not made.pictures):
        return False
    return not verify_family(workspace.family(made.family))


def upgraded(ledger: Ledger) -> str:
    """Which versions have changed since the ledger was written, for people; empty for none."""
    pairs = [("rpg", ledger.rpg, __version__), ("MuJoCo", ledger.mujoco, mujoco_version())]
    return ", ".join(f"{what} {old} -> {new}" for what, old, new in pairs if old != new)


def mujoco_version() -> str:
    """The version of the installed MuJoCo, without importing it."""
    from importlib.metadata import version

    return version("mujoco")
