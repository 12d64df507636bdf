"""The best fit of an ideal figure to blocks: position, rotation, mirroring and pitch by least squares.

Places are complex numbers, x + iy. For a given match of blocks to cells the best similarity is known in closed form;
matches are found from a few starting rotations, taken from the angular moments of the figure and of the blocks, and
improved in turns. Blocks only match cells of their own level.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import NamedTuple

from rpg.blocks.figures import Ideal

ROUNDS = 6
"""How often a match is improved at most."""
MOMENTS = (1, 2, 3, 4, 5, 6)
EPS = 1e-9


class Fit(NamedTuple):
    """The worst distance (m) of a block from its cell, the pitch (m), the turn (radians), and the block of each cell
    as an index."""

    deviation: float
    pitch: float
    turn: float
    blocks: tuple[int, ...]


@dataclass(frozen=True)
class Template:
    """An ideal figure prepared for fitting. `symmetry`: how many rotations map it to itself."""

    points: tuple[complex, ...]
    levels: tuple[tuple[int, ...], ...]
    square: float
    symmetry: int
    chiral: bool
    moments: tuple[tuple[int, complex], ...]


@lru_cache(maxsize=512)
def prepared(ideal: Ideal) -> Template:
    """The template of an ideal figure."""
    points = tuple(complex(cell.x, cell.y) for cell in ideal.cells)
    height = 1 + max(cell.level for cell in ideal.cells)
    levels = tuple(tuple(k for k, cell in enumerate(ideal.cells) if cell.level == n) for n in range(height))
    keys = {(round(p.real, 4), round(p.imag, 4), c.level) for p, c in zip(points, ideal.cells, strict=True)}

    def maps(image: Sequence[complex]) -> bool:
        return all(
            any(abs(q - complex(x, y)) < 1e-3 and level == cell.level for x, y, level in keys)
            for q, cell in zip(image, ideal.cells, strict=True)
        )

    likely = [len(points)] if ideal.ring else [6, 4, 3, 2]
    orders = [n for n in likely if n > 1 and maps([p * cmath.rect(1, 2 * math.pi / n) for p in points])]
    found = moments_of(points)
    size = sum(abs(p) ** 3 for p in points) or 1.0
    strong = tuple((k, m) for k, m in sorted(found, key=lambda km: -abs(km[1]) / km[0]) if abs(m) > 0.15 * size)
    symmetry = orders[0] if orders else 1
    chiral = not any(maps([p.conjugate() * cmath.rect(1, a) for p in points]) for a in _mirror_turns(points))
    return Template(points, levels, sum(abs(p) ** 2 for p in points), symmetry, chiral, strong[:2])


def _mirror_turns(points: Sequence[complex]) -> list[float]:
    """Turns after which a mirrored figure could be itself again."""
    far = max(points, key=abs)
    return [cmath.phase(p) + cmath.phase(far) for p in points if abs(abs(p) - abs(far)) < 1e-3]


def moments_of(points: Sequence[complex]) -> list[tuple[int, complex]]:
    """Sums of |p|^3 e^(ik arg p): the k-th turns by k times the rotation."""
    totals = [0j] * len(MOMENTS)
    for p in points:
        length = abs(p)
        if length > EPS:
            unit = p / length
            term = length**3 * unit
            for n in range(len(MOMENTS)):
                totals[n] += term
                term *= unit
    return list(zip(MOMENTS, totals, strict=True))


def best_fit(
    ideal: Ideal, places: Sequence[tuple[float, float, int]], pitches: tuple[float, float], tolerance: float
) -> Fit | None:
    """The best fit of a figure to blocks at (x, y, level); None where levels or size tell that there is none.

    `pitches` are the least and greatest pitch, `tolerance` the distance from a cell that is accepted (m).
    """
    template = prepared(ideal)
    levels = _by_level(template, places)
    if levels is None:
        return None
    centre = complex(sum(p[0] for p in places), sum(p[1] for p in places)) / len(places)
    points = [complex(p[0], p[1]) - centre for p in places]
    spread = math.sqrt(sum(abs(p) ** 2 for p in points))
    if template.square < EPS:
        return Fit(max(map(abs, points)), pitches[0], 0.0, tuple(k for level in levels for k in level))
    size = math.sqrt(template.square)
    slack = tolerance * math.sqrt(len(points))
    if not pitches[0] * size - slack <= spread <= pitches[1] * size + slack:
        return None
    task = _Task(ideal, template, points, levels, pitches, spread / size, 0.4 * tolerance)
    return task.best(task.starts())


@lru_cache(maxsize=2048)
def likeness(one: Ideal, two: Ideal) -> float:
    """How near two figures of as many cells come to each other: the worst distance of their best fit, in pitches."""
    places = tuple((cell.x, cell.y, cell.level) for cell in one.cells)
    fit = best_fit(two, places, (0.5, 2.0), 0.5)
    return math.inf if fit is None else fit.deviation


def _by_level(template: Template, places: Sequence[tuple[float, float, int]]) -> list[list[int]] | None:
    """Indices of the blocks at each level; None where a level has another number of cells."""
    levels: list[list[int]] = [[] for _ in template.levels]
    for k, (_, _, level) in enumerate(places):
        if not 0 <= level < len(levels):
            return None
        levels[level].append(k)
    if any(len(a) != len(b) for a, b in zip(levels, template.levels, strict=True)):
        return None
    return levels


@dataclass(frozen=True)
class _Task:
    """One fit: `points` are the blocks around their centroid, `scale` the pitch to start from, `enough` the deviation
    at which no further start is tried."""

    ideal: Ideal
    template: Template
    points: list[complex]
    levels: list[list[int]]
    pitches: tuple[float, float]
    scale: float
    enough: float

    def starts(self) -> list[tuple[float, bool]]:
        """Rotations to start from, with and without mirroring."""
        found = dict(moments_of(self.points))
        starts = []
        hands = (False, True) if self.template.chiral and self.ideal.limit is None else (False,)
        for mirrored in hands:
            for k, moment in self.template.moments:
                own = -cmath.phase(moment) if mirrored else cmath.phase(moment)
                turn = (cmath.phase(found[k]) - own) / k if k in found else 0.0
                count = max(1, k // math.gcd(k, self.template.symmetry))
                starts += [(turn + 2 * math.pi * j / k, mirrored) for j in range(count)]
        return starts or [(2 * math.pi * j / (8 * self.template.symmetry), m) for j in range(8) for m in hands]

    def best(self, starts: Sequence[tuple[float, bool]]) -> Fit | None:
        """The best of the fits from these starts; of equal ones the first."""
        best: Fit | None = None
        if self.ideal.ring:
            return self._around()
        for turn, mirrored in starts:
            fit = self._improve(self._near(turn), mirrored)
            if best is None or fit.deviation < best.deviation - EPS:
                best = fit
            if best.deviation < self.enough:
                break
        return best

    def _near(self, turn: float) -> float:
        """Of the rotations that the figure's symmetry makes equal, the one nearest to none at all."""
        step = 2 * math.pi / self.template.symmetry
        return turn - step * round(turn / step)

    def _improve(self, turn: float, mirrored: bool) -> Fit:
        cells = [p.conjugate() for p in self.template.points] if mirrored else list(self.template.points)
        match: tuple[int, ...] | None = None
        factor = cmath.rect(min(max(self.scale, self.pitches[0]), self.pitches[1]), turn)
        for _ in range(ROUNDS):
            new = self._match([factor * c for c in cells])
            if new == match:
                break
            match = new
            factor = self._similarity(cells, match)
        assert match is not None
        return self._fit(cells, match, factor)

    def _similarity(self, cells: Sequence[complex], match: tuple[int, ...]) -> complex:
        """The best rotation and pitch (as a complex factor) for a match, the pitch within its limits."""
        points = self.points
        total = sum((c.conjugate() * points[k] for c, k in zip(cells, match, strict=True)), 0j) / self.template.square
        if abs(total) < EPS:
            return complex(self.pitches[0])
        return total / abs(total) * min(max(abs(total), self.pitches[0]), self.pitches[1])

    def _fit(self, cells: Sequence[complex], match: tuple[int, ...], factor: complex) -> Fit:
        points = self.points
        deviation = max(abs(points[k] - factor * c) for c, k in zip(cells, match, strict=True))
        return Fit(deviation, abs(factor), cmath.phase(factor), match)

    def _match(self, targets: Sequence[complex]) -> tuple[int, ...]:
        """The block of each cell: each block its nearest cell; where two want one, nearest pairs first."""
        points = self.points
        chosen = [-1] * len(targets)
        for blocks, cells in zip(self.levels, self.template.levels, strict=True):
            clash = False
            for k in blocks:
                p = points[k]
                distances = [abs(p - targets[c]) for c in cells]
                nearest = cells[distances.index(min(distances))]
                clash = clash or chosen[nearest] >= 0
                chosen[nearest] = k
            if clash:
                self._pair(blocks, cells, targets, chosen)
        return tuple(chosen)

    def _pair(self, blocks: Sequence[int], cells: Sequence[int], targets: Sequence[complex], chosen: list[int]) -> None:
        """Match blocks to cells one to one, nearest pairs first."""
        pairs = sorted((abs(self.points[k] - targets[c]), k, c) for k in blocks for c in cells)
        used: set[int] = set()
        for c in cells:
            chosen[c] = -1
        for _, k, c in pairs:
            if k not in used and chosen[c] < 0:
                chosen[c] = k
                used.add(k)

    def _around(self) -> Fit:
        """A ring: blocks in the order of their angles."""
        match = tuple(sorted(range(len(self.points)), key=lambda k: -cmath.phase(self.points[k])))
        factor = self._similarity(self.template.points, match)
        return self._fit(self.template.points, match, factor)
