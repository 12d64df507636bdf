"""grid, pyramid, staircase, figure: blocks that fill the cells of an ideal figure."""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterable, Iterator, Sequence
from functools import lru_cache
from random import Random
from typing import Any, NamedTuple

import numpy as np

from rpg.blocks.centres import Centres, Mask
from rpg.blocks.constants import SUPPORT_GAP
from rpg.blocks.figures import NAMED, NEAREST, Ideal, flat_forms, ideals, neighbors, upright
from rpg.blocks.geometry import footprint_gap, rests_on
from rpg.blocks.predicate import Cluster, NearMiss, Predicate
from rpg.blocks.predicates.cells_build import layouts, pitches, resting
from rpg.blocks.predicates.common import (
    PAST_SHARE,
    Poses,
    centroid,
    flatness,
    largest_edge,
    set_aside,
    shift,
    slack,
    spin,
    swap,
)
from rpg.blocks.predicates.fit import EPS, Fit, best_fit, likeness, prepared
from rpg.blocks.predicates.lattice import cells_of
from rpg.blocks.predicates.lattice import filled as on_lattice
from rpg.blocks.predicates.order import fixed_edges
from rpg.blocks.predicates.pattern import fillings, follows
from rpg.blocks.predicates.plainly import ROOM, about_middle, layered, layers, spreads
from rpg.blocks.predicates.reading import legible, unreadable
from rpg.blocks.predicates.stack import alone
from rpg.blocks.predicates.vertical import GROUND
from rpg.blocks.state import IDENTITY, BlockState, World
from rpg.blocks.traits import AWAY, TO_VIEWER, UP, Traits, symbols_shown
from rpg.blocks.verdict import FALSE, TRUE, Verdict, at_most, every, holds
from rpg.blocks.visibility import reads
from rpg.ir.structures import Cells, Figure, Pyramid

MAX_FILLINGS = 4
"""How many ways to fill a figure's cells are offered for each of its forms."""

PLAINLY = 0.25
"""A figure whose blocks are all within this share of the tolerance of their cells is taken for no other figure."""


class Found(NamedTuple):
    """A figure found in a state: its form, its fit, the block in each cell, and the verdict."""

    ideal: Ideal
    fit: Fit
    blocks: list[str]
    verdict: Verdict


def heights(state: BlockState, names: Sequence[str], edge: float) -> tuple[list[int], float]:
    """The level of each block over the lowest one, in edges, and the margin of their heights."""
    bottoms = [state.bottom(name) for name in names]
    base = min(bottoms)
    levels = [round((bottom - base) / edge) for bottom in bottoms]
    error = max(abs(bottom - base - level * edge) for bottom, level in zip(bottoms, levels, strict=True))
    return levels, 1.0 - error / SUPPORT_GAP


def _layer_counts(node: Cells, count: int) -> list[list[int]]:
    """How many blocks each form of a figure has at each level."""
    return [[len(level) for level in prepared(ideal).levels] for ideal in ideals(node, count)]


@lru_cache(maxsize=512)
def _spreads_of(ideal: Ideal) -> tuple[float, float]:
    """How far the cells of a figure are from their middle, along their best line and across it, in pitches."""
    cells = np.array([(cell.x, cell.y) for cell in ideal.cells])
    long, short = np.linalg.svd(cells - cells.mean(axis=0), compute_uv=False)[:2] if len(cells) > 1 else (0.0, 0.0)
    return max(float(long), EPS), max(float(short), EPS)


def outdone(ideal: Ideal, fit: Fit, places: Sequence[tuple[float, float, int]], pitches: tuple[float, float]) -> float:
    """How much better another flat figure fits the blocks than half as badly as `fit` does; negative where none does.

    Small figures of different shapes differ by less than the tolerance: blocks that plainly are the one are not the
    other. Any cells of a square lattice are a figure here, too. Only figures that are as near to this one as the blocks
    are can fit so well.
    """
    limit = fit.deviation / 2
    lattice = on_lattice([complex(x, y) for x, y, _ in places], pitches, limit)
    least = math.inf if lattice is None or lattice.cells == cells_of(ideal) else lattice.deviation
    for form in flat_forms(len(places)) if len(places) > 3 else ():
        if EPS < likeness(ideal, form) * fit.pitch < 3.0 * limit + EPS:
            rival = best_fit(form, places, pitches, limit)
            least = min(least, rival.deviation if rival is not None else math.inf)
    return max(-1.0, 1.0 - least / limit)


