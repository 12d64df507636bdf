"""The shape of a generated file: one import, one class, the hooks and nothing else."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from typing import Any

from rpg.core.diagnostics import Diagnostic
from rpg.passes.validate.findings import failure
from rpg.passes.validate.gates import grammar
from rpg.passes.validate.gates.surface import attributes, nearest, public_names

GOAL_FILE = "goal_state_code.py"
SETTABLE = frozenset({"instruction", "interchangeable"})
"""What BlockTask has for its subclasses to set; a class must not hide anything else of it."""
TOP_LEVEL = (ast.FunctionDef, ast.ClassDef, ast.ImportFrom)
PLAIN = (ast.Constant, ast.Tuple, ast.Load)


def check_shape(filename: str, tree: ast.Module, nodes: Iterable[ast.AST]) -> list[Diagnostic]:
    """Imports from the public module alone; exactly one class with the hooks of a task."""
    found = _inner(filename, tree, nodes)
    classes = []
    for node in tree.body:
        match node:
            case ast.ImportFrom():
                found += _import(filename, node)
            case ast.ClassDef():
                classes.append(node)
            case ast.Expr(value=ast.Constant(value=str())) | ast.Import():
                pass
            case _:
                found.append(_wrong(filename, node, "code outside of the task's class"))
    if len(classes) != 1:
        message = f"{filename} must define one class, it defines {len(classes)}"
        return [*found, failure("text", "code-shape", "api", message, file=filename)]
    return found + _class(filename, classes[0])


def _inner(filename: str, tree: ast.Module, nodes: Iterable[ast.AST]) -> list[Diagnostic]:
    """Functions, classes and imports anywhere but at the top of the file or, for functions, of its class."""
    places = {id(node) for node in tree.body}
    places |= {id(inner) for node in tree.body if isinstance(node, ast.ClassDef) for inner in node.body}
    return [
        _wrong(filename, node, "a function, class or import inside of another")
        for node in nodes
        if isinstance(node, TOP_LEVEL) and id(node) not in places
    ]


def _import(filename: str, node: ast.ImportFrom) -> list[Diagnostic]:
    found = []
    sibling = filename == GOAL_FILE and (node.level, node.module) == (1, "code")
    if not sibling and (node.level, node.module) != (0, "rpg.env"):
        module = "." * node.level + (node.module or "")
        message = f"{filename} imports from {module} in line {node.lineno}; generated code imports from rpg.env only"
        found.append(failure("text", "code-import", "api", message, file=filename, line=node.lineno, module=module))
        return found
    for alias in node.names:
        if not sibling and alias.name not in public_names():
            near = nearest(alias.name, public_names())
            message = f"{filename} imports {alias.name!r} in line {node.lineno}, which rpg.env does not have"
            hint = f"did you mean {near}?" if near else None
            facts: dict[str, Any] = {"file": filename, "line": node.lineno, "name": alias.name, "nearest": near}
            found.append(failure("text", "code-unknown-name", "api", message, hint=hint, **facts))
        if alias.asname and alias.asname.startswith("_"):
            found.append(_wrong(filename, node, "a private name for an import"))
    return found


def _class(filename: str, node: ast.ClassDef) -> list[Diagnostic]:
    found = []
    if node.keywords or node.decorator_list or len(node.bases) != 1 or not isinstance(node.bases[0], ast.Name):
        found.append(_wrong(filename, node, "a class that is not a plain subclass of its task"))
    elif filename != GOAL_FILE and node.bases[0].id != "BlockTask":
        found.append(_wrong(filename, node, f"a class that extends {node.bases[0].id} instead of BlockTask"))
    hooks = [inner.name for inner in node.body if isinstance(inner, ast.FunctionDef)]
    for inner in node.body:
        if isinstance(inner, ast.FunctionDef):
            found += _method(filename, inner)
        elif not _is_plain(inner):
            found.append(_wrong(filename, inner, "a statement in the class that is neither a method nor a plain value"))
    required = ("_on_reset",) if filename == GOAL_FILE else grammar.REQUIRED_HOOKS
    for hook in required:
        if hook not in hooks:
            message = f"{filename}: the class {node.name} has no method {hook}"
            found.append(failure("text", "code-shape", "api", message, file=filename, line=node.lineno, missing=hook))
    return found


def _is_plain(node: ast.stmt) -> bool:
    """A docstring, or a plain value under a public name."""
    match node:
        case ast.Expr(value=ast.Constant(value=str())) | ast.Pass():
            return True
        case (
            ast.Assign(targets=[ast.Name(id=name)], value=value) | ast.AnnAssign(target=ast.Name(id=name), value=value)
        ):
            if name.startswith("_") or value is None or name in attributes() - SETTABLE:
                return False
            return all(isinstance(part, PLAIN) for part in ast.walk(value))
    return False


def _method(filename: str, node: ast.FunctionDef) -> list[Diagnostic]:
    found = []
    if node.name not in grammar.HOOKS:
        near = nearest(node.name, grammar.HOOKS)
        message = (
            f"{filename} defines a method {node.name} in line {node.lineno}; a task has {', '.join(grammar.HOOKS)}"
        )
        hint = f"did you mean {near}?" if near else None
        facts: dict[str, Any] = {"file": filename, "line": node.lineno, "name": node.name, "nearest": near}
        found.append(failure("text", "code-unknown-hook", "api", message, hint=hint, **facts))
    arguments = node.args
    names = [argument.arg for argument in (*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs)]
    if names != ["self"] or arguments.vararg or arguments.kwarg or arguments.defaults or node.decorator_list:
        found.append(_wrong(filename, node, f"arguments or decorators of {node.name}, which takes self alone"))
    return found


def _wrong(filename: str, node: ast.stmt, text: str) -> Diagnostic:
    message = f"{filename} has {text} in line {node.lineno}"
    return failure("text", "code-shape", "api", message, file=filename, line=node.lineno)
