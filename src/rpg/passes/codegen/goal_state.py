"""Lowering of a goal path to the class that starts in the goal configuration, and back."""

from __future__ import annotations

import ast
import math
from collections.abc import Sequence
from typing import Any

from rpg.ir.artifact import Placement, Scene
from rpg.ir.schema import TaskSchema
from rpg.passes.codegen.layout import Expr, Group, Labelled, quoted, statement
from rpg.passes.codegen.naming import class_name

LEVEL = 1e-9
"""Quaternion parts below this count as none: the block stands level, and its pose is told by its yaw."""


def lower_goal(schema: TaskSchema, path: Sequence[Scene]) -> str:
    """The text of goal_state_code.py. All scenes but the last are passed through, so that stages and moves count."""
    name = class_name(schema.name)
    lines: list[str] = []
    for index, scene in enumerate(path):
        lines += [line for placement in scene for line in statement("", _place(placement), 2)]
        if index < len(path) - 1:
            lines.append("        self.waypoint()")
    return "\n".join(
        [
            f'"""A goal state of the task {schema.name}."""',
            "",
            f"from .code import {name}",
            "",
            "",
            f"class {name}Goal({name}):",
            f'    """{_summary(len(path))}"""',
            "",
            "    def _on_reset(self) -> None:",
            *lines,
            "",
        ]
    )


def _summary(scenes: int) -> str:
    if scenes == 1:
        return "Every block stands in a goal configuration."
    return "The start, the way through the stages, and every block in a goal configuration."


def _place(placement: Placement) -> Expr:
    position = Group("", tuple(repr(value) for value in placement.position))
    return Group("self.place", (quoted(placement.block), position, *_turn(placement)))


def _turn(placement: Placement) -> tuple[Expr, ...]:
    w, x, y, z = placement.orientation
    if abs(x) < LEVEL and abs(y) < LEVEL:
        yaw = round(2 * math.atan2(z, w), 6)
        return (Labelled("yaw=", repr(yaw)),) if yaw else ()
    return (Labelled("quat=", Group("", tuple(repr(value) for value in placement.orientation))),)


def read_goal(code: str) -> tuple[Scene, ...] | None:
    """The scenes that a goal-state file places, as `lower_goal` wrote them; None where it is written otherwise."""
    try:
        classes = [node for node in ast.parse(code).body if isinstance(node, ast.ClassDef)]
        method = next(node for node in classes[-1].body if isinstance(node, ast.FunctionDef))
        scenes: list[dict[str, Placement]] = [{}]
        for statement in method.body:
            name, arguments, keywords = _self_call(statement)
            if name == "waypoint":
                scenes.append(dict(scenes[-1]))
            elif name == "place":
                placement = _placement(*arguments, **keywords)
                scenes[-1][placement.block] = placement
            else:
                return None
    except (SyntaxError, ValueError, TypeError, IndexError, StopIteration, RecursionError):
        return None
    return tuple(tuple(scene.values()) for scene in scenes)


def _self_call(node: ast.stmt) -> tuple[str, list[Any], dict[str, Any]]:
    match node:
        case ast.Expr(
            value=ast.Call(func=ast.Attribute(value=ast.Name(id="self"), attr=name), args=args, keywords=keys)
        ):
            keywords = {str(key.arg): ast.literal_eval(key.value) for key in keys}
            return name, [ast.literal_eval(argument) for argument in args], keywords
    raise ValueError("not a call of the task's own method")


def _placement(
    block: str, position: tuple[float, float, float], *, yaw: float = 0.0, quat: tuple[float, ...] | None = None
) -> Placement:
    orientation = quat or (math.cos(yaw / 2), 0.0, 0.0, math.sin(yaw / 2))
    return Placement.model_validate({"block": block, "position": position, "orientation": orientation})
