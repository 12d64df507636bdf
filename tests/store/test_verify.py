"""Any change to a workspace is found, and what is found is the change."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from rpg.core.codes import CODES
from rpg.store import Family, SteeringMeta, Version, Workspace, verify_family, write_base, write_version
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


def test_code_of_a_model_is_not_expected_to_lower(workspace: Workspace) -> None:
    content = make_content(make_schema(), backend="llm")
    version: Version = write_base(workspace, "by-model", content).version
    assert not verify_family(workspace.family("by-model"), lambda version: False)
    assert version.snapshot.backend == "llm"
