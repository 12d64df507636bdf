"""Goal nodes as code: an atom is the call of the BlockTask method named as its kind, or its own constructor."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from pydantic import BaseModel

from rpg.ir import goal as g
from rpg.ir.node import Highest, Lowest, Node
from rpg.ir.stages import passed
from rpg.ir.walk import NAME_FIELDS
from rpg.passes.codegen.layout import Each, Expr, Group, Infix, Labelled, quoted

POSITIONAL = ("a", "b", "c", "block", "blocks", "groups", "patch", "region", "word")
"""Required fields that need no keyword: they come first and name what the atom is about."""


def _shown(record: BaseModel) -> Iterator[tuple[str, Any, bool]]:
    """Name, value and need of the fields that say something: not what the class or a default says already."""
    hidden = ("kind", "span") if isinstance(record, Node) else ("type",)
    for name, info in type(record).model_fields.items():
        value = getattr(record, name)
        if name not in hidden and (info.is_required() or value != info.default):
            yield name, value, info.is_required()


def arguments(record: BaseModel, bound: frozenset[str], positional: bool) -> tuple[Expr, ...]:
    """The fields of `record` that are not at their defaults, in the order of their definition."""
    places: list[Expr] = []
    keywords: list[Expr] = []
    for name, value, required in _shown(record):
        expr = literal(value, bound, name in NAME_FIELDS or name == "ranks")
        if positional and required and name in POSITIONAL and not keywords:
            places.append(expr)
        else:
            keywords.append(Labelled(f"{name}=", expr))
    return (*places, *keywords)


def literal(value: Any, bound: frozenset[str], is_name: bool = False) -> Expr:
    """Any field's value; names in `bound` are variables of a comprehension around it."""
    match value:
        case str():
            return value if is_name and value in bound else quoted(value)
        case Lowest(lowest=names):
            return Group("self.lowest", tuple(literal(n, bound, True) for n in names))
        case Highest(highest=names):
            return Group("self.highest", tuple(literal(n, bound, True) for n in names))
        case BaseModel():
            return Group(type(value).__name__, arguments(value, bound, positional=False))
        case tuple() if is_name and len(value) == 1 and isinstance(value[0], str):
            return literal(value[0], bound, True)
        case tuple():
            brackets = "[]" if is_name and value and all(isinstance(item, str) for item in value) else "()"
            return Group("", tuple(literal(item, bound, is_name) for item in value), brackets)
        case _:
            return repr(value)


def constructor(node: Any) -> Expr:
    """A goal as data: `On(a="red_block", b="yellow_block")`."""
    if isinstance(node, BaseModel):
        parts = tuple(Labelled(f"{name}=", constructor(value)) for name, value, _ in _shown(node))
        return Group(type(node).__name__, parts)
    if isinstance(node, tuple):
        if len(node) == 1 and isinstance(node[0], str):
            return quoted(node[0])
        names = bool(node) and all(isinstance(item, str) for item in node)
        return Group("", tuple(constructor(item) for item in node), "[]" if names else "()")
    return quoted(node) if isinstance(node, str) else repr(node)


def constructed(expr: Expr) -> Iterator[str]:
    """The record classes that `expr` constructs."""
    match expr:
        case Group(head, items, _):
            if head[:1].isupper():
                yield head
            for item in items:
                yield from constructed(item)
        case Labelled(_, value):
            yield from constructed(value)
        case Infix(_, operands):
            for operand in operands:
                yield from constructed(operand)
        case Each(element, _, source):
            yield from constructed(element)
            yield from constructed(source)


def inline(goal: g.Goal, bound: frozenset[str]) -> Expr:
    """A goal as one expression over `self`, for use inside a comprehension or a stage."""
    match goal:
        case g.All() | g.Any() if not goal.goals:
            return Group("self.count", ("[]", *(("at_least=1",) if isinstance(goal, g.Any) else ())))
        case g.All() | g.Any():
            parts = tuple(inline(part, bound) for part in goal.goals)
            return parts[0] if len(parts) == 1 else Infix("&" if isinstance(goal, g.All) else "|", parts)
        case g.Not():
            return Labelled("~", inline(goal.goal, bound))
        case g.Always():
            return Group("self.always", (inline(goal.goal, bound),))
        case g.Count():
            return count(goal, bound)
        case g.Sequence():
            stages = tuple(inline(stage.goal, bound) for stage in goal.stages)
            return Group("self.in_order", (*stages, *marks(goal)))
        case _:
            return Group(f"self.{goal.kind}", arguments(goal, bound, positional=True))


def count(goal: g.Count, bound: frozenset[str]) -> Expr:
    """`self.count([... for each in (...)], at_least=...)`."""
    source = Group("", tuple(quoted(name) for name in goal.over))
    each = Each(inline(goal.goal, bound | {goal.var}), goal.var, source)
    limits: list[Expr] = []
    if goal.at_least:
        limits.append(Labelled("at_least=", repr(goal.at_least)))
    if goal.at_most is not None:
        limits.append(Labelled("at_most=", repr(goal.at_most)))
    return Group("self.count", (each, *limits))


def marks(goal: g.Sequence) -> tuple[Expr, ...]:
    """The keywords that list which stages a later one undoes, and which are met on the way to another; nothing where
    there are none."""
    undone = tuple(str(index) for index, stage in enumerate(goal.stages) if stage.undone)
    on_the_way = tuple(map(str, passed(goal)))
    named = (("undone=", undone), ("passed=", on_the_way))
    return tuple(Labelled(keyword, Group("", listed)) for keyword, listed in named if listed)
