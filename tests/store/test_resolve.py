"""What a user may type for a task, and what is said when it names none."""

from __future__ import annotations

from pathlib import Path

import pytest

from rpg.core.diagnostics import UsageError
from rpg.store import SteeringMeta, Version, Workspace, resolve, set_head, write_base, write_version

from .conftest import make_content, make_schema


@pytest.fixture
def versions(workspace: Workspace) -> list[Version]:
    base = write_base(workspace, "red-on-blue", make_content()).version
    meta = SteeringMeta(request="make it green", intent="TWEAK", reference=0, parent=base.hash)
    second = write_version(workspace.family("red-on-blue"), make_content(steering=meta)).version
    other = write_base(workspace, "two-towers", make_content(make_schema("two-towers", "Two towers."))).version
    return [base, second, other]


def test_every_way_to_name_a_version(
    workspace: Workspace, versions: list[Version], monkeypatch: pytest.MonkeyPatch
) -> None:
    base, second, other = versions
    assert resolve(workspace, "red-on-blue") == second
    assert resolve(workspace, "red-on-blue@0") == base
    assert resolve(workspace, "red-on-blue@v1") == second
    assert resolve(workspace, "red-on-blue@HEAD") == second
    assert resolve(workspace, f"red-on-blue@{base.hash[:5]}") == base
    assert resolve(workspace, str(base.directory)) == base
    assert resolve(workspace, str(workspace.root / "two-towers") + "/") == other
    for length in (5, 7, 12, 64):
        assert resolve(workspace, base.hash[:length]) == base
    monkeypatch.chdir(base.directory)
    assert resolve(Workspace(Path("tasks")), ".") == base
    set_head(base)
    assert resolve(workspace, "red-on-blue") == base


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("red-on-blu", "did you mean red-on-blue?"),
        ("zzz", "there are red-on-blue, two-towers"),
        ("red-on-blue@7", "it has 0, 1"),
        ("red-on-blue@first", "number or hash"),
        ("ffffffffffff", "no task"),
        ("", "no task"),
        ("/", "holds no task"),
        ("../..", "holds no task"),
        (".rejected", "no task"),
    ],
)
def test_what_is_said_about_a_wrong_name(
    workspace: Workspace, versions: list[Version], text: str, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(workspace.root.parent)
    with pytest.raises(UsageError) as error:
        resolve(workspace, text)
    assert said in str(error.value)


def test_a_workspace_is_not_a_task(workspace: Workspace, versions: list[Version]) -> None:
    with pytest.raises(UsageError, match="--tasks"):
        resolve(workspace, str(workspace.root))


def test_a_directory_with_a_source_only(workspace: Workspace, tmp_path: Path) -> None:
    (tmp_path / "task.yaml").write_text("format: 1\n")
    with pytest.raises(UsageError, match="rpg compile --from"):
        resolve(workspace, str(tmp_path))


def test_no_workspace(workspace: Workspace) -> None:
    with pytest.raises(UsageError, match="rpg compile makes one"):
        resolve(workspace, "red-on-blue")
