"""The part of Python that generated code is written in: syntax, names and attributes that the text gate allows."""

from __future__ import annotations

import ast
from functools import cache

NODES: tuple[type[ast.AST], ...] = (
    ast.Module, ast.Expr, ast.ImportFrom, ast.alias, ast.ClassDef, ast.FunctionDef, ast.arguments, ast.arg, ast.Return,
    ast.Assign, ast.AnnAssign, ast.AugAssign, ast.For, ast.If, ast.IfExp, ast.Pass, ast.Name,
    ast.Attribute, ast.Constant, ast.Call, ast.keyword, ast.List, ast.Tuple, ast.Dict, ast.Subscript,
    ast.Slice, ast.Starred, ast.ListComp, ast.GeneratorExp, ast.comprehension, ast.BinOp, ast.UnaryOp, ast.BoolOp,
    ast.Compare, ast.operator, ast.unaryop, ast.boolop, ast.cmpop,
)  # fmt: skip
"""What a task is written with. Endless loops, exceptions, closures, formatting and sets (whose order depends on the
process) are not among it."""

TYPES = frozenset(kind for base in NODES for kind in (base, *base.__subclasses__()))
"""The same, with the kinds of operators one by one."""
ORDINARY_ATTRIBUTES = frozenset(
    {"value", "margin", "append", "extend", "items", "keys", "values", "get", "index", "count"}
)
"""Attributes of values other than the task itself."""

HOOKS = ("_initialize_env", "_on_reset", "_on_step", "_success", "_fail")
REQUIRED_HOOKS = ("_initialize_env", "_success")
LONGEST_FILE = 200_000
"""Characters; a task of 30 blocks takes a tenth of it."""
DEEPEST = 60
"""Levels of nesting."""
LEAVES = frozenset({"ctx", "id", "attr", "arg", "name", "asname", "module", "level", "type_comment", "kind"})
"""Fields that never hold a node, but for whether a name is read or written."""


def walk(tree: ast.AST) -> list[ast.AST]:
    """All nodes of a tree, parents before children; whether a name is read or written is no node of its own."""
    found: list[ast.AST] = [tree]
    for node in found:
        for field in _inner(node._fields):
            value = getattr(node, field, None)
            if isinstance(value, list):
                found += [item for item in value if isinstance(item, ast.AST)]
            elif isinstance(value, ast.AST):
                found.append(value)
    return found


@cache
def _inner(fields: tuple[str, ...]) -> tuple[str, ...]:
    """Of the fields of a kind of node, those in which there may be nodes that are worth a look."""
    return tuple(field for field in fields if field not in LEAVES)


def what(node: ast.AST) -> str:
    """A construct by its name in Python."""
    words = {
        ast.Import: "import of a module",
        ast.While: "while loop",
        ast.Lambda: "lambda",
        ast.Try: "try statement",
        ast.With: "with statement",
        ast.Global: "global statement",
        ast.Nonlocal: "nonlocal statement",
        ast.AsyncFunctionDef: "async function",
        ast.Await: "await",
        ast.Yield: "yield",
        ast.JoinedStr: "f-string",
        ast.Raise: "raise statement",
        ast.Delete: "del statement",
        ast.Set: "set",
        ast.SetComp: "set",
        ast.NamedExpr: "assignment expression",
    }
    return words.get(type(node), type(node).__name__)
