"""Any change to a workspace is found, and what is found is the change."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from rpg.core.codes import CODES
from rpg.store import (
    Family,
    Snapshot,
    SteeringMeta,
    Version,
    Workspace,
    verify_family,
    verify_lineage,
    write_base,
    write_version,
)
from rpg.store.layout import version_name
from rpg.store.records import PICTURES

from .conftest import lowered, make_content, make_schema
from .pictures import PNG


@pytest.fixture
def family(workspace: Workspace) -> Family:
    base = write_base(workspace, "red-on-blue", make_content(pictures=dict.fromkeys(PICTURES, PNG))).version
    found = workspace.family("red-on-blue")
    meta = SteeringMeta(request="make it green", intent="TWEAK", reference=0, parent=base.hash, parameters={"n": 1.5})
    write_version(found, make_content(steering=meta))
    return found


def codes(family: Family) -> set[str]:
    found = verify_family(family, lowered)
    assert all(problem.code in CODES for problem in found)
    assert all(problem.severity == "error" for problem in found)
    return {problem.code for problem in found}


def test_an_untouched_family_is_sound(family: Family) -> None:
    assert codes(family) == set()


def test_every_flipped_byte_is_found(family: Family) -> None:
    files = [family.directory / "HEAD", *(p for p in family.directory.rglob("*") if p.parent != family.directory)]
    for path in sorted(files):
        whole = path.read_bytes()
        for at in range(0, len(whole), 7):
            path.write_bytes(whole[:at] + bytes([whole[at] ^ 1]) + whole[at + 1 :])
            assert codes(family), f"{path.name}, byte {at}"
        path.write_bytes(whole)
    assert codes(family) == set()


@pytest.mark.parametrize("name", ["task.yaml", "code.py", "goal_state_code.py", "validation.log"])
def test_a_hand_edited_file_is_named(family: Family, name: str) -> None:
    path = family.head().directory / name
    path.write_bytes(path.read_bytes() + b"\n")
    (problem,) = verify_family(family, lowered)
    assert problem.code == "file-changed"
    assert name in problem.message and problem.facts["path"].endswith(name)


@pytest.mark.parametrize("name", ["task.yaml", "snapshot.json"])
def test_a_missing_file_is_named(family: Family, name: str) -> None:
    (family.head().directory / name).unlink()
    found = verify_family(family, lowered)
    assert any(problem.code == "version-incomplete" and name in problem.message for problem in found)


def test_a_missing_parent(family: Family) -> None:
    shutil.rmtree(family.versions()[0].directory)
    assert codes(family) == {"parent-missing"}


def test_a_renamed_version(family: Family) -> None:
    head = family.head().directory
    head.rename(head.with_name("v5-0123456"))
    assert codes(family) == {"snapshot-changed", "head-broken"}


def test_a_copied_version(family: Family) -> None:
    head = family.head().directory
    shutil.copytree(head, head.with_name("v1-abcdef0"))
    assert {"number-clash", "snapshot-changed"} <= codes(family)


def test_a_forged_file_with_its_hash_in_the_snapshot(family: Family) -> None:
    directory = family.head().directory
    _forge(directory, "code.py", b"print('other')\n")
    assert {"snapshot-changed", "does-not-lower"} == codes(family)


def _forge(directory: Path, name: str, data: bytes) -> None:
    from rpg.core.digest import sha256

    (directory / name).write_bytes(data)
    snapshot = json.loads((directory / "snapshot.json").read_text())
    snapshot["files"][name] = sha256(data)
    (directory / "snapshot.json").write_text(json.dumps(snapshot, indent=2) + "\n")


def test_a_head_that_leads_nowhere(family: Family) -> None:
    (family.directory / "HEAD").write_text("v9-0000000\n")
    (problem,) = verify_family(family)
    assert problem.code == "head-broken"
    assert problem.hint == "rpg checkout red-on-blue 1"


def test_a_damaged_picture(family: Family) -> None:
    path = family.versions()[0].directory / "goal.png"
    path.write_bytes(path.read_bytes()[:-1])
    assert codes(family) == {"picture-damaged"}


def test_code_that_its_schema_no_longer_gives(family: Family) -> None:
    found = verify_family(family, lambda version: False)
    assert {problem.code for problem in found} == {"does-not-lower"}
    assert len(found) == 2


def test_an_origin_that_nothing_speaks_for_is_reported(workspace: Workspace) -> None:
    write_base(workspace, "by-model", make_content(make_schema(), backend="llm"))
    (problem,) = verify_family(workspace.family("by-model"), lambda version: False)
    assert problem.code == "origin-unsupported"
    assert "a model wrote code.py" in problem.message


def reseal(version: Version, **steering: object) -> Path:
    """A forged version: its steering record changed, every hash made to fit again."""
    data = json.loads((version.directory / "snapshot.json").read_text())
    data["steering"] |= steering
    blank = Snapshot.model_validate(data)
    sealed = blank.model_copy(update={"hash": blank.expected_hash()})
    (version.directory / "snapshot.json").write_text(sealed.text())
    directory = version.directory.with_name(version_name(version.number, sealed.hash))
    (version.directory.parent / "HEAD").write_text(directory.name + "\n")
    return version.directory.rename(directory)


def test_edits_that_lead_elsewhere_are_reported(family: Family) -> None:
    asked: list[tuple[int, int]] = []

    def replayed(version: Version, parent: Version) -> bool:
        asked.append((version.number, parent.number))
        return False

    (problem,) = verify_family(family, lowered, replayed)
    assert problem.code == "does-not-replay" and "from version 0" in problem.message
    assert asked == [(1, 0)]


def test_a_reference_that_is_not_the_parent_is_reported(family: Family) -> None:
    reseal(family.head(), reference=5)
    (problem,) = verify_family(family, lowered)
    assert problem.code == "does-not-replay" and "version 5" in problem.message


@pytest.mark.parametrize("hidden", ["\x1b[2K", "\r", "\u202e", "\x9b1A"])
def test_texts_that_a_terminal_would_obey_are_damage(family: Family, hidden: str) -> None:
    path = family.head().directory / "snapshot.json"
    data = json.loads(path.read_text())
    data["steering"]["request"] += hidden
    path.write_text(json.dumps(data))
    (problem,) = verify_family(family, lowered)
    assert problem.code == "snapshot-unreadable" and "control character" in problem.message
    assert hidden not in problem.message


def test_a_lineage_is_as_good_as_its_worst_ancestor(family: Family) -> None:
    base, head = family.versions()
    assert verify_lineage(head) == ()
    path = base.directory / "task.yaml"
    whole = path.read_bytes()
    path.write_bytes(whole + b"\n")
    (problem,) = verify_lineage(head)
    assert problem.code == "file-changed" and base.directory.name in problem.message
    path.write_bytes(whole)
    shutil.rmtree(base.directory)
    (problem,) = verify_lineage(head)
    assert problem.code == "parent-missing" and base.short_hash in problem.message
