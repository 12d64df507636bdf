"""Folds and rewrites over goal expressions."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cache, lru_cache
from itertools import chain
from operator import is_
from typing import Any as AnyType
from typing import get_args

from pydantic import BaseModel

from rpg.ir import goal as g
from rpg.ir.node import Highest, Lowest, Node, members
from rpg.ir.order import Pattern

ATOMS: tuple[type[Node], ...] = get_args(g.Atom)
NAME_FIELDS = (
    "a",
    "b",
    "c",
    "block",
    "blocks",
    "patch",
    "over",
    "groups",
    "matching",
    "order",
    "pattern",
    "excused",
    "covered",
    "beside",
)


_CHILDREN: dict[type, Callable[[AnyType], tuple[g.Goal, ...]]] = {
    **dict.fromkeys((g.All, g.Any), lambda goal: goal.goals),
    **dict.fromkeys((g.Not, g.Always, g.Count), lambda goal: (goal.goal,)),
    g.Sequence: lambda goal: tuple(stage.goal for stage in goal.stages),
}


def children(goal: g.Goal) -> tuple[g.Goal, ...]:
    """The goals directly inside a connective; empty for atoms."""
    inside = _CHILDREN.get(type(goal))
    return inside(goal) if inside is not None else ()


def conjuncts(goal: g.Goal) -> tuple[g.Goal, ...]:
    """The parts of a conjunction; a goal that is none is its own only part."""
    return tuple(part for each in goal.goals for part in conjuncts(each)) if isinstance(goal, g.All) else (goal,)


def within(goal: g.Goal) -> Iterator[g.Goal]:
    """The goal and all goals inside it, connectives and atoms, in order of reading."""
    yield goal
    for child in children(goal):
        yield from within(child)


def rebuild(goal: g.Goal, new: tuple[g.Goal, ...]) -> g.Goal:
    """`goal` with `new` in place of its children."""
    match goal:
        case g.All() | g.Any():
            return goal.model_copy(update={"goals": new})
        case g.Not() | g.Always() | g.Count():
            return goal.model_copy(update={"goal": new[0]})
        case g.Sequence():
            stages = tuple(s.model_copy(update={"goal": n}) for s, n in zip(goal.stages, new, strict=True))
            return goal.model_copy(update={"stages": stages})
        case _:
            return goal


def atoms(goal: g.Goal) -> Iterator[g.Atom]:
    """Every atom, in order of reading."""
    inner = children(goal)
    if not inner and isinstance(goal, ATOMS):
        yield goal  # type: ignore[misc]
    for child in inner:
        yield from atoms(child)


def transform(goal: g.Goal, change: Callable[[g.Goal], g.Goal]) -> g.Goal:
    """Apply `change` to every node, leaves first."""
    inner = children(goal)
    if inner:
        new = tuple([transform(child, change) for child in inner])
        goal = goal if all(map(is_, new, inner)) else rebuild(goal, new)
    return change(goal)


def without_span(node: g.Goal) -> g.Goal:
    """The node alone without its place in the instruction."""
    return node if node.span is None else node.model_copy(update={"span": None})


def plain(goal: g.Goal) -> g.Goal:
    """What `goal` says: without its spans, conjunctions within conjunctions and choices within choices opened up."""

    def change(node: g.Goal) -> g.Goal:
        if isinstance(node, g.All | g.Any):
            kind, nested = type(node), (opened(part, type(node)) for part in node.goals)
            parts = tuple(part for found in nested for part in found)
            return parts[0] if len(parts) == 1 else kind(goals=parts)
        return without_span(node)

    def opened(part: g.Goal, kind: type[g.All] | type[g.Any]) -> tuple[g.Goal, ...]:
        return part.goals if isinstance(part, kind) else (part,)

    return transform(goal, change)


def names(goal: g.Goal) -> tuple[str, ...]:
    """Every object a goal mentions, each once, in order of first mention; bound variables are left out."""
    found: dict[str, None] = {}
    _collect(goal, found, frozenset())
    return tuple(found)


def _collect(goal: g.Goal, found: dict[str, None], bound: frozenset[str]) -> None:
    inner = children(goal)
    if isinstance(goal, g.Count):
        found.update(dict.fromkeys(goal.over))
        bound = bound | {goal.var}
    elif not inner:
        for field in _name_fields(type(goal)):
            value = getattr(goal, field)
            for name in () if value is None else _names_in(value):
                if name not in bound:
                    found[name] = None
    for child in inner:
        _collect(child, found, bound)


@cache
def _name_fields(kind: type[Node]) -> tuple[str, ...]:
    """The fields of a node that name objects."""
    return tuple(field for field in NAME_FIELDS if field in kind.model_fields)


def _names_in(value: AnyType) -> Iterable[str]:
    if type(value) is tuple and all(type(item) is str for item in value):
        return value
    if isinstance(value, str):
        return (value,)
    if isinstance(value, Lowest | Highest):
        return members(value)
    if isinstance(value, BaseModel):
        return _names_in(value.order if isinstance(value, Pattern) else getattr(value, "ranks", ()))
    return chain.from_iterable(map(_names_in, value))


def rename(goal: g.Goal, mapping: Mapping[str, str]) -> g.Goal:
    """`goal` with every object name replaced by `mapping` where it has an entry."""
    if not mapping:
        return goal

    def change(node: g.Goal) -> g.Goal:
        update: dict[str, AnyType] = {}
        for field in _name_fields(type(node)):
            value = getattr(node, field)
            if value is not None:
                new = _renamed(value, mapping)
                if new != value:
                    update[field] = new
        return node.model_copy(update=update) if update else node

    return transform(goal, change)


def _renamed(value: AnyType, mapping: Mapping[str, str]) -> AnyType:
    if isinstance(value, str):
        return mapping.get(value, value)
    if isinstance(value, Lowest):
        return Lowest(lowest=_renamed(value.lowest, mapping))
    if isinstance(value, Highest):
        return Highest(highest=_renamed(value.highest, mapping))
    if isinstance(value, Pattern):
        return value.model_copy(update={"order": _renamed(value.order, mapping)})
    if isinstance(value, BaseModel):
        return value.model_copy(update={"ranks": _renamed(getattr(value, "ranks", ()), mapping)})
    return tuple(_renamed(item, mapping) for item in value)


@lru_cache(maxsize=64)
def instances(count: g.Count) -> tuple[g.Goal, ...]:
    """The goals that a `Count` counts, one per block of `over`; a count is judged on state after state."""
    return tuple(rename(count.goal, {count.var: name}) for name in count.over)
