"""APIUsageFixAgent: names, methods, arguments and imports that do not exist."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from dataclasses import dataclass

from rpg.core.diagnostics import Diagnostic
from rpg.ir.artifact import FailureClass, Program
from rpg.passes.repair.record import Case, Proposal, Tools
from rpg.passes.repair.sources import CODE, regenerated, replace_line, sources, with_method, with_source

MODULE = "rpg.env"


@dataclass(frozen=True)
class APIUsageFixAgent:
    """Takes the nearest existing name, mends imports, and lowers again what is beyond that."""

    name: str = "APIUsageFixAgent"
    handles: FailureClass = "api"

    def propose(self, case: Case, failures: tuple[Diagnostic, ...], tools: Tools) -> Iterator[Proposal]:
        """Renamings and imports first; then the files as the schema lowers to them."""
        renamed = nearest_names(case.program, failures)
        if renamed is not None:
            yield Proposal("use the nearest existing names", renamed)
        imported = mended_imports(renamed or case.program, case.program.code, tools)
        if imported is not None:
            yield Proposal("mend the imports", imported)
        for filename, method in _broken_methods(case.program, failures):
            fresh = tools.lower(case.program.task)
            text = with_method(sources(case.program)[filename], fresh, method)
            if filename == CODE and text is not None:
                yield Proposal(f"lower {method} again", with_source(case.program, filename, text))
        yield from regenerated(case.program, tools)


def nearest_names(program: Program, failures: tuple[Diagnostic, ...]) -> Program | None:
    """Every misspelt name replaced by the nearest that exists; None where nothing changes."""
    changed = program
    for failure in failures:
        facts = failure.facts
        filename, line = facts.get("file"), facts.get("line")
        old, new = facts.get("name"), facts.get("nearest")
        if filename in sources(changed) and isinstance(line, int) and old and new:
            text = replace_line(sources(changed)[filename], line, old, new)
            if text is not None:
                changed = with_source(changed, filename, text)
    return None if changed is program else changed


def mended_imports(program: Program, original: str, tools: Tools) -> Program | None:
    """code.py with one import from the public module: the known names that it uses."""
    known = _public(tools.lower(program.task)) | _constructed(program.code)
    used = {node.id for node in _nodes(program.code) if isinstance(node, ast.Name)}
    wanted = sorted(used & (known | {"BlockTask", "Verdict"}))
    lines = _without_imports(program.code)
    if not wanted or not lines:
        return None
    at = 1 if lines[0].startswith(('"""', "'''")) else 0
    block = f"from {MODULE} import {', '.join(wanted)}\n"
    if len(block) > 101:
        block = f"from {MODULE} import (\n" + "".join(f"    {name},\n" for name in wanted) + ")\n"
    body = "".join(lines[at:]).lstrip("\n")
    text = "".join(lines[:at]) + ("\n" if at else "") + block + "\n\n" + body
    return None if text == original else with_source(program, CODE, text)


def _nodes(source: str) -> list[ast.AST]:
    try:
        return list(ast.walk(ast.parse(source)))
    except (SyntaxError, ValueError, RecursionError):
        return []


def _public(code: str) -> set[str]:
    """The names that a lowered file imports."""
    return {alias.name for node in _nodes(code) if isinstance(node, ast.ImportFrom) for alias in node.names}


def _constructed(code: str) -> set[str]:
    """Classes that a file calls by a capitalised name."""
    calls = [node.func for node in _nodes(code) if isinstance(node, ast.Call)]
    return {func.id for func in calls if isinstance(func, ast.Name) and re.match(r"[A-Z]", func.id)}


def _without_imports(source: str) -> list[str]:
    lines = source.splitlines(keepends=True)
    for node in _nodes(source):
        if isinstance(node, ast.Import | ast.ImportFrom):
            for number in range(node.lineno - 1, node.end_lineno or node.lineno):
                lines[number] = ""
    return [line for line in lines if line]


def _broken_methods(program: Program, failures: tuple[Diagnostic, ...]) -> list[tuple[str, str]]:
    """Which methods the failures are in."""
    found: dict[tuple[str, str], None] = {}
    for failure in failures:
        filename, line = failure.facts.get("file"), failure.facts.get("line")
        if filename not in sources(program) or not isinstance(line, int):
            continue
        for node in _nodes(sources(program)[filename]):
            if isinstance(node, ast.FunctionDef) and node.lineno <= line <= (node.end_lineno or node.lineno):
                found[filename, node.name] = None
    return list(found)
