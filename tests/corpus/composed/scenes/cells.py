"""A table of cells: what is told is true, false or unclear of blocks on it; its states are drawn for the corpus.

A meaning is worked out rather than written: states in which all that is told is true are to hold, and states in which
something is plainly false, and as little else as possible, are near misses. What the domain leaves open is unclear,
and in neither.
"""

from __future__ import annotations

from dataclasses import dataclass
from random import Random
from typing import Any

FAR = 1.5
"""Cells between centres from which neighbours are no longer beside each other."""
TRIES = 3000
ROWS, COLUMNS = 4, 4
AXES = {"left": (0, -1), "right": (0, 1), "front": (1, 0), "behind": (-1, 0)}
"""Steps along rows and columns: the far row is the first."""

Spot = tuple[str, int, int, int]
"""Where a block is: the patch ("" for none), row, column and layer."""
Layout = dict[str, Spot]


@dataclass(frozen=True)
class Told:
    """A relation of blocks, or a connective ("not", "or", "all") of what is told."""

    kind: str
    args: tuple[Any, ...]

    def truth(self, at: Layout) -> bool | None:
        """Whether it is so; None: unclear, or left open."""
        if self.kind in ("not", "or", "all"):
            parts = [part.truth(at) for part in self.args]
            if self.kind == "not":
                return None if parts[0] is None else not parts[0]
            if self.kind == "or":
                return True if True in parts and None not in parts else None if None in parts else False
            return False if False in parts else None if None in parts else True
        if self.kind == "on_patch":
            return at[self.args[0]][0] == self.args[1]
        if self.kind == "bare":
            return not any(_above(at[other], at[self.args[0]]) for other in at)
        if self.kind == "on_table":
            return at[self.args[0]][3] == 0
        if self.kind == "between":
            return _between(*(at[name] for name in self.args))
        return _pair(self.kind, at[self.args[0]], at[self.args[1]])


def _above(a: Spot, b: Spot) -> bool:
    return a[:3] == b[:3] and a[3] > b[3]


def _pair(kind: str, a: Spot, b: Spot) -> bool | None:
    """A relation of two blocks."""
    direct = a[:3] == b[:3] and a[3] == b[3] + 1
    if kind == "on":
        return direct
    if kind == "above":
        return _above(a, b)
    if kind == "over":
        return True if direct else None if _above(a, b) else False
    if a[0] != b[0]:
        return None
    level, across = a[3] == b[3] == 0, (a[1] - b[1], a[2] - b[2])
    if kind == "beside":
        apart = (across[0] ** 2 + across[1] ** 2) ** 0.5
        return False if apart > FAR or not apart else None if apart > 1 else (True if level else None)
    manner, side = kind[0], kind[1:]
    step = AXES[side]
    along = across[0] * step[0] + across[1] * step[1]
    aside = abs(across[0] * step[1]) + abs(across[1] * step[0])
    if along <= 0 or (aside > along and manner != "s"):
        return False
    if (manner in "di" and aside) or (manner == "i" and along > 1):
        return False
    if not level or (manner == "-" and aside == along):
        return None
    return True


def _between(a: Spot, b: Spot, c: Spot) -> bool | None:
    """Whether a stands between b and c: in line with them."""
    if {a[0], b[0], c[0]} != {a[0]}:
        return None
    ends = ((b[1], b[2]), (c[1], c[2]))
    (r, s), ((r1, s1), (r2, s2)) = (a[1], a[2]), ends
    inside = min(r1, r2) <= r <= max(r1, r2) and min(s1, s2) <= s <= max(s1, s2)
    if ends[0] == ends[1]:
        return None if (r, s) == ends[0] else False
    if not inside or (r, s) in ends:
        return False if (r, s) not in ends else None
    straight = (r1 == r2 == r) or (s1 == s2 == s)
    return True if straight and a[3] == b[3] == c[3] == 0 else None


def meaning(
    rng: Random, told: list[Told], blocks: dict[str, str], patches: tuple[str, ...] = ()
) -> dict[str, Any] | None:
    """States of blocks (their looks by name), or None if no state is found in which all of it is plainly so."""
    held: list[Layout] = []
    missed: list[tuple[int, Layout]] = []
    for _ in range(TRIES):
        at = _scattered(rng, list(blocks), patches)
        truths = [one.truth(at) for one in told]
        if all(truths):
            held.append(at)
        elif None not in truths or truths.count(False) == 1:
            missed.append((truths.count(False), at)) if False in truths else None
        if len(held) >= 3:
            break
    if not held:
        return None
    near = [moved for at in held for moved in _moved(rng, at)]
    missed += [(n, at) for at in near if (n := [one.truth(at) for one in told].count(False))]
    missed.sort(key=lambda pair: pair[0])
    looks = list(blocks.values())
    return {
        "assets": {**{look: looks.count(look) for look in looks}, **dict.fromkeys(patches, 1)},
        "hold": [drawn(at) for at in held],
        "miss": list(dict.fromkeys(drawn(at) for _, at in missed[:12])),
    }


def _scattered(rng: Random, names: list[str], patches: tuple[str, ...]) -> Layout:
    at: Layout = {}
    rng.shuffle(names)
    for name in names:
        tops = [spot for spot in at.values() if not any(_above(other, spot) for other in at.values())]
        if tops and rng.random() < 0.4:
            where, row, column, layer = rng.choice(tops)
            at[name] = (where, row, column, layer + 1)
            continue
        place = rng.choice(("", *patches))
        rows, columns = (2, 2) if place else (ROWS, COLUMNS)
        free = [(place, r, c, 0) for r in range(rows) for c in range(columns) if (place, r, c, 0) not in at.values()]
        at[name] = rng.choice(free) if free else ("", ROWS, len(at), 0)
    return at


def _moved(rng: Random, at: Layout) -> list[Layout]:
    """The same with two blocks exchanged."""
    names = list(at)
    out = []
    for n, a in enumerate(names):
        for b in names[n + 1 :]:
            out.append({**at, a: at[b], b: at[a]})
    rng.shuffle(out)
    return out


def drawn(at: Layout) -> str:
    """The picture of a layout; a name is a look, and a number where several look alike."""
    pieces = []
    for place in dict.fromkeys(spot[0] for spot in at.values()):
        here = {name: spot[1:] for name, spot in at.items() if spot[0] == place}
        if place:
            height, width = 2, 2
            top = left = 0
        else:
            top, left = (min(spot[k] for spot in here.values()) for k in (0, 1))
            height, width = (max(spot[k] for spot in here.values()) + 1 - low for k, low in ((0, top), (1, left)))
        rows = []
        for r in range(top, top + height):
            cells = []
            for c in range(left, left + width):
                stack = sorted((s[2], name) for name, s in here.items() if s[:2] == (r, c))
                cells.append("^".join(name for _, name in stack) or ".")
            rows.append(" ".join(cells))
        pieces.append(" | ".join(rows) + (f" at={place}" if place else ""))
    return "; ".join(pieces)
