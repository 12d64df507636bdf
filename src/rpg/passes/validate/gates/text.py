"""Gate 1: the text alone. It parses, stays in the allowed part of Python, and calls what exists as it is defined."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from rpg.core.diagnostics import Diagnostic
from rpg.ir.artifact import GateReport, Program
from rpg.passes.validate.bench import Bench
from rpg.passes.validate.findings import failure
from rpg.passes.validate.gates import grammar
from rpg.passes.validate.gates.api import check_api
from rpg.passes.validate.gates.shape import check_shape


@dataclass(frozen=True)
class TextGate:
    """AST parse, forbidden constructs, API use."""

    name: str = "text"
    cost: int = 0

    def check(self, program: Program, bench: Bench) -> GateReport:
        """Check both files; every finding names its file and line."""
        found: list[Diagnostic] = []
        lines = calls = 0
        for filename, source in bench.sources.items():
            tree, problems = parse(filename, source)
            found += problems
            lines += source.count("\n")
            if tree is not None:
                bench.trees[filename] = tree
                nodes = grammar.walk(tree)
                calls += sum(isinstance(node, ast.Call) for node in nodes)
                found += forbidden(filename, nodes)
                found += check_shape(filename, tree, nodes)
                found += check_api(filename, nodes)
        return GateReport.of(self.name, found, lines=lines, calls=calls)


def parse(filename: str, source: str) -> tuple[ast.Module | None, list[Diagnostic]]:
    """The syntax tree of a file, or why there is none."""
    if len(source) > grammar.LONGEST_FILE:
        message = f"{filename} has {len(source):,} characters, more than the {grammar.LONGEST_FILE:,} that are allowed"
        return None, [failure("text", "code-too-long", "syntax", message, file=filename)]
    facts: dict[str, Any] = {"file": filename}
    try:
        return ast.parse(source, filename), []
    except SyntaxError as error:
        message = f"{filename} does not parse: {error.msg} in line {error.lineno}"
        facts |= {"line": error.lineno, "column": error.offset, "text": (error.text or "").rstrip()}
    except (ValueError, RecursionError, MemoryError) as error:
        message = f"{filename} does not parse: {error}"
    return None, [failure("text", "code-syntax", "syntax", message, **facts)]


def forbidden(filename: str, nodes: Iterable[ast.AST]) -> list[Diagnostic]:
    """Constructs that no task needs."""
    found = []
    for node in nodes:
        if type(node) not in grammar.TYPES:
            line = getattr(node, "lineno", None)
            message = f"{filename} uses a {grammar.what(node)} in line {line}; tasks are written without"
            found.append(failure("text", "code-forbidden", "api", message, file=filename, line=line))
        elif isinstance(node, ast.Constant) and isinstance(node.value, bytes | complex):
            message = f"{filename} has a {type(node.value).__name__} literal in line {node.lineno}"
            found.append(failure("text", "code-forbidden", "api", message, file=filename, line=node.lineno))
        elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow | ast.LShift):
            message = f"{filename} raises to a power in line {node.lineno}; numbers that large have no place in a task"
            found.append(failure("text", "code-forbidden", "api", message, file=filename, line=node.lineno))
    return found
