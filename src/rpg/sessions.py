"""Sessions: a base instruction and the edits that follow it, each turn a version of one family."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import yaml

from rpg.core.diagnostics import Diagnostic, UsageError
from rpg.pipeline import CompileOptions, Outcome, compile_instruction
from rpg.publishing import publish, summary
from rpg.steering import Steered, steer, steered_summary
from rpg.store import Version, Workspace, Written

STATUS = {"admitted": 0, "failed": 1, "refused": 3}


@dataclass(frozen=True)
class Session:
    """A base instruction and its edits, under a name that the family takes over (made up where it is None)."""

    name: str | None
    base: str
    edits: tuple[str, ...] = ()


@dataclass(frozen=True)
class Turn:
    """One turn of a session: the compile of its base, or a steer."""

    text: str
    base: Outcome | None = None
    place: Written | Path | None = None
    steered: Steered | None = None

    @property
    def status(self) -> str:
        """One of "admitted", "refused" and "failed"."""
        return self.base.status if self.base else self.steered.status if self.steered else "refused"

    @property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """What there is to say about the turn."""
        return self.base.diagnostics if self.base else self.steered.diagnostics if self.steered else ()

    @property
    def exit_status(self) -> int:
        return STATUS[self.status]

    @property
    def version(self) -> Version | None:
        """The version that is current after the turn, if it succeeded."""
        if self.steered:
            return self.steered.version
        return self.place.version if isinstance(self.place, Written) else None

    def document(self) -> dict[str, Any]:
        """The turn as a JSON document."""
        told = summary(self.base, self.place) if self.base else steered_summary(self.steered) if self.steered else {}
        return {"text": self.text, **told}


def read_sessions(file: Path) -> tuple[Session, ...]:
    """The sessions of a YAML file: a mapping with `sessions`, a list, or a single one."""
    try:
        data = yaml.safe_load(file.read_text(encoding="utf-8"))
    except OSError as error:
        raise UsageError(f"cannot read {file}: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise UsageError(f"{file} is not UTF-8 text") from error
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        place = f" in line {mark.line + 1}" if mark else ""
        raise UsageError(f"{file} is not valid YAML{place}: {getattr(error, 'problem', error)}") from error
    except RecursionError as error:
        raise UsageError(f"{file} is nested too deeply for sessions") from error
    entries = data.get("sessions", data) if isinstance(data, dict) else data
    entries = [entries] if isinstance(entries, dict) else entries
    if not isinstance(entries, list) or not entries:
        raise UsageError(f"{file} has no sessions; each has `name`, `base` and a list of `edits`")
    return tuple(_session(file, number, entry) for number, entry in enumerate(entries, 1))


def _session(file: Path, number: int, entry: Any) -> Session:
    if not isinstance(entry, dict) or not isinstance(entry.get("base"), str):
        raise UsageError(f"{file}: session {number} has no `base`, the instruction that it begins with")
    unknown = sorted(set(entry) - {"name", "base", "edits"})
    if unknown:
        raise UsageError(f"{file}: session {number} has an unknown key {unknown[0]!r}; it may have name, base, edits")
    edits = entry.get("edits") or []
    if not isinstance(edits, list) or not all(isinstance(edit, str) for edit in edits):
        raise UsageError(f"{file}: the `edits` of session {number} are not a list of sentences")
    name = entry.get("name")
    if not isinstance(name, str | int | None):
        raise UsageError(f"{file}: the `name` of session {number} is not a word or a few")
    return Session(str(name) if name else None, entry["base"], tuple(edits))


def run_session(
    session: Session, workspace: Workspace, options: CompileOptions | None = None, *, keep_going: bool = False
) -> Iterator[Turn]:
    """Run a session turn by turn. It stops where a turn is refused or fails, unless `keep_going`."""
    options = options or CompileOptions()
    outcome = compile_instruction(session.base, replace(options, name=family_name(session.name or "")))
    place = publish(outcome, workspace)
    yield Turn(session.base, base=outcome, place=place)
    if not isinstance(place, Written):
        return
    version = place.version
    for edit in session.edits:
        done = steer(version, edit, options)
        yield Turn(edit, place=done.place, steered=done)
        if done.version is not None:
            version = done.version
        elif not keep_going:
            return


def family_name(name: str) -> str | None:
    """A session's name as that of a family; None where nothing of it can be in one."""
    words = re.findall(r"[a-z0-9]+", name.lower())
    return "-".join(words)[:60].strip("-") or None
