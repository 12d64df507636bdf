"""What predicates look at: the objects of a task (World) and where they are at an instant (BlockState)."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property, lru_cache

from rpg.blocks.constants import TABLE_Z
from rpg.ir.assets import Asset, Block, GoalPatch
from rpg.ir.node import Lowest, Operand

Vec3 = tuple[float, float, float]
Quat = tuple[float, float, float, float]
Matrix = tuple[Vec3, Vec3, Vec3]
IDENTITY: Quat = (1.0, 0.0, 0.0, 0.0)

Look = tuple[str, ...]
"""Type, colour, symbols and size: blocks with equal looks are interchangeable."""


class World:
    """The objects of a task by name. Immutable after construction; patches have their positions."""

    def __init__(self, assets: Iterable[Asset]) -> None:
        self.assets: dict[str, Asset] = {asset.name: asset for asset in assets}
        self.blocks: dict[str, Block] = {n: a for n, a in self.assets.items() if not isinstance(a, GoalPatch)}
        self.patches: dict[str, GoalPatch] = {n: a for n, a in self.assets.items() if isinstance(a, GoalPatch)}
        self.edge: dict[str, float] = {name: block.size for name, block in self.blocks.items()}

    @cached_property
    def look(self) -> dict[str, Look]:
        """What every block looks like; many a world is made that nobody looks at."""
        return {name: look_of(block) for name, block in self.blocks.items()}


@lru_cache(maxsize=256)
def look_of(block: Block) -> Look:
    """What tells `block` apart from another one by eye."""
    data = block.model_dump(exclude={"name", "origin"}, mode="json")
    return tuple(f"{key}={value}" for key, value in sorted(data.items()))


@dataclass(frozen=True, slots=True)
class BlockState:
    """Where every block is. Positions are centres in metres, world frame; `moving` are those faster than REST_SPEED;
    `held` those in the gripper; `start` is the state that the episode began with (None: this is the start)."""

    world: World
    position: Mapping[str, Vec3]
    orientation: Mapping[str, Quat]
    moving: frozenset[str] = frozenset()
    held: frozenset[str] = frozenset()
    start: BlockState | None = None
    _axes: dict[str, tuple[Matrix, float, float]] = field(default_factory=dict, compare=False, repr=False)

    def axes(self, name: str) -> Matrix:
        """The block's rotation matrix, row by row: column k is its k-th axis in the world."""
        return (self._axes.get(name) or self._turned(name))[0]

    def _turned(self, name: str) -> tuple[Matrix, float, float]:
        """The block's rotation matrix, half of its vertical extent, and the cosine of its tilt."""
        orientation = self.orientation.get(name, IDENTITY)
        axes = UPRIGHT if orientation is IDENTITY else matrix(orientation)
        x, y, z = axes[2]
        x, y, z = abs(x), abs(y), abs(z)
        found = self._axes[name] = axes, self.world.edge[name] / 2 * (x + y + z), min(1.0, max(x, y, z))
        return found

    def tilt(self, *names: str) -> float:
        """Angle in degrees between the vertical and the block's axis nearest to it (0 on any face); of several blocks,
        the largest."""
        cosines = [(self._axes.get(name) or self._turned(name))[2] for name in names]
        return math.degrees(math.acos(min(cosines, default=1.0)))

    def bottom(self, name: str) -> float:
        """Height of the block's lowest point."""
        return self.position[name][2] - (self._axes.get(name) or self._turned(name))[1]

    def top(self, name: str) -> float:
        """Height of the block's highest point."""
        return self.position[name][2] + (self._axes.get(name) or self._turned(name))[1]

    def resolve(self, operand: Operand) -> tuple[str, ...]:
        """The objects that an operand stands for in this state."""
        if isinstance(operand, tuple):
            return operand
        if isinstance(operand, Lowest):
            return (min(operand.lowest, key=lambda n: self.position[n][2]),)
        return (max(operand.highest, key=lambda n: self.position[n][2]),)

    def where(self, name: str) -> Vec3:
        """Centre of a block, or of a patch on the table."""
        patch = self.world.patches.get(name)
        if patch is None:
            return self.position[name]
        x, y = patch.position or (math.nan, math.nan)
        return (x, y, TABLE_Z)

    def moved(self, poses: Mapping[str, tuple[Vec3, Quat]]) -> BlockState:
        """This state with some blocks elsewhere."""
        return BlockState(
            self.world,
            {**self.position, **{n: p for n, (p, _) in poses.items()}},
            {**self.orientation, **{n: q for n, (_, q) in poses.items()}},
            self.moving,
            self.held,
            self.start,
            {name: axes for name, axes in self._axes.items() if name not in poses},
        )

    def since(self, start: BlockState | None) -> BlockState:
        """This state in an episode that began with `start`."""
        if start is self.start:
            return self
        return BlockState(self.world, self.position, self.orientation, self.moving, self.held, start, self._axes)


def matrix(quat: Quat) -> Matrix:
    """Rotation matrix of a unit quaternion (w, x, y, z)."""
    w, x, y, z = quat
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )


UPRIGHT = matrix(IDENTITY)


def yaw_quat(yaw: float) -> Quat:
    """Quaternion of a turn by `yaw` radians about the vertical."""
    return (math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2))


def product(a: Quat, b: Quat) -> Quat:
    """The quaternion of turn `b`, then turn `a` (both about the world's axes)."""
    aw, ax, ay, az = a
    bw, bx, by, bz = b
    return (
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    )
