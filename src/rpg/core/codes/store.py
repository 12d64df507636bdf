"""Codes reported when a workspace is verified."""

from __future__ import annotations

from rpg.core.codes.base import Code

CODES: tuple[Code, ...] = (
    Code(
        "version-incomplete",
        "a file of a version is missing",
        "A version holds task.yaml, code.py, goal_state_code.py, validation.log and snapshot.json. One of them is not "
        "there any more, so that the version cannot be trusted.",
        "rm tasks/red-on-blue/v0-*/code.py",
    ),
    Code(
        "file-changed",
        "a file differs from its recorded hash",
        "snapshot.json records the SHA-256 of every file of the version. This file was edited or damaged after it was "
        "written. To make a task of an edited task.yaml, compile from it.",
        "edit tasks/red-on-blue/v0-*/task.yaml",
        "rpg compile --from tasks/red-on-blue/v0-*/task.yaml --name red-on-blue-edited",
    ),
    Code(
        "snapshot-unreadable",
        "snapshot.json cannot be read",
        "The snapshot is not valid JSON, lacks a field, or has one of the wrong type.",
    ),
    Code(
        "snapshot-changed",
        "the snapshot does not have the hash in its directory's name",
        "A version's directory carries the first seven digits of its snapshot hash, which covers the hashes of the "
        "files, the parent's hash and the steering metadata. One of these was changed, or the directory was renamed.",
    ),
    Code(
        "picture-damaged",
        "a picture of a version is damaged",
        "Pictures depend on the machine's graphics and are not hashed; their own checksums show that bytes changed.",
        "truncate -s -1 tasks/red-on-blue/v0-*/goal.png",
        "rpg render red-on-blue",
    ),
    Code(
        "parent-missing",
        "the version that this one came from is missing",
        "A steered version names its parent by its hash, and no version of the family has that hash any more.",
    ),
    Code(
        "origin-unsupported",
        "the version's origin is claimed, not recorded",
        "A snapshot says what wrote the code. Code that the code generator wrote is generated again to be checked; "
        "what a model wrote can only be believed where its answers are recorded, and a workspace records none. "
        "The code runs confined, if it passes every gate; nothing is built upon it.",
        remedy="rpg compile --from tasks/red-on-blue/v0-*/task.yaml --name red-on-blue-2",
    ),
    Code(
        "does-not-replay",
        "the recorded edits do not lead to the version",
        "A steered version records the typed edits that made it from its parent. Applied to the parent again, they "
        "gave another task.yaml: the steering record, the parent or the task was forged, or edits mean something else "
        "in this version of rpg.",
    ),
    Code(
        "number-clash",
        "two versions of a family have the same number",
        "Version numbers are given out once under a lock; a clash means that directories were copied or renamed.",
    ),
    Code(
        "head-broken",
        "HEAD does not name a version of the family",
        "HEAD holds the directory name of the current version. It is missing or names a directory that is not there.",
        "echo nowhere > tasks/red-on-blue/HEAD",
        "rpg checkout red-on-blue 0",
    ),
    Code(
        "does-not-lower",
        "task.yaml no longer gives the code beside it",
        "The code of a version is generated from its task.yaml. Generating it again gave other bytes: the generator "
        "has changed since, or code and schema do not belong together.",
    ),
    Code(
        "schema-unreadable",
        "task.yaml cannot be read",
        "The file is not valid YAML or does not describe a task; the message names the line and what is wrong there.",
    ),
)
