"""A task's scene as files that any MuJoCo user can load."""

from __future__ import annotations

from pathlib import Path

from rpg.blocks.scene import build_spec
from rpg.blocks.state import BlockState
from rpg.loading import Task

SCENE = "scene.xml"
TEXTURES = "assets"


def export_mjcf(task: Task, directory: Path, seed: int) -> tuple[Path, ...]:
    """Write scene.xml and its textures below `directory`; the files written.

    The scene has two keyframes: "start", the reset of `seed`, and "goal", the task's goal configuration.
    """
    start, goal = task.task_class().reset(seed), task.goal_class().reset(seed)
    spec = build_spec(task.schema.assets, textures=True)
    spec.modelname = task.schema.name
    spec.texturedir = TEXTURES
    spec.add_key(name="start", qpos=_coordinates(start))
    spec.add_key(name="goal", qpos=_coordinates(goal))
    textures = dict(spec.assets)
    spec.compile()
    files = {directory / TEXTURES / name: data for name, data in textures.items()}
    files[directory / SCENE] = spec.to_xml().encode()
    (directory / TEXTURES).mkdir(parents=True, exist_ok=True)
    for path, data in files.items():
        path.write_bytes(data)
    return tuple(sorted(files))


def _coordinates(state: BlockState) -> list[float]:
    """The free joints' coordinates, block by block as the scene has them."""
    return [number for name in state.world.blocks for number in (*state.position[name], *state.orientation[name])]
