"""Small tasks to store."""

from __future__ import annotations

from pathlib import Path

import pytest

from rpg.ir.assets import ColoredCube
from rpg.ir.goal import On
from rpg.ir.schema import TaskSchema
from rpg.store import Content, Version, Workspace, dump_schema


def make_schema(name: str = "red-on-blue", instruction: str = "Put the red block on the blue block.") -> TaskSchema:
    assets = (ColoredCube(name="red_block", color="red"), ColoredCube(name="blue_block", color="blue"))
    goal = On(a="red_block", b="blue_block", span=(0, 35))
    return TaskSchema(name=name, instruction=instruction, assets=assets, goal=goal)


def fake_lower(schema: TaskSchema) -> str:
    """Stands for the code generator: any function of the schema will do."""
    return f"# {schema.name}\nGOAL = {schema.goal.model_dump(mode='json')!r}\n"


def lowered(version: Version) -> bool:
    """Whether a version's code is what `fake_lower` gives."""
    return version.code == fake_lower(version.schema)


def make_content(schema: TaskSchema | None = None, **changes: object) -> Content:
    schema = schema or make_schema()
    files = {
        "task.yaml": dump_schema(schema).encode(),
        "code.py": fake_lower(schema).encode(),
        "goal_state_code.py": b"GOAL_STATE = 1\n",
        "validation.log": b"text: passed\n",
    }
    fields: dict[str, object] = {
        "files": files,
        "description": schema.instruction,
        "assets_used": tuple(asset.name for asset in schema.assets),
        "goal_summary": "the red block is on the blue block",
        "pictures": {},
    }
    return Content(**(fields | changes))  # type: ignore[arg-type]


@pytest.fixture
def workspace(tmp_path: Path) -> Workspace:
    return Workspace(tmp_path / "tasks")
