"""Deterministic lowering of a task schema to the class that runs it."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.blocks.state import World
from rpg.blocks.symmetry import interchangeable
from rpg.ir import goal as g
from rpg.ir.schema import InitialState, Start, TaskSchema
from rpg.ir.walk import names
from rpg.passes.codegen.calls import arguments, constructed, constructor
from rpg.passes.codegen.layout import Expr, Group, Infix, Labelled, long_string, quoted, statement
from rpg.passes.codegen.naming import class_name
from rpg.passes.codegen.sharing import replaced, shared
from rpg.passes.codegen.specification import docstring
from rpg.passes.codegen.success import Success, looks_over_time

MODULE = "rpg.env"
"""The one public module that generated code imports from."""


def lower(schema: TaskSchema) -> str:
    """The text of code.py: byte-identical for equal schemas."""
    success = Success(schema.goal)
    check = success.check
    blocks = tuple(block.name for block in schema.blocks)
    assets = [Group(type(asset).__name__, arguments(asset, frozenset(), positional=False)) for asset in schema.assets]
    reset, conditions = on_reset(schema.init, blocks), success.bindings
    lists = shared((*reset, *conditions.values()), blocks, conditions)
    if lists:
        reset = [replaced(call, lists) for call in reset]
        conditions = {name: replaced(expr, lists) for name, expr in conditions.items()}
    body = [
        *docstring(schema, check),
        "",
        *long_string("instruction = ", schema.instruction, 1),
        *_constants(schema, lists),
        "",
        *method("_initialize_env", "None", [line for asset in assets for line in _call("self.add", asset)]),
        "",
        *method("_on_reset", "None", [line for call in reset for line in statement("", call, 2)]),
        "",
        *method("_success", "Verdict", _success_lines(conditions, check)),
        *_fail_lines(schema.goal),
    ]
    used = {name for expr in (*assets, *reset, *conditions.values()) for name in constructed(expr)}
    header = [
        f'"""The task {schema.name}, generated from its task.yaml."""',
        "",
        *imports(("BlockTask", "Verdict", *used)),
    ]
    return "\n".join([*header, "", "", f"class {class_name(schema.name)}(BlockTask):", *body]) + "\n"


def _constants(schema: TaskSchema, lists: dict[tuple[str, ...], str]) -> list[str]:
    """Attributes of the class: look-alikes that the goal tells apart, and lists that are used more than once."""
    cells = interchangeable(schema.goal, World(schema.assets))
    lines = statement("interchangeable = ", _nested(cells), 1) if cells else []
    for members, attribute in lists.items():
        lines += statement(f"{attribute} = ", Group("", members), 1)
    return lines


def imports(classes: Sequence[str]) -> list[str]:
    """The import of `classes` from the public module in alphabetical order."""
    listed = tuple(sorted(set(classes)))
    flat = f"from {MODULE} import {', '.join(listed)}"
    if len(flat) <= 100:
        return [flat]
    return [f"from {MODULE} import (", *(f"    {name}," for name in listed), ")"]


def method(name: str, result: str, lines: Sequence[str]) -> list[str]:
    """A method of no arguments."""
    return [f"    def {name}(self) -> {result}:", *lines]


def _call(head: str, argument: Expr) -> list[str]:
    return statement("", Group(head, (argument,)), 2)


def on_reset(init: InitialState, blocks: tuple[str, ...]) -> list[Expr]:
    """The calls that sample the initial state; blocks that nothing else places are scattered."""
    calls: list[Expr] = []
    if init.arranged:
        calls.append(Group("self.arrange", tuple(constructor(goal) for goal in init.arranged)))
    calls += [Group("self.heap", tuple(quoted(name) for name in heap)) for heap in init.heaps]
    calls += [_start(pose) for pose in init.poses]
    placed = _placed(init)
    free = tuple(name for name in blocks if name not in placed)
    if free:
        calls.append(Group("self.scatter", tuple(quoted(name) for name in free)))
    calls += [Group("self.keep_free", arguments(vacancy, frozenset(), positional=False)) for vacancy in init.vacant]
    return calls or ["pass"]


def _placed(init: InitialState) -> frozenset[str]:
    arranged = {name for goal in init.arranged for name in names(goal)}
    heaped = {name for heap in init.heaps for name in heap}
    return frozenset(arranged | heaped | {pose.block for pose in init.poses})


def _start(pose: Start) -> Expr:
    x, y = pose.position
    extras: list[Expr] = []
    if pose.yaw:
        extras.append(Labelled("yaw=", repr(pose.yaw)))
    if pose.jitter:
        extras.append(Labelled("jitter=", repr(pose.jitter)))
    return Group("self.start", (quoted(pose.block), Group("", (repr(x), repr(y))), *extras))


def _nested(value: object) -> Expr:
    if isinstance(value, tuple):
        return Group("", tuple(_nested(item) for item in value))
    return quoted(str(value))


def _success_lines(conditions: dict[str, Expr], check: Expr) -> list[str]:
    lines = [line for name, expr in conditions.items() for line in statement(f"{name} = ", expr, 2)]
    return [
        *lines,
        *statement("at_rest = ", "self.at_rest()", 2),
        *statement("_success_check = ", _and_rest(check), 2),
        "        return _success_check",
    ]


def _and_rest(check: Expr) -> Expr:
    if isinstance(check, Infix) and check.operator == "&":
        return Infix("&", (*check.operands, "at_rest"))
    return Infix("&", (check, "at_rest"))


def _fail_lines(goal: g.Goal) -> list[str]:
    """Tasks with stages or standing conditions can be lost before the end."""
    sequence, always = looks_over_time(goal)
    parts = [*(["self.out_of_order()"] if sequence else []), *(["self.lapsed()"] if always else [])]
    if not parts:
        return []
    return [
        "",
        *method("_fail", "Verdict", [f"        _fail_check = {' | '.join(parts)}", "        return _fail_check"]),
    ]
