"""Versions appear whole or not at all, once, and with the same bytes."""

from __future__ import annotations

import errno
import json
import re

import pytest

from rpg.core.diagnostics import UsageError
from rpg.store import SteeringMeta, Version, Workspace, resolve, set_head, verify_family, write_base
from rpg.store.records import PICTURES
from rpg.store.write import write_rejected, write_version

from .conftest import make_content, make_schema
from .pictures import PNG


def steered(parent: Version, request: str = "add a green block") -> SteeringMeta:
    return SteeringMeta(request=request, intent="EXTEND", reference=parent.number, parent=parent.hash)


def test_layout_is_the_promised_one(workspace: Workspace) -> None:
    version = write_base(workspace, "red-on-blue", make_content(pictures=dict.fromkeys(PICTURES, PNG))).version
    assert re.fullmatch(r"v0-[0-9a-f]{7}", version.directory.name)
    assert version.directory.parent == workspace.root / "red-on-blue"
    names = {path.name for path in version.directory.iterdir()}
    assert names == {
        "task.yaml", "code.py", "goal_state_code.py", "validation.log", "snapshot.json", "initial.png", "goal.png"
    }  # fmt: skip
    assert (workspace.root / "red-on-blue" / "HEAD").read_text() == version.directory.name + "\n"
    snapshot = json.loads((version.directory / "snapshot.json").read_text())
    assert set(snapshot["snapshot"]) == {"version_id", "description", "assets_used", "goal_summary", "code_hash"}
    assert snapshot["steering"] is None
    assert snapshot["hash"].startswith(version.directory.name[3:])


def test_same_task_is_found_again(workspace: Workspace) -> None:
    first = write_base(workspace, "red-on-blue", make_content())
    again = write_base(workspace, "red-on-blue", make_content())
    assert not first.existed and again.existed
    assert first.version.directory == again.version.directory
    assert len(list((workspace.root / "red-on-blue").iterdir())) == 2


def test_pictures_are_added_to_a_version_without_them(workspace: Workspace) -> None:
    write_base(workspace, "red-on-blue", make_content())
    again = write_base(workspace, "red-on-blue", make_content(pictures={"goal.png": PNG}))
    assert again.existed
    assert (again.version.directory / "goal.png").read_bytes() == PNG
    assert not verify_family(workspace.family("red-on-blue"))


def test_pictures_do_not_change_the_hash(workspace: Workspace) -> None:
    plain = make_content().sealed(0)
    assert make_content(pictures={"goal.png": PNG}).sealed(0) == plain


def test_other_task_of_the_same_name_gets_the_next_one(workspace: Workspace) -> None:
    write_base(workspace, "red-on-blue", make_content())
    other = make_content(make_schema(instruction="Place red on blue"))
    second = write_base(workspace, "red-on-blue", other)
    assert second.version.family == "red-on-blue-2"
    assert write_base(workspace, "red-on-blue", other).version.directory == second.version.directory
    third = write_base(workspace, "red-on-blue", make_content(make_schema(instruction="red goes onto blue")))
    assert third.version.family == "red-on-blue-3"


def test_chosen_name_that_is_taken_is_an_error(workspace: Workspace) -> None:
    write_base(workspace, "mine", make_content(), explicit=True)
    assert write_base(workspace, "mine", make_content(), explicit=True).existed
    with pytest.raises(UsageError, match="another task called 'mine'"):
        write_base(workspace, "mine", make_content(make_schema(instruction="other")), explicit=True)


def test_an_unrelated_directory_is_left_alone(workspace: Workspace) -> None:
    (workspace.root / "red-on-blue").mkdir(parents=True)
    (workspace.root / "red-on-blue" / "notes.txt").write_text("mine")
    assert write_base(workspace, "red-on-blue", make_content()).version.family == "red-on-blue-2"


def test_an_empty_directory_is_used(workspace: Workspace) -> None:
    (workspace.root / "red-on-blue").mkdir(parents=True)
    assert write_base(workspace, "red-on-blue", make_content()).version.family == "red-on-blue"


def test_versions_are_numbered_and_head_follows(workspace: Workspace) -> None:
    base = write_base(workspace, "red-on-blue", make_content()).version
    family = workspace.family("red-on-blue")
    first = write_version(family, make_content(steering=steered(base))).version
    sibling = write_version(family, make_content(steering=steered(base, "another edit"))).version
    assert [v.number for v in family.versions()] == [0, 1, 2]
    assert family.head() == sibling
    set_head(first)
    assert family.head() == first
    assert not verify_family(family)
    assert resolve(workspace, "red-on-blue").number == 1


def test_same_edit_of_the_same_parent_is_found_again(workspace: Workspace) -> None:
    base = write_base(workspace, "red-on-blue", make_content()).version
    family = workspace.family("red-on-blue")
    first = write_version(family, make_content(steering=steered(base)))
    set_head(base)
    again = write_version(family, make_content(steering=steered(base)))
    assert again.existed and again.version == first.version
    assert family.head() == first.version


def test_what_a_killed_writer_left_is_ignored_and_swept(workspace: Workspace) -> None:
    write_base(workspace, "red-on-blue", make_content())
    for place in (workspace.root, workspace.root / "red-on-blue"):
        (place / ".new-dead").mkdir()
        (place / ".new-dead" / "code.py").write_text("half")
    assert [family.name for family in workspace.families()] == ["red-on-blue"]
    assert not verify_family(workspace.family("red-on-blue"))
    base = workspace.family("red-on-blue").head()
    write_version(workspace.family("red-on-blue"), make_content(steering=steered(base)))
    write_base(workspace, "other", make_content(make_schema(name="other")))
    assert not list(workspace.root.rglob(".new-*"))


def test_rejected_tasks_are_kept_apart(workspace: Workspace) -> None:
    files = {"task.yaml": b"a\n", "validation.log": b"goal: failed\n"}
    first = write_rejected(workspace, "red-on-blue", files)
    assert first == write_rejected(workspace, "red-on-blue", files)
    assert first.parent == workspace.root / ".rejected"
    assert (first / "validation.log").read_bytes() == b"goal: failed\n"
    assert workspace.families() == ()


def test_a_version_needs_all_its_files(workspace: Workspace) -> None:
    with pytest.raises(ValueError, match=r"code\.py"):
        write_base(workspace, "x", make_content(files={"task.yaml": b""}))


def test_workspace_that_cannot_be_written(tmp_path: object) -> None:
    with pytest.raises(UsageError, match="--tasks"):
        write_base(Workspace(__import__("pathlib").Path("/proc/nowhere")), "x", make_content())


def test_a_full_disk_is_named_and_leaves_nothing_behind(workspace: Workspace, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(path: object, data: bytes) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("rpg.store.write.write_file", full)
    with pytest.raises(OSError, match="No space left") as error:
        write_base(workspace, "red-on-blue", make_content())
    assert error.value.filename == str(workspace.root)
    assert not [path for path in workspace.root.iterdir() if path.name != ".lock"]
