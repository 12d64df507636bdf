"""What the parts of a goal say under every naming of its look-alikes: as few different things as there are."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np

from rpg.blocks.centres import Centres, Mask
from rpg.blocks.evaluate import perhaps
from rpg.blocks.state import BlockState, World
from rpg.blocks.symmetry import Cells, namings
from rpg.ir import goal as g
from rpg.ir.structures import Row, Towers
from rpg.ir.walk import names, rename

ANY_ORDER = frozenset({"on_table", "on_patch", "in_region", "clear", "stayed", "moved", "shifted"})
"""Atoms that say the same of each of their blocks."""
MANY = 24
"""So many different things are first ruled out by the centres of blocks."""


class Variants:
    """A part of a goal under many namings: `images` of the names that they deal."""

    def __init__(self, part: g.Goal, dealt: tuple[str, ...], images: Sequence[tuple[str, ...]], world: World) -> None:
        self.part, self.world = part, world
        number = {name: k for k, name in enumerate(world.blocks)}
        kept = [name for name in names(part) if name in number and name not in dealt]
        self._column = {name: k for k, name in enumerate((*dealt, *kept))}
        self._blocks = np.array([[*map(number.__getitem__, (*image, *kept))] for image in images])

    def perhaps(self, state: BlockState) -> Mask:
        """Those that may hold in `state`, as far as the centres of its blocks tell."""
        centres = np.array([state.position[name] for name in self.world.blocks])
        return perhaps(self.part, Centres(self.world, centres[self._blocks].transpose(2, 0, 1), self._column))


class Namings:
    """Every naming that `cells` leave, the names as they stand first, and what names stand for under each of them."""

    def __init__(self, cells: Cells) -> None:
        self.maps = namings(cells)
        dealt = {name for group in cells for cell in group for name in cell}
        self._stands_for = {name: [naming.get(name, name) for naming in self.maps] for name in dealt}
        self._images: dict[tuple[tuple[str, ...], bool], tuple[list[tuple[str, ...]], tuple[int, ...]]] = {}

    def __len__(self) -> int:
        return len(self.maps)

    def spread(self, part: g.Goal) -> tuple[list[g.Goal], tuple[int, ...]]:
        """The different things that a part of the goal says, as it stands first, and which of them each naming says."""
        dealt = tuple(name for name in names(part) if name in self._stands_for)
        loose = len(dealt) > 1 and _in_any_order(part)
        dealt = tuple(sorted(dealt)) if loose else dealt
        images, numbers = self._of(dealt, loose)
        return [rename(part, dict(zip(dealt, image, strict=True))) for image in images], numbers

    def variants(self, part: g.Goal, world: World) -> Variants:
        """The different things that `spread` finds, to be ruled out all at once."""
        dealt = tuple(name for name in names(part) if name in self._stands_for)
        loose = len(dealt) > 1 and _in_any_order(part)
        dealt = tuple(sorted(dealt)) if loose else dealt
        images, _ = self._of(dealt, loose)
        return Variants(part, dealt, images, world)

    def _of(self, dealt: tuple[str, ...], loose: bool) -> tuple[list[tuple[str, ...]], tuple[int, ...]]:
        """What these names stand for, each way once, in an order of their own where they are `loose`; and which of
        them under each naming."""
        if not dealt:
            return [()], (0,) * len(self.maps)
        found = self._images.get((dealt, loose))
        if found is None:
            each = zip(*(self._stands_for[name] for name in dealt), strict=True)
            known: dict[tuple[str, ...], int] = {}
            numbers = tuple(known.setdefault(tuple(sorted(i)) if loose else i, len(known)) for i in each)
            found = self._images[dealt, loose] = list(known), numbers
        return found


@lru_cache(maxsize=16)
def all_namings(cells: Cells) -> Namings:
    """The namings that `cells` leave; shared, as every instance of a task asks for them. Raises Refusal where they are
    too many."""
    return Namings(cells)


def _in_any_order(part: g.Goal) -> bool:
    """Does a part say the same, with the same margin, in whichever order its blocks are listed?"""
    if isinstance(part, g.Not):
        return _in_any_order(part.goal)
    if isinstance(part, Row):
        return part.order.by != "given" and not (part.excused or part.covered)
    if isinstance(part, Towers):
        return True
    return part.kind in ANY_ORDER and isinstance(getattr(part, "a", None), tuple)
