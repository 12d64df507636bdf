"""Generated files turned into classes, in a namespace that offers only what such files may use."""

from __future__ import annotations

import ast
import builtins
from collections.abc import Sequence
from types import SimpleNamespace
from typing import Any

import rpg.env
from rpg.env import BlockTask

ALLOWED_BUILTINS = (
    "abs", "all", "any", "bool", "dict", "enumerate", "float", "int", "len", "list", "max", "min", "range", "reversed",
    "round", "sorted", "str", "sum", "super", "tuple", "zip", "True", "False", "None",
)  # fmt: skip
"""Builtins that generated code may use; none of them reaches outside."""
MODULE = "rpg.env"


def load(code: str | ast.Module, goal_code: str | ast.Module) -> tuple[type[BlockTask], type[BlockTask]]:
    """The task class and its goal-state class, of sources or of what they parse to. Runs both files: only for code that
    is checked or confined."""
    task = _run(code, "code.py", {})
    goal = _run(goal_code, "goal_state_code.py", task)
    return _the_task(task, "code.py"), _the_task(goal, "goal_state_code.py")


def _run(code: str | ast.Module, filename: str, sibling: dict[str, Any]) -> dict[str, Any]:
    def imported(
        name: str, _globals: object = None, _locals: object = None, wanted: Sequence[str] = (), level: int = 0
    ) -> Any:
        if (name, level) == (MODULE, 0):
            return rpg.env
        if (name, level) == ("code", 1) and sibling:
            return SimpleNamespace(**sibling)
        raise ImportError(f"generated code imports from {MODULE} only, not from {'.' * level}{name}")

    allowed = {name: getattr(builtins, name) for name in ALLOWED_BUILTINS}
    space: dict[str, Any] = {
        "__builtins__": {**allowed, "__build_class__": builtins.__build_class__, "__import__": imported},
        "__name__": f"rpg_task_{filename.removesuffix('.py')}",
    }
    exec(compile(code, filename, "exec", dont_inherit=True), space)
    return space


def _the_task(space: dict[str, Any], filename: str) -> type[BlockTask]:
    found = [
        value
        for value in space.values()
        if isinstance(value, type) and issubclass(value, BlockTask) and value.__module__ == space["__name__"]
    ]
    if len(found) != 1:
        raise TypeError(f"{filename} must define exactly one BlockTask class, it defines {len(found)}")
    return found[0]
