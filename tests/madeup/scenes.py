"""Things placed to each other, drawn in the notation of the corpus, as they must be and in near misses."""

from __future__ import annotations

from collections import Counter
from copy import deepcopy
from dataclasses import dataclass
from typing import Any

from tests.madeup.things import PITCH, Thing

SIDES = ("left", "right", "behind", "front")
OPPOSITE = {"left": "right", "right": "left", "behind": "front", "front": "behind"}
_FAR = 2.8
"""So many edges lie between the middles of two blocks that are beside each other: no letter is next to another."""


@dataclass(frozen=True)
class Placed:
    """What lies on one of the `SIDES` of something, or "on" it; `part`: of one of its cells."""

    thing: Thing
    side: str
    mark: Thing
    part: int | None = None


@dataclass(frozen=True)
class MadeUp:
    """A sentence with the blocks and patches that it names, and states as pictures."""

    text: str
    assets: Counter[str]
    hold: list[str]
    miss: list[str]
    start: tuple[str, ...] = ()
    start_miss: tuple[str, ...] = ()

    def meant(self) -> dict[str, Any]:
        """As an entry of the corpus."""
        told = {"say": [self.text], "assets": dict(self.assets), "hold": self.hold, "miss": self.miss}
        return told | ({"start": [*self.start], "start_miss": [*self.start_miss]} if self.start else {})


def told(text: str, root: Thing, *placed: Placed) -> MadeUp:
    """A sentence of things that are placed one after the other, the first of them to `root`."""
    things = [root, *(x.thing for x in placed)]
    assets = Counter(look for thing in things for row in thing.cells for cell in row for look in cell)
    miss = [drawn(root, *placed[:n], other, *placed[n + 1 :]) for n in range(len(placed)) for other in _off(placed, n)]
    return MadeUp(text, assets, [drawn(root, *placed)], miss)


def _off(placed: tuple[Placed, ...], n: int) -> list[Placed]:
    """One of the things at another place, where nothing else is."""
    one = placed[n]
    others = [x.side for x in placed if x is not one and x.mark is one.mark]
    others += [OPPOSITE.get(x.side, "") for x in placed if x.thing is one.mark]
    free = [OPPOSITE[one.side]] if one.side in OPPOSITE else list(SIDES)
    return [Placed(one.thing, side, one.mark, one.part) for side in free if side not in others][:1]


def drawn(root: Thing, *placed: Placed) -> str:
    """A picture of the scene; `root` is in the middle of the table, or is a patch."""
    at = {id(root): (0.0, 0.0)}
    cells = {id(x): deepcopy(x.cells) for x in (root, *(y.thing for y in placed))}
    shown = [root] if root.shape != "patch" else []
    for x in placed:
        if x.side == "on" and x.mark.shape != "patch":
            below = cells[id(x.mark)][0][x.part or 0]
            below.extend(cells[id(x.thing)][0][0])
            cells[id(x.thing)][0][0] = below
            at[id(x.thing)] = at[id(x.mark)]
        else:
            at[id(x.thing)] = _beside(x, *at[id(x.mark)])
            shown.append(x.thing)
    patch = f"{root.cells[0][0][0]}+" if root.shape == "patch" else ""
    pieces = (" | ".join(" ".join("^".join(cell) for cell in row) for row in cells[id(x)]) for x in shown)
    places = (f"{x:g},{y:g}" for x, y in (at[id(x)] for x in shown))
    return " ; ".join(f"{piece} at={patch}{place}" for piece, place in zip(pieces, places, strict=True))


def _beside(x: Placed, away: float, left: float) -> tuple[float, float]:
    width = x.mark.width
    if x.part is not None:
        left, width = left + width / 2 - x.part * PITCH, 0.0
    deep, wide = (x.thing.depth + x.mark.depth) / 2 + _FAR, (x.thing.width + width) / 2 + _FAR
    moved = {"left": (0.0, wide), "right": (0.0, -wide), "behind": (deep, 0.0), "front": (-deep, 0.0), "on": (0.0, 0.0)}
    return away + moved[x.side][0], left + moved[x.side][1]
