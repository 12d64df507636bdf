"""Every number that a task has: counts, lengths, angles, digits."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from itertools import groupby

from pydantic import BaseModel

from rpg.ir.assets import EDGE, FACES, Asset, SemanticCube
from rpg.ir.goal import All, Count, Not
from rpg.ir.node import members
from rpg.ir.relations import Above, Clear, InRegion, On, Ranged, Shifted, Swapped
from rpg.ir.schema import EXCHANGED_LATER, TaskSchema
from rpg.ir.structures import Figure, Grid, GroupBy, Pyramid, Row, Spells, Stack, Staircase
from rpg.ir.walk import atoms, names

UNITS = (1.0, 10.0, 100.0, 1000.0, 1 / 0.0254, 1 / EDGE)
"""Lengths are told in metres, decimetres, centimetres, millimetres, inches or edges."""
LENGTHS = ("at_least", "distance")
"""Fields of goals that are said as often as not; of other fields only values that are not the default are."""


class Numbers:
    """Numbers, looked for as they are found."""

    def __init__(self, rest: Iterable[float]) -> None:
        self.rest, self.known = iter(rest), set[float]()

    def among(self, said: float) -> bool:
        """Whether one of them is the one that is said."""
        if any(abs(said - number) < 0.02 for number in self.known):
            return True
        for number in self.rest:
            self.known.add(number)
            if abs(said - number) < 0.02:
                return True
        return False


def symbols_of(asset: Asset) -> set[str]:
    """What a cube shows."""
    return {symbol for face in FACES if (symbol := asset.symbol(face))} if isinstance(asset, SemanticCube) else set()


KEYS: tuple[Callable[[Asset], object], ...] = (
    lambda asset: asset.color,
    lambda asset: asset.size,
    lambda asset: (asset.color, asset.size),
    lambda asset: (asset.color, type(asset)),
    lambda asset: tuple(sorted(symbols_of(asset))),
    lambda asset: [symbol.isdigit() for symbol in sorted(symbols_of(asset))],
)
"""What objects are counted by."""


def numbers_of(task: TaskSchema) -> Iterator[float]:
    """Every count, length (in all units), angle and digit of a task."""
    for objects in (task.assets, task.blocks, task.patches):
        yield len(objects)
        for key in KEYS:
            tally = Counter(repr(key(one)) for one in objects)
            yield from (len(tally), *tally.values())
    # "With three distractors", "all but three": what is left out has its number too.
    yield len(task.assets) - len(set(names(task.goal)))
    for asset in task.assets:
        yield from (float(symbol) for symbol in symbols_of(asset) if symbol.isdigit())
    for part in (task.goal, *task.init.arranged, *task.init.heaps):
        yield from _inside(part)
    parts = task.goal.goals if isinstance(task.goal, All) else (task.goal,)
    bounds = [part for part in parts if isinstance(part, Count) and isinstance(part.goal, Above)]
    yield from (part.at_most + 1 for part in bounds if part.at_most is not None)  # "no stack higher than two"
    counted = [part for part in parts if isinstance(part, Count) and part.at_least == part.at_most]
    yield from (len(part.over) - part.at_least for part in counted)  # "exactly two of them, the other three elsewhere"
    denied = [part.goal for part in parts if isinstance(part, Not)]
    yield from Counter((x.kind, getattr(x, "patch", getattr(x, "b", None))) for x in denied).values()  # "three off it"
    if task.assumed(EXCHANGED_LATER):
        yield 2  # of what was built before
    colors = {asset.name: asset.color for asset in task.assets}
    yield from (_piles(task), _rows(task))
    lines = [atom for atom in atoms(task.goal) if isinstance(atom, Row | Stack)]
    yield from Counter((type(line), len(line.blocks)) for line in lines).values()
    yield from Counter((line.kind, *map(colors.get, line.blocks)) for line in lines).values()  # "the last three red"
    yield sum(isinstance(atom, Spells) for atom in atoms(task.goal))  # "two words, CAT and DOG"
    alone = [atom for atom in atoms(task.goal) if isinstance(atom, Clear) and len(members(atom.a)) == 1]
    yield len(alone) + sum(isinstance(line, Stack) for line in lines)  # "three towers: 1, 2 and 4 blocks high"
    for line in lines:
        yield from Counter(map(colors.get, line.blocks)).values()  # "each of three red blocks and a blue one"
        if line.order.by == "given":  # "with three pink cubes on each side of it"
            yield from (len([*run]) for _, run in groupby(line.order.ranks, lambda rank: {*map(colors.get, rank)}))
    yield sum(isinstance(atom, InRegion) and atom.region.endswith("corner") for atom in atoms(task.goal))
    for atom in atoms(task.goal):
        if isinstance(atom, Figure) and atom.gap is not None:
            yield from _how_large(atom, max(asset.size for asset in task.blocks if asset.name in atom.blocks))
        if isinstance(atom, Grid) and atom.gap is not None:  # "7 cm between centres"
            yield from _inside(atom.gap + max(asset.size for asset in task.blocks if asset.name in atom.blocks))
        yield from Counter(colors.get(name) for name in set(names(atom))).values()  # "three of the six red blocks"
        if isinstance(atom, Swapped):
            yield len({*members(atom.a), *members(atom.b)})  # "swap the top two"
        if isinstance(atom, GroupBy):
            yield from (len(group) - atom.outliers for group in atom.groups)
            yield from (many for group in atom.groups for many in Counter(map(colors.get, group)).values())
        if isinstance(atom, Figure) and atom.shape == "T" and atom.sides is not None:
            yield from (side - 1 for side in atom.sides)  # its stem, without the middle of the bar
        if isinstance(atom, Figure) and atom.shape in ("plus", "X"):
            yield 4  # arms
        if isinstance(atom, Figure) and atom.shape == "circle" and atom.filled:
            yield len(atom.blocks) - 1  # around the one in the middle
        # The columns of stairs, the layers of a pyramid and the rows of a filled triangle have every height, or length,
        # up to the largest.
        if isinstance(atom, Figure) and atom.shape == "triangle" and atom.filled:
            yield from range(1, math.isqrt(2 * len(atom.blocks)) + 1)
        if isinstance(atom, Staircase | Pyramid):
            yield from range(1, (atom.steps if isinstance(atom, Staircase) else max(atom.base)) + 1)
        if isinstance(atom, Pyramid) and min(atom.base) > 1:
            yield from ((atom.base[0] - n) * (atom.base[1] - n) for n in range(min(atom.base)))  # "nine, four, one"


def _piles(task: TaskSchema) -> int:
    """How many towers there are at the start: "two towers, red on blue and green on white"."""
    begun = [part for part in task.init.arranged if isinstance(part, On)]
    above = {name for part in begun for name in members(part.a)}
    below = {name for part in begun for name in members(part.b)}
    return len(below - above) + sum(isinstance(part, Stack) for part in task.init.arranged)


def _rows(task: TaskSchema) -> int:
    """How many rows there are at the start."""
    return sum(isinstance(part, Row) for part in task.init.arranged)


def _how_large(figure: Figure, edge: float) -> Iterator[float]:
    """The distance of neighbours' centres in an outline, and the length of its side, in all units."""
    spacing = (figure.gap or 0.0) + edge
    yield from _inside(spacing)
    yield from _inside(
        spacing * len(figure.blocks) / {"square": 4, "triangle": 3}.get(figure.shape, len(figure.blocks))
    )


