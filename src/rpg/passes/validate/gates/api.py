"""API use: names, attributes and calls of a generated file against what is really there."""

from __future__ import annotations

import ast
import inspect
from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import Any

from rpg.core.diagnostics import Diagnostic
from rpg.passes.validate.findings import failure
from rpg.passes.validate.gates import grammar
from rpg.passes.validate.gates.surface import attributes, fields, methods, nearest, public_names
from rpg.passes.validate.load import ALLOWED_BUILTINS


def check_api(filename: str, nodes: Iterable[ast.AST]) -> list[Diagnostic]:
    """Unknown names, methods and keywords in the nodes of a file, each with the nearest that exists."""
    checker = _Checker(filename, nodes)
    return [*checker.names(), *checker.members(), *checker.calls()]


class _Checker:
    def __init__(self, filename: str, nodes: Iterable[ast.AST]) -> None:
        self.filename = filename
        self.imported: set[str] = set()
        self.classes: set[str] = set()
        self.constants: set[str] = set()
        self.name_nodes: list[ast.Name] = []
        self.attribute_nodes: list[ast.Attribute] = []
        self.call_nodes: list[ast.Call] = []
        for node in nodes:
            match node:
                case ast.Name():
                    self.name_nodes.append(node)
                case ast.Attribute():
                    self.attribute_nodes.append(node)
                case ast.Call():
                    self.call_nodes.append(node)
                case ast.ImportFrom():
                    self.imported.update(alias.asname or alias.name for alias in node.names)
                case ast.ClassDef():
                    self.classes.add(node.name)
                    self.constants.update(plain_names(node))

    def _found(
        self, code: str, node: ast.expr | ast.keyword, name: str, message: str, known: Iterable[str]
    ) -> Diagnostic:
        near = nearest(name, known)
        text = f"{self.filename}, line {node.lineno}: {message}"
        facts: dict[str, Any] = {"file": self.filename, "line": node.lineno, "name": name, "nearest": near}
        return failure("text", code, "api", text, hint=f"did you mean {near}?" if near else None, **facts)

    def names(self) -> Iterator[Diagnostic]:
        """Names that nothing defines, or that are not for tasks."""
        stored = {node.id for node in self.name_nodes if isinstance(node.ctx, ast.Store)}
        known = stored | self.classes | self.imported | set(ALLOWED_BUILTINS) | {"self"}
        for node in self.name_nodes:
            if node.id.startswith("__"):
                yield self._found("code-forbidden", node, node.id, f"{node.id} is not for tasks", ())
            elif node.id not in known and node.id in public_names():
                yield self._found("code-unknown-name", node, node.id, f"{node.id} is not imported from rpg.env", ())
            elif node.id not in known:
                yield self._found("code-unknown-name", node, node.id, f"the name {node.id!r} is not defined", known)
            elif isinstance(node.ctx, ast.Store) and (node.id in ALLOWED_BUILTINS or node.id == "self"):
                yield self._found("code-forbidden", node, node.id, f"{node.id!r} is given another meaning", ())

    def members(self) -> Iterator[Diagnostic]:
        """Attributes that do not exist, or that lead out of the task."""
        own = {node.attr for node in self.attribute_nodes if isinstance(node.ctx, ast.Store) and _is_self(node.value)}
        of_task = attributes() | own | self.constants
        for node in self.attribute_nodes:
            if _is_super(node.value):
                allowed: Iterable[str] = grammar.HOOKS
            elif _is_self(node.value):
                allowed = of_task
            else:
                allowed = grammar.ORDINARY_ATTRIBUTES
            writes = isinstance(node.ctx, ast.Store) and (not _is_self(node.value) or node.attr in attributes())
            if writes or node.attr not in allowed or (node.attr.startswith("_") and not _is_super(node.value)):
                owner = "the task" if _is_self(node.value) else "this value"
                message = f"{owner} has no attribute {node.attr!r} that a task may {'set' if writes else 'use'}"
                yield self._found("code-unknown-attribute", node, node.attr, message, allowed)

    def calls(self) -> Iterator[Diagnostic]:
        """Calls whose arguments do not fit."""
        for node in self.call_nodes:
            match node.func:
                case ast.Attribute(value=value, attr=name) if _is_self(value) and name in methods():
                    yield from self._signature(node, name, methods()[name])
                case ast.Name(id=name) if name in fields() and name in self.imported:
                    yield from self._record(node, name)

    def _signature(self, node: ast.Call, name: str, signature: inspect.Signature) -> Iterator[Diagnostic]:
        keywords = [keyword.arg for keyword in node.keywords if keyword.arg]
        if any(isinstance(argument, ast.Starred) for argument in node.args) or len(keywords) < len(node.keywords):
            return
        known = signature.parameters
        open_ended = any(p.kind is inspect.Parameter.VAR_KEYWORD for p in known.values())
        wrong = [] if open_ended else [keyword for keyword in keywords if keyword not in known]
        for keyword in wrong:
            yield self._found("code-bad-call", node, keyword, f"self.{name} takes no argument {keyword!r}", known)
        if wrong:
            return
        error = _misfit(name, len(node.args), tuple(keywords))
        if error is not None:
            yield self._found("code-bad-call", node, name, f"self.{name}{signature}: {error}", ())

    def _record(self, node: ast.Call, name: str) -> Iterator[Diagnostic]:
        known, required = fields()[name]
        given = {keyword.arg for keyword in node.keywords if keyword.arg}
        if node.args:
            yield self._found("code-bad-call", node, name, f"{name} takes its fields by keyword", ())
        for keyword in sorted(given - known):
            yield self._found("code-bad-call", node, keyword, f"{name} has no field {keyword!r}", known)
        for keyword in sorted(required - given):
            if not node.args and not any(k.arg is None for k in node.keywords):
                yield self._found("code-bad-call", node, keyword, f"{name} needs its field {keyword!r}", ())


@lru_cache(maxsize=512)
def _misfit(name: str, positional: int, keywords: tuple[str, ...]) -> str | None:
    """What is wrong with a call of a method with so many arguments by position and these by name."""
    try:
        methods()[name].bind(*[None] * positional, **dict.fromkeys(keywords))
    except TypeError as error:
        return str(error)
    return None


def plain_names(node: ast.ClassDef) -> list[str]:
    """Names that the body of a class gives values to."""
    targets = [target for inner in node.body if isinstance(inner, ast.Assign) for target in inner.targets]
    targets += [inner.target for inner in node.body if isinstance(inner, ast.AnnAssign)]
    return [target.id for target in targets if isinstance(target, ast.Name)]


def _is_self(node: ast.expr) -> bool:
    return isinstance(node, ast.Name) and node.id == "self"


def _is_super(node: ast.expr) -> bool:
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "super"
