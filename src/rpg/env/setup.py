"""How a task says what is in it and how an episode starts: the calls of `_initialize_env` and `_on_reset`."""

from __future__ import annotations

import math

from rpg.blocks.state import BlockState, Quat, Vec3, World, yaw_quat
from rpg.ir.assets import Asset, GoalPatch
from rpg.ir.goal import Goal
from rpg.ir.schema import InitialState, Start, Vacancy

Placements = dict[str, tuple[Vec3, Quat]]


class Setup:
    """Collects what the hooks ask for; the task then draws the start, or takes the placed scenes."""

    world: World

    def __init__(self) -> None:
        self._assets: list[Asset] = []
        self._begun: tuple[object, InitialState] | None = None
        self._forget()

    def _forget(self) -> None:
        self._arranged: list[Goal] = []
        self._heaps: list[tuple[str, ...]] = []
        self._poses: list[Start] = []
        self._vacant: list[Vacancy] = []
        self._scenes: list[Placements] = []
        self._placed: Placements = {}

    def add(self, asset: Asset) -> None:
        """Put a block or a patch into the task. A patch needs its position on the table."""
        if isinstance(asset, GoalPatch) and asset.position is None:
            raise ValueError(f"the patch {asset.name!r} has no position (x, y) on the table")
        self._assets.append(asset)

    def scatter(self, *names: str) -> None:
        """Start with these blocks flat on the table, at random places and turns, touching nothing.

        Blocks that no other call places are scattered in any case.
        """
        self._known(names)

    def arrange(self, *goals: Goal) -> None:
        """Start with these goals holding."""
        self._arranged += goals

    def heap(self, *names: str) -> None:
        """Start with these blocks in a heap that has settled."""
        self._known(names)
        self._heaps.append(names)

    def start(self, name: str, position: tuple[float, float], *, yaw: float = 0.0, jitter: float = 0.0) -> None:
        """Start with a block flat on the table: its centre (x, y) in metres, moved by up to `jitter` along x and y."""
        self._known((name,))
        self._poses.append(Start(block=name, position=position, yaw=yaw, jitter=jitter))

    def keep_free(self, origin: str, size: float, before: str | None = None) -> None:
        """Keep the place of a removed block empty, so that the others start where they always did."""
        self._vacant.append(Vacancy(origin=origin, size=size, before=before))

    def place(self, name: str, position: Vec3, *, yaw: float = 0.0, quat: Quat | None = None) -> None:
        """Put a block exactly there: its centre in metres, turned by `yaw` radians or by a quaternion (w, x, y, z).

        Quaternions count to six decimals, as nothing real is balanced more exactly.
        """
        self._known((name,))
        x, y, z = position
        self._placed[name] = ((x, y, z), yaw_quat(yaw) if quat is None else _rounded(quat))

    def waypoint(self) -> None:
        """The scene placed so far is one that the episode passes through: first its start, then stage by stage."""
        self._scenes.append(dict(self._placed))

    def _known(self, names: tuple[str, ...]) -> None:
        for name in names:
            if name not in self.world.blocks:
                raise ValueError(f"the task has no block {name!r}; its blocks are {', '.join(self.world.blocks)}")

    def _initial_state(self) -> InitialState:
        said = tuple(self._arranged), tuple(self._heaps), tuple(self._poses), tuple(self._vacant)
        if self._begun is None or self._begun[0] != said:
            arranged, heaps, poses, vacant = said
            self._begun = said, InitialState(arranged=arranged, heaps=heaps, poses=poses, vacant=vacant)
        return self._begun[1]

    def _placed_states(self) -> list[BlockState]:
        """The scenes that were placed, in order, the last one where the episode stands."""
        scenes = [*self._scenes, self._placed] if self._placed else []
        missing = [name for name in self.world.blocks if name not in (scenes[0] if scenes else self.world.blocks)]
        if missing:
            raise ValueError(f"place() puts every block somewhere, but {missing[0]!r} was left out")
        return [
            BlockState(
                self.world, {n: scene[n][0] for n in self.world.blocks}, {n: scene[n][1] for n in self.world.blocks}
            )
            for scene in scenes
        ]


def _rounded(quat: Quat) -> Quat:
    w, x, y, z = (round(part, 6) for part in quat)
    length = math.sqrt(w * w + x * x + y * y + z * z)
    if not 0.9 < length < 1.1:
        raise ValueError(f"{quat} is not a unit quaternion (w, x, y, z)")
    return (w / length, x / length, y / length, z / length)
