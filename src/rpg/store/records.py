"""What snapshot.json holds: the snapshot of a task, how it was steered, and the hashes that protect both."""

from __future__ import annotations

import json
from typing import Any, Literal

from pydantic import Field

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
