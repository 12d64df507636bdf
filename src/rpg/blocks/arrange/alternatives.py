"""A goal as alternatives: conjunctions of atoms that hold and atoms that must not."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations, islice, product
from typing import NamedTuple

from rpg.blocks.predicates.facing import directions
from rpg.blocks.predicates.region import CORNERS
from rpg.blocks.state import Look, World
from rpg.ir import goal as g
from rpg.ir.node import Highest, Lowest, members
from rpg.ir.relations import (
    Above,
    Adjacent,
    Apart,
    Behind,
    Beside,
    Between,
    Clear,
    Closer,
    Empty,
    Facing,
    InFrontOf,
    InRegion,
    LeftOf,
    Moved,
    On,
    OnPatch,
    OnTable,
    RightOf,
    Shifted,
    Stayed,
    Touching,
)
from rpg.ir.structures import Row
from rpg.ir.walk import instances


class Literal(NamedTuple):
    """An atom, and whether it must hold. `hint`: what proposes places for it, if not the atom itself."""

    atom: g.Atom
    holds: bool = True
    hint: g.Atom | None = None


class _At(NamedTuple):
    block: str
    place: str
    holds: bool


MOST_CHOICES = 2000
"""Choices of blocks that a count is looked through for."""
Conjunction = tuple[Literal, ...]


def alternatives(goal: g.Goal, world: World, wanted: bool = True) -> Iterator[Conjunction]:
    """Every conjunction of literals that makes `goal` true (or, where not `wanted`, false), most natural first.

    Of choices among blocks that look alike, one comes before the others.
    """
    match goal:
        case g.All():
            yield from _all(goal.goals, world, wanted) if wanted else _any(goal.goals, world, wanted)
        case g.Any():
            yield from _any(goal.goals, world, wanted) if wanted else _all(goal.goals, world, wanted)
        case g.Not():
            yield from alternatives(goal.goal, world, not wanted)
        case g.Always():
            yield from alternatives(goal.goal, world, wanted)
        case g.Sequence():
            final = g.All(goals=tuple(stage.goal for stage in goal.stages if not stage.undone))
            yield from alternatives(final, world, wanted)
        case g.Count():
            yield from _count(goal, world, wanted)
        case On() if wanted:
            yield from _pairings(goal)
        case Touching() if wanted:
            yield (Literal(goal),)
            yield from _stacked(goal)
        case Between() if wanted:
            yield (Literal(goal),)
            yield from _sandwiched(goal, world)
        case Above() if wanted:
            yield (Literal(goal),)
            yield from _carried(goal, world)
        case Facing(toward="viewer") if wanted:
            yield from ((Literal(goal.model_copy(update={"toward": toward})),) for toward in directions(goal))
        case Clear() | Empty() | OnTable() if not wanted:
            yield from _spoilt(goal, world)
        case _:
            yield (Literal(goal, wanted),)


def lies_flat(literals: Conjunction) -> bool:
    """Does no block of a line, or of two side by side, have to be on another one of it? They are to stand on one
    level."""
    wanted = [literal.atom for literal in literals if literal.holds]
    levels = [level for atom in wanted if (level := _level(atom))]
    pairs = [set(members(atom.a) + members(atom.b)) for atom in wanted if isinstance(atom, On) and levels]
    return not any(pair <= level for pair in pairs for level in levels)


def _level(atom: g.Atom) -> set[str]:
    """Blocks that have to stand on one level by an atom."""
    if isinstance(atom, Row):
        return set(atom.blocks)
    pair = {*members(atom.a), *members(atom.b)} if isinstance(atom, Beside | Adjacent) else set()
    return pair if len(pair) == 2 else set()


def single(literals: Conjunction) -> Conjunction:
    """The literals with conditions on groups said block by block, so that each can be judged as soon as it is placed.

    What must lie on one patch or in one region is joined as a hint, so that places for all of it are proposed together.
    """
    together: dict[str, dict[str, None]] = {}
    for atom, holds, _ in literals:
        if holds and isinstance(atom, OnPatch | InRegion):
            together.setdefault(_place(atom), {}).update(dict.fromkeys(members(atom.a)))
    found: list[Literal] = []
    for literal in literals:
        parts = list(_parts(literal.atom)) if literal.holds else []
        for part in parts or [literal.atom]:
            hint = None
            if parts and isinstance(part, OnPatch | InRegion):
                hint = part.model_copy(update={"a": tuple(together[_place(part)])})
            found.append(Literal(part, literal.holds, hint))
    return tuple(found)


def _place(atom: OnPatch | InRegion) -> str:
    return atom.patch if isinstance(atom, OnPatch) else f"region {atom.region}"


def _parts(atom: g.Atom) -> Iterator[g.Atom]:
    """An atom about groups as atoms about single blocks, where it is a plain conjunction of those."""
    match atom:
        case OnPatch() | InRegion() | OnTable() | Stayed() | Moved() | Shifted() | Clear():
            if not isinstance(atom.a, Lowest | Highest):
                yield from (atom.model_copy(update={"a": (name,)}) for name in atom.a)
        case LeftOf() | RightOf() | InFrontOf() | Behind() | Apart():
            grouped = not isinstance(atom.a, Lowest | Highest) and not isinstance(atom.b, Lowest | Highest)
            pairs = [(a, b) for a in members(atom.a) for b in members(atom.b) if a != b] if grouped else []
            whole = not isinstance(atom, Apart) and (atom.immediate or (atom.directly and len(members(atom.b)) > 1))
            if len(pairs) > 1 and not whole:
                loose = {} if isinstance(atom, Apart) else {"somewhere": True}
                yield from (atom.model_copy(update={"a": (a,), "b": (b,), **loose}) for a, b in pairs)
        case Closer():
            if not any(isinstance(operand, Lowest | Highest) for operand in (atom.a, atom.b, atom.c)):
                triples = product(members(atom.a), members(atom.b), members(atom.c))
                yield from (atom.model_copy(update={"a": (a,), "b": (b,), "c": (c,)}) for a, b, c in triples)
        case _:
            return


def _all(
    goals: tuple[g.Goal, ...], world: World, wanted: bool, before: frozenset[_At] = frozenset()
) -> Iterator[Conjunction]:
    if not goals:
        yield ()
        return
    for first in alternatives(goals[0], world, wanted):
        there = before.union(*map(_at, first))
        if len(there) == len(before) or _possible(there):
            for rest in _all(goals[1:], world, wanted, there):
                yield first + rest


def _at(literal: Literal) -> Iterator[_At]:
    """Where single blocks are or are not, as far as one place rules the other ones out: patches, corners."""
    atom = literal.atom
    if not isinstance(atom, OnPatch | InRegion) or isinstance(atom.a, Lowest | Highest):
        return
    exclusive = isinstance(atom, OnPatch) or atom.region in CORNERS
    if exclusive and (literal.holds or len(atom.a) == 1):
        yield from (_At(name, _place(atom), literal.holds) for name in atom.a)


def _possible(there: Iterable[_At]) -> bool:
    """Is no block at two places, or where it must not be?"""
    found = {at.block: at.place for at in there if at.holds}
    return all((found.get(at.block) == at.place) == at.holds for at in there)


def _any(goals: tuple[g.Goal, ...], world: World, wanted: bool) -> Iterator[Conjunction]:
    for goal in goals:
        yield from alternatives(goal, world, wanted)


def _count(count: g.Count, world: World, wanted: bool) -> Iterator[Conjunction]:
    total = len(count.over)
    low, high = count.at_least, total if count.at_most is None else min(count.at_most, total)
    allowed = range(low, high + 1)
    sizes = [k for k in range(total + 1) if (k in allowed) == wanted]
    if wanted and low == 0 and not isinstance(count.goal, Above):  # how high stacks may be at most asks for none
        sizes.reverse()
    open_ended = wanted and high == total
    each = instances(count)
    for size in [low] if open_ended and low <= total else sizes:
        for chosen in _unlike_first(count.over, size, world):
            others = () if open_ended else (g.Not(goal=each[k]) for k in range(total) if k not in chosen)
            yield from _all((*(each[k] for k in chosen), *others), world, True)


def _unlike_first(names: Sequence[str], size: int, world: World) -> Iterator[tuple[int, ...]]:
    """Every choice of so many of the names, by index; those that look like an earlier choice come last."""
    seen: set[tuple[Look, ...]] = set()
    later = []
    for chosen in islice(combinations(range(len(names)), size), MOST_CHOICES):
        looks = tuple(sorted(world.look.get(names[k], (names[k],)) for k in chosen))
        if looks in seen:
            later.append(chosen)
        else:
            seen.add(looks)
            yield chosen
    yield from later


def _spoilt(atom: Clear | Empty | OnTable, world: World) -> Iterator[Conjunction]:
    """Ways to spoil a condition that takes another block to spoil: it is on what must not be clear, or empty."""
    if isinstance(atom, Empty):
        yield from ((Literal(OnPatch(a=(name,), patch=atom.patch)),) for name in world.blocks)
        return
    for name in members(atom.a):
        pairs = (((name,), (other,)) if isinstance(atom, OnTable) else ((other,), (name,)) for other in world.blocks)
        yield from ((Literal(On(a=a, b=b)),) for a, b in pairs if a != b)


def _stacked(touching: Touching) -> Iterator[Conjunction]:
    """Touching by lying one on the other."""
    a, b = touching.a, touching.b
    if not any(isinstance(end, Lowest | Highest) or len(end) > 1 for end in (a, b)):
        yield Literal(touching), Literal(On(a=a, b=b))
        yield Literal(touching), Literal(On(a=b, b=a))


def _sandwiched(between: Between, world: World) -> Iterator[Conjunction]:
    """Between in a tower: one of the ends below, the other one above."""
    if any(isinstance(end, Lowest | Highest) or len(end) > 1 for end in (between.a, between.b, between.c)):
        return
    if not world.blocks.keys() >= {*members(between.a), *members(between.b), *members(between.c)}:
        return
    for low, high in ((between.b, between.c), (between.c, between.b)):
        yield Literal(On(a=between.a, b=low)), Literal(On(a=high, b=between.a))


def _carried(above: Above, world: World) -> Iterator[Conjunction]:
    """Above with a block between, where it must not be directly on it."""
    a, b = above.a, above.b
    if not any(isinstance(end, Lowest | Highest) or len(end) > 1 for end in (a, b)):
        others = [name for name in world.blocks if name not in (*members(a), *members(b))]
        for (k,) in _unlike_first(others, 1, world):
            yield Literal(On(a=a, b=(others[k],))), Literal(On(a=(others[k],), b=b))


def _pairings(on: On) -> Iterator[Conjunction]:
    """Groups on groups: each of `a` on one of `b`."""
    if isinstance(on.a, Lowest | Highest) or isinstance(on.b, Lowest | Highest):
        yield (Literal(on),)
        return
    above, below = members(on.a), members(on.b)
    for k in range(len(below) ** len(above)):
        pairs = []
        for a in above:
            k, index = divmod(k, len(below))
            pairs.append(Literal(on.model_copy(update={"a": (a,), "b": (below[index],)})))
        yield tuple(pairs)