Fitted = tuple[Fit, list[str], float]
"""A fit, the block in each cell, and the margin so far."""


class CellsPredicate(Predicate[Cells]):
    """The best fit of any form of the figure, each block near its cell, the pattern and the reading on top."""

    def __init__(self) -> None:
        self._last: tuple[BlockState | None, dict[Hashable, Fitted | None]] = (None, {})

    def evaluate(self, node: Cells, state: BlockState) -> Verdict:
        found = self.find(node, state)
        return found.verdict if found is not None else FALSE

    def holds(self, node: Cells, state: BlockState) -> bool:
        counts = layers(state, node.blocks)
        if counts is not None and counts not in _layer_counts(node, len(node.blocks)):
            return False
        return self.evaluate(node, state).value

    def perhaps(self, node: Cells, many: Centres) -> Mask:
        names, edges = node.blocks, many.edges(node.blocks)
        along, across = (np.sqrt(squares) for squares in spreads(*about_middle(many, names))[:2])
        fitting = many.none()
        # Moving points by `error` in all moves neither of the two by more. Each tells between which pitches the fit is.
        error = (node.fit_edges * edges.max() + ROOM) * math.sqrt(len(names))
        for ideal in ideals(node, len(names)):
            low, high = pitches(node, ideal, edges.max())
            long, short = _spreads_of(ideal)
            least = np.maximum((along - error) / long, (across - error) / short)
            most = np.minimum((along + error) / long, (across + error) / short)
            fitting |= np.maximum(least, low) <= np.minimum(most, high)
        return fitting & layered(many, names, _layer_counts(node, len(names)))

    def find(self, node: Cells, state: BlockState) -> Found | None:
        """The form of the figure that holds, or else comes nearest to it; None where none has the blocks' levels."""
        names = node.blocks
        forms = ideals(node, len(names))
        if not forms:
            return None
        best: Found | None = None
        for ideal in forms:
            fitted = self._fitted(node, ideal, state)
            if fitted is None:
                continue
            found = self._judge(node, ideal, *fitted, state)
            if best is None or found.verdict.margin > best.verdict.margin:
                best = found
            if best.verdict.margin > 0.5:
                break
        return best

    def _fitted(self, node: Cells, ideal: Ideal, state: BlockState) -> Fitted | None:
        """How one form fits the blocks, whichever of them is told to be in which cell: under many namings of blocks
        that look alike it is the same, and is worked out once."""
        if self._last[0] is not state:
            self._last = state, {}
        known = self._last[1]
        key = (ideal, frozenset(node.blocks), node.fit_edges, node.pitch_edges, node.gap, node.tolerance)
        if key not in known:
            known[key] = self._fit(node, ideal, state)
        return known[key]

    def _fit(self, node: Cells, ideal: Ideal, state: BlockState) -> Fitted | None:
        names = node.blocks
        edge = largest_edge(state, names)
        levels, margin = heights(state, names, edge)
        places = [(*state.position[name][:2], level) for name, level in zip(names, levels, strict=True)]
        tolerance = node.fit_edges * edge
        between = pitches(node, ideal, edge)
        fit = best_fit(ideal, places, between, tolerance)
        if fit is None:
            return None
        room = min(margin, flatness(state, names), slack(fit.deviation, tolerance))
        if max(levels) == 0 and PLAINLY * tolerance < fit.deviation <= tolerance + EPS and len(names) > 2:
            room = min(room, -outdone(ideal, fit, places, between))
        return fit, [names[k] for k in fit.blocks], room

    def _judge(self, node: Cells, ideal: Ideal, fit: Fit, blocks: list[str], margin: float, state: BlockState) -> Found:
        if ideal.limit is not None:
            margin = min(margin, slack(abs(math.degrees(fit.turn)), ideal.limit))
        parts = [holds(margin)]
        if isinstance(node, Pyramid) and margin > 0.0:
            parts.append(TRUE if _bridged(ideal, blocks, state) else FALSE)
        if node.gap is not None:
            gaps = [footprint_gap(state, blocks[i], blocks[j]) for i, j in neighbors(ideal)]
            parts.append(every(at_most(abs(max(gap, 0.0) - node.gap), node.tolerance) for gap in gaps))
        if node.pattern is not None:
            shown = symbols_shown(state, node.blocks, TO_VIEWER if upright(node) else UP)
            parts.append(TRUE if follows(node.pattern, ideal, blocks, Traits(state.world, shown)) else FALSE)
        if node.readable:
            parts.append(self._legible(node, ideal, blocks, state))
        return Found(ideal, fit, blocks, every(parts))

    def _legible(self, node: Cells, ideal: Ideal, blocks: Sequence[str], state: BlockState) -> Verdict:
        if upright(node):
            return legible(state, blocks, TO_VIEWER, UP, node.excused)
        if max(cell.level for cell in ideal.cells) == 0:
            return legible(state, blocks, UP, AWAY, node.excused) & alone(state, blocks, node.covered)
        exterior = [name for name, hidden in zip(blocks, hidden_cells(ideal), strict=True) if not hidden]
        margins = [1.0]
        for name in exterior:
            views = [
                reads(state, name, normal, None if name in node.excused else up)
                for normal, up in ((UP, AWAY), (TO_VIEWER, UP))
            ]
            if any(symbol for symbol, _ in views):
                margins.append(max(margin for symbol, margin in views if symbol))
        return holds(min(margins))

    def build(self, node: Cells, world: World, rng: Random) -> Iterator[list[Cluster]]:
        traits = Traits(world)
        for ideal in ideals(node, len(node.blocks)):
            for k, filled in enumerate(fillings(node.pattern, ideal, node.blocks, traits, rng)):
                if k == MAX_FILLINGS:
                    break
                for cluster in layouts(node, ideal, filled, world):
                    yield [cluster]

    def supports(self, node: Cells, world: World) -> Iterable[tuple[str, str]]:
        """What rests on what, where the pattern leaves no choice of blocks for the cells."""
        pattern = node.pattern
        if pattern is None or pattern.kind != "reading":
            return
        traits = Traits(world)
        forms = ideals(node, len(node.blocks))
        if len(forms) != 1 or fixed_edges(pattern.order, node.blocks, traits) is None:
            return
        filled = next(fillings(pattern, forms[0], node.blocks, traits, Random(0)), None)
        if filled is not None:
            for upper, lower in resting(forms[0]):
                yield filled[upper], GROUND if lower is None else filled[lower]

    def near_misses(self, node: Cells, state: BlockState, rng: Random) -> Iterator[NearMiss]:
        found = self.find(node, state)
        if found is None or len(node.blocks) < 2:
            return
        edge = largest_edge(state, node.blocks)
        yield from self._displaced(node, found, edge, state)
        reach = max(math.hypot(cell.x, cell.y) for cell in found.ideal.cells)
        if reach > 0.0:
            widest = pitches(node, found.ideal, edge)[1]
            pitch = widest * self._reach_of_forms(node) + 1.3 * node.fit_edges * edge / reach
            yield NearMiss("the figure too wide", stretched(state, node.blocks, pitch / found.fit.pitch))
        if found.ideal.limit is not None:
            yield from self._turned(node, found, state)
        if node.pattern is not None:
            yield from self._exchanged(node, found, state)
        if node.readable:
            normal, up = (TO_VIEWER, UP) if upright(node) else (UP, AWAY)
            if upright(node) or max(cell.level for cell in found.ideal.cells) == 0:
                yield from unreadable(state, found.blocks, normal, up, node.excused)

    def _reach_of_forms(self, node: Cells) -> float:
        """How much wider than the others a form of the figure may be: triangles with a right angle are."""
        return math.sqrt(2.0) if len(ideals(node, len(node.blocks))) > 1 else 1.0

    def _displaced(self, node: Cells, found: Found, edge: float, state: BlockState) -> Iterator[NearMiss]:
        """A block away from the figure, one out of its cell, the top layer missing."""
        cells = found.ideal.cells
        height = max(cell.level for cell in cells)
        top = [name for name, cell in zip(found.blocks, cells, strict=True) if cell.level == height]
        cx, cy = centroid(state, node.blocks)
        far = max(top, key=lambda name: math.dist(state.position[name][:2], (cx, cy)))
        yield NearMiss(f"{far} away from the figure", set_aside(state, far, clearance=0.2))
        dx, dy = state.position[far][0] - cx, state.position[far][1] - cy
        length = math.hypot(dx, dy)
        ux, uy = (dx / length, dy / length) if length > 1e-6 else (0.0, 1.0)
        if len(node.blocks) > 3:
            out = self._way_out(node, found, far, edge)
            yield NearMiss(f"{far} out of its cell", shift(state, [far], out * ux, out * uy))
        if height and len(top) > 1:
            gone = state
            for name in top:
                gone = set_aside(gone, name)
            yield NearMiss("the top layer missing", gone)
        if height == 0 and len(node.blocks) > 2:
            yield NearMiss(f"{far} a level higher", shift(state, [far], 0.0, 0.0, edge))

    def _way_out(self, node: Cells, found: Found, name: str, edge: float) -> float:
        """How far outwards a block must go to be past the tolerance after the figure has been fitted anew."""
        cells = found.ideal.cells
        cell = cells[found.blocks.index(name)]
        square = sum(c.x * c.x + c.y * c.y for c in cells) or 1.0
        stays = 1.0 - 1.0 / len(cells) - (cell.x * cell.x + cell.y * cell.y) / square
        if stays < 0.25 or len(ideals(node, len(cells))) > 1:
            return 3.0 * edge
        return PAST_SHARE * node.fit_edges * edge / stays + found.fit.deviation

    def _turned(self, node: Cells, found: Found, state: BlockState) -> Iterator[NearMiss]:
        """The figure turned away from the direction that it must have, or so that its rows lie along x."""
        limit = found.ideal.limit
        assert limit is not None
        centre = centroid(state, node.blocks)
        if limit == NAMED:
            turn = PAST_SHARE * limit + abs(math.degrees(found.fit.turn))
            yield NearMiss("the figure turned", spin(state, node.blocks, turn, centre))
        elif limit == NEAREST and not isinstance(node, Figure) and not self._same_when_turned(node, found):
            yield NearMiss("the figure turned", spin(state, node.blocks, 90.0, centre))

    def _same_when_turned(self, node: Cells, found: Found) -> bool:
        """Could rows and columns be as they must be after a quarter turn?"""
        kind = node.pattern.kind if node.pattern is not None else ""
        rows = len({cell.row for cell in found.ideal.cells})
        columns = len({cell.column for cell in found.ideal.cells})
        vertical = kind == "column" and any(cell.level for cell in found.ideal.cells)
        return rows == columns and (vertical or kind not in ("row", "column") or rows < 2)

    def _exchanged(self, node: Cells, found: Found, state: BlockState) -> Iterator[NearMiss]:
        """Two blocks whose exchange breaks the pattern."""
        pattern = node.pattern
        assert pattern is not None
        traits = Traits(state.world)
        blocks = found.blocks
        made = 0
        for i in range(len(blocks)):
            for j in range(i + 1, len(blocks)):
                if traits.world.look[blocks[i]] == traits.world.look[blocks[j]]:
                    continue
                changed = list(blocks)
                changed[i], changed[j] = changed[j], changed[i]
                if not follows(pattern, found.ideal, changed, traits):
                    yield NearMiss(f"{blocks[i]} and {blocks[j]} exchanged", swap(state, blocks[i], blocks[j]))
                    made += 1
                    break
            if made == 3:
                return


