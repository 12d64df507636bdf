"""What snapshot.json holds: the snapshot of a task, how it was steered, and the hashes that protect both."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import Any, Literal

from pydantic import Field, model_validator

from rpg.core.digest import digest_of
from rpg.ir.base import Record

FORMAT: Literal[1] = 1
SOURCE = "task.yaml"
CODE = "code.py"
GOAL_CODE = "goal_state_code.py"
LOG = "validation.log"
HASHED = (SOURCE, CODE, GOAL_CODE, LOG)
"""The files of a version whose hashes its snapshot records."""
SNAPSHOT = "snapshot.json"
PICTURES = ("initial.png", "goal.png")
"""Drawn for people; they depend on the machine's graphics, so that no hash covers them."""

UNSEEN = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")
"""What a terminal would obey instead of showing it; no text of a version has any."""

Intent = Literal["TWEAK", "EXTEND", "MODIFY", "PIVOT", "FRESH"]
Digest = Field(pattern=r"^[0-9a-f]{64}$")


class TaskSnapshot(Record):
    """What later requests look a version up by. `code_hash` is the SHA-256 of code.py."""

    version_id: int = Field(ge=0)
    description: str
    assets_used: tuple[str, ...]
    goal_summary: str
    code_hash: str = Digest


class SteeringMeta(Record):
    """How a version came about: the request, what was read out of it, and the hash of the version it was made from.

    `edits` are the typed edits (`rpg.ir.edits`) that turn that version's task into this one; `proof` says what they
    preserved.
    """

    request: str
    intent: Intent
    parameters: dict[str, Any] = Field({})
    reference: int | None = None
    preserve_assets: bool = False
    preserve_positions: bool = False
    preserve_goals: bool = False
    parent: str = Digest
    edits: tuple[dict[str, Any], ...] = ()
    proof: dict[str, Any] = Field({})


class Snapshot(Record):
    """The contents of snapshot.json. `backend` is what wrote the code: "lower" regenerates it from task.yaml."""

    format: Literal[1] = FORMAT
    hash: str = Digest
    snapshot: TaskSnapshot
    backend: Literal["lower", "llm"] = "lower"
    steering: SteeringMeta | None = None
    files: dict[str, str]

    @model_validator(mode="after")
    def _shows_all_it_says(self) -> Snapshot:
        found = next((match for text in _texts(self.model_dump()) if (match := UNSEEN.search(text))), None)
        if found is not None:
            raise ValueError(f"there is a control character (U+{ord(found[0]):04X}) in a text")
        return self

    @property
    def parent(self) -> str | None:
        """Hash of the version this one was steered from; None for a base."""
        return self.steering.parent if self.steering else None

    def expected_hash(self) -> str:
        """The snapshot hash that the contents call for.

        It covers the files' hashes, the parent's hash and the steering metadata, and the description of the task. The
        version's number is left out: the same change of the same parent is the same snapshot.
        """
        record = self.snapshot.model_dump(mode="json", exclude={"version_id"})
        steering = self.steering.model_dump(mode="json") if self.steering else None
        files = dict(self.files) | {SNAPSHOT: digest_of({"backend": self.backend, "snapshot": record})}
        return digest_of({"files": files, "parent": self.parent, "steering": steering})

    def text(self) -> str:
        """snapshot.json, always the same bytes for the same contents."""
        return json.dumps(self.model_dump(mode="json"), indent=2, ensure_ascii=False) + "\n"


def _texts(data: Any) -> Iterator[str]:
    """Every text in a record, keys included."""
    if isinstance(data, str):
        yield data
    elif isinstance(data, dict):
        for key, value in data.items():
            yield str(key)
            yield from _texts(value)
    elif isinstance(data, list | tuple):
        for item in data:
            yield from _texts(item)


def seal(snapshot: TaskSnapshot, files: dict[str, str], steering: SteeringMeta | None, backend: str) -> Snapshot:
    """A snapshot with its hash filled in. `files` maps the names of the version's files to their SHA-256."""
    blank = Snapshot.model_validate(
        {
            "hash": "0" * 64,
            "snapshot": snapshot,
            "backend": backend,
            "steering": steering,
            "files": dict(sorted(files.items())),
        }
    )
    return blank.model_copy(update={"hash": blank.expected_hash()})
