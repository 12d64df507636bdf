"""Random task schemas whose goals can be said in words."""

from __future__ import annotations

from collections.abc import Callable
from random import Random

from rpg.ir import goal as g
from rpg.ir.assets import Asset, Block, Color, ColoredCube, GoalPatch, SemanticCube
from rpg.ir.order import Order
from rpg.ir.schema import InitialState, TaskSchema
from rpg.passes.schema.resolve.goals.only_denied import still_ahead

COLORS: tuple[Color, ...] = ("red", "orange", "yellow", "green", "blue", "purple", "pink", "black", "white")
WORDS = ("CAT", "ROBOT", "HELLO", "UP", "BEE")


def random_schema(seed: int) -> TaskSchema:
    """A schema with one to three statements about blocks that it names once each."""
    rng = Random(seed)
    blocks = _blocks(rng)
    patches = [GoalPatch(name=f"{c}_patch", color=c) for c in rng.sample(COLORS, 2)]
    free = list(blocks)
    rng.shuffle(free)
    parts: list[g.Goal] = []
    used: list[Asset] = []
    for make in rng.sample(MAKERS, rng.choice((1, 1, 2, 3))):
        made = make(rng, free, patches)
        if made is not None:
            parts.append(made)
    goal = parts[0] if len(parts) == 1 else _joined(rng, parts)
    mentioned = {n for part in parts for n in _names(part)}
    used += [b for b in blocks if b.name in mentioned]
    used += [p for p in patches if p.name in mentioned]
    if not parts:
        return random_schema(seed + 10_000)
    return begun(TaskSchema(name="random", instruction="random", assets=tuple(used), goal=goal, init=InitialState()))


def begun(schema: TaskSchema) -> TaskSchema:
    """The schema with the start that the front end gives it: where a goal only denies something, that is so."""
    return schema.model_copy(update={"init": still_ahead(schema.goal, schema.init, schema.assets)[0]})


def _names(goal: g.Goal) -> tuple[str, ...]:
    from rpg.ir.walk import names

    return names(goal)


def _joined(rng: Random, parts: list[g.Goal]) -> g.Goal:
    return g.All(goals=tuple(parts))


def _blocks(rng: Random) -> list[Block]:
    """Plain blocks all unlike, some classes of look-alikes, some letters."""
    colors = rng.sample(COLORS, 6)
    blocks: list[Block] = [ColoredCube(name=f"{c}_block", color=c) for c in colors[:4]]
    for color in colors[4:]:
        count = rng.choice((2, 3, 4))
        blocks += [ColoredCube(name=f"{color}_block_{i}", color=color) for i in range(1, count + 1)]
    return blocks + [SemanticCube(name=f"{s}_block", label=s) for s in rng.sample("ABCDEFGH12345", 4)]


def _take(free: list[Block], count: int, *, single: bool = True) -> list[str] | None:
    """Names of `count` free blocks without look-alikes; they are free no more."""
    found = [b for b in free if not b.name[-1].isdigit()][:count]
    if len(found) < count:
        return None
    for block in found:
        free.remove(block)
    return [b.name for b in found]


def _class(free: list[Block]) -> list[str] | None:
    """All of one class of look-alikes."""
    stem = next((b.name[:-2] for b in free if b.name[-1].isdigit()), None)
    if stem is None:
        return None
    found = [b for b in free if b.name.startswith(stem)]
    for block in found:
        free.remove(block)
    return [b.name for b in sorted(found, key=lambda b: b.name)]


Maker = Callable[[Random, list[Block], list[GoalPatch]], g.Goal | None]


def _relation(rng: Random, free: list[Block], patches: list[GoalPatch]) -> g.Goal | None:
    names = _take(free, 2)
    if names is None:
        return None
    a, b = names
    kinds: list[Callable[[], g.Goal]] = [
        lambda: g.On(a=a, b=b), lambda: g.Beside(a=a, b=b), lambda: g.Adjacent(a=a, b=b), lambda: g.Touching(a=a, b=b),
        lambda: g.Near(a=a, b=b), lambda: g.LeftOf(a=a, b=b), lambda: g.RightOf(a=a, b=b, directly=True),
        lambda: g.Behind(a=a, b=b), lambda: g.InFrontOf(a=a, b=b, directly=True, immediate=True),
        lambda: g.LeftOf(a=a, b=b, somewhere=True),
        lambda: g.Distance(a=a, b=b, minimum=0.11, maximum=0.13), lambda: g.Distance(a=a, b=b, minimum=0.15),
        lambda: g.Swapped(a=a, b=b), lambda: g.Approached(a=a, b=b), lambda: g.Receded(a=a, b=b, at_least=0.05),
        lambda: g.TookPlace(a=a, b=b),
        lambda: g.Not(goal=g.Touching(a=a, b=b)), lambda: g.Not(goal=g.On(a=a, b=b)),
        lambda: g.Any(goals=(g.LeftOf(a=a, b=b), g.Behind(a=a, b=b))),
    ]  # fmt: skip
    return rng.choice(kinds)()