def _bridged(ideal: Ideal, blocks: Sequence[str], state: BlockState) -> bool:
    """Does every block rest on all those that a pyramid has below it? A column with a block beside it is near one."""
    pairs = resting(ideal)
    return all(lower is None or rests_on(state, blocks[upper], blocks[lower]) for upper, lower in pairs)


def hidden_cells(ideal: Ideal) -> list[bool]:
    """Which cells have neighbours on all sides and a layer above, so that nothing of them can be read."""
    cells = ideal.cells
    height = max(cell.level for cell in cells)
    ends = {
        level: (
            max(cell.row for cell in cells if cell.level == level),
            max(cell.column for cell in cells if cell.level == level),
        )
        for level in range(height + 1)
    }
    return [
        cell.level < height and 0 < cell.row < ends[cell.level][0] and 0 < cell.column < ends[cell.level][1]
        for cell in cells
    ]


def stretched(state: BlockState, names: Sequence[str], factor: float) -> BlockState:
    """`state` with blocks moved apart in the plane by `factor`, about their middle."""
    cx, cy = centroid(state, names)
    poses: Poses = {}
    for name in names:
        x, y, z = state.position[name]
        place = (cx + factor * (x - cx), cy + factor * (y - cy), z)
        poses[name] = (place, state.orientation.get(name, IDENTITY))
    return state.moved(poses)


CELLS = CellsPredicate()
TABLE: dict[str, Predicate[Any]] = dict.fromkeys(("grid", "pyramid", "staircase", "figure"), CELLS)