def edges_of(task: TaskSchema) -> set[float]:
    """The extents of all objects, in all units."""
    return {number for asset in task.assets for number in _inside(asset.size)}


def _inside(value: object) -> Iterator[float]:
    if isinstance(value, BaseModel):
        low, high = getattr(value, "minimum", None), getattr(value, "maximum", None)
        if isinstance(value, Shifted | Ranged):
            low, high = value.at_least, value.at_most
        if low is not None and high is not None:
            yield from (*_inside((low + high) / 2), *_inside((high - low) / 2))
        if isinstance(value, Row) and value.gap is not None:  # "gaps of at most 5 mm"
            yield from _inside(value.gap + value.tolerance)
        for name, field in type(value).model_fields.items():
            told = getattr(value, name)
            if name != "span" and (told != field.default or name in LENGTHS):
                yield from _inside(told)
    elif isinstance(value, str):
        yield from map(float, [value] if value.isdigit() else re.findall(r"\b\d+", value))
    elif isinstance(value, Sequence):
        yield len(value)
        sides = [item for item in value if isinstance(item, int)]
        if len(sides) == len(value):
            yield math.prod(sides)
        for item in value:
            yield from _inside(item)
    elif isinstance(value, int | float) and not isinstance(value, bool):
        yield from (abs(value) * factor for factor in UNITS)