def _place(rng: Random, free: list[Block], patches: list[GoalPatch]) -> g.Goal | None:
    names = _take(free, 1)
    if names is None:
        return None
    (a,) = names
    kinds: list[Callable[[], g.Goal]] = [
        lambda: g.OnPatch(a=a, patch=patches[0].name), lambda: g.InRegion(a=a, region="left_half"),
        lambda: g.InRegion(a=a, region="middle"), lambda: g.InRegion(a=a, region="far_left_corner"),
        lambda: g.Stayed(a=a), lambda: g.Moved(a=a, at_least=0.1), lambda: g.Shifted(a=a, toward="left"),
        lambda: g.Shifted(a=a, toward="back", at_least=0.09, at_most=0.11, across=0.02), lambda: g.OnTable(a=a),
        lambda: g.Not(goal=g.OnPatch(a=a, patch=patches[1].name)),
        lambda: g.Turned(block=a, degrees=90.0), lambda: g.Turned(block=a, degrees=-45.0),
    ]  # fmt: skip
    return rng.choice(kinds)()


def _between(rng: Random, free: list[Block], patches: list[GoalPatch]) -> g.Goal | None:
    names = _take(free, 3)
    if names is None:
        return None
    a, b, c = names
    mat = patches[0].name
    kinds: list[Callable[[], g.Goal]] = [
        lambda: g.Between(a=a, b=b, c=c), lambda: g.Closer(a=a, b=b, c=c), lambda: g.Equidistant(a=a, b=b, c=c),
        lambda: g.Closer(a=mat, b=a, c=b), lambda: g.Equidistant(a=mat, b=a, c=b), lambda: g.Closer(a=a, b=mat, c=c),
        lambda: g.Not(goal=g.Closer(a=a, b=b, c=c)), lambda: g.Not(goal=g.Equidistant(a=a, b=b, c=c)),
        lambda: g.Closer(a=a, b=b, c=c, by=0.05), lambda: g.Equidistant(a=a, b=b, c=(c, mat)),
    ]  # fmt: skip
    return rng.choice(kinds)()


def _line(rng: Random, free: list[Block], patches: list[GoalPatch]) -> g.Goal | None:
    names = _take(free, rng.choice((3, 4)))
    if names is None:
        return None
    ranks = tuple((n,) for n in names)
    if rng.random() < 0.5:
        return g.Stack(blocks=tuple(names), order=Order(by="given", ranks=ranks))
    return g.Row(blocks=tuple(names), axis="y", order=Order(by="given", ranks=ranks, first="left"))


def _count(rng: Random, free: list[Block], patches: list[GoalPatch]) -> g.Goal | None:
    names = _class(free)
    if names is None:
        return None
    low = rng.randint(1, len(names) - 1) if len(names) > 2 else 1
    inner = g.OnPatch(a="each", patch=patches[0].name)
    high = rng.choice((low, None))
    return g.Count(over=tuple(names), at_least=low, at_most=high, goal=inner)


def _alike(rng: Random, free: list[Block], patches: list[GoalPatch]) -> g.Goal | None:
    names = _class(free)
    if names is None:
        return None
    blocks = tuple(names)
    kinds: list[Callable[[], g.Goal]] = [
        lambda: g.OnPatch(a=blocks, patch=patches[1].name), lambda: g.Stack(blocks=blocks),
        lambda: g.Stack(blocks=blocks, exact=True), lambda: g.InRegion(a=blocks, region="right_half"),
    ]  # fmt: skip
    return rng.choice(kinds)()


MAKERS: tuple[Maker, ...] = (_relation, _relation, _place, _place, _between, _line, _count, _alike)
