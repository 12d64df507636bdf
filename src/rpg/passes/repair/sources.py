"""The two files of a program, and small changes of their text."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from rpg.ir.artifact import Program
from rpg.passes.repair.record import Proposal, Tools, relowered

CODE, GOAL_CODE = "code.py", "goal_state_code.py"


def sources(program: Program) -> dict[str, str]:
    """The files by name."""
    return {CODE: program.code, GOAL_CODE: program.goal_code}


def with_source(program: Program, filename: str, text: str) -> Program:
    """The program with one of its files replaced."""
    return program.model_copy(update={"code" if filename == CODE else "goal_code": text})


def regenerated(program: Program, tools: Tools) -> Iterator[Proposal]:
    """The files lowered again from the schema, one at a time where only one differs."""
    fresh = relowered(program, tools)
    if not fresh.path:
        return
    if fresh.code != program.code and fresh.goal_code != program.goal_code:
        yield Proposal("lower code.py again from task.yaml", program.model_copy(update={"code": fresh.code}))
        yield Proposal("lower both files again from task.yaml", fresh)
    elif fresh != program:
        which = CODE if fresh.code != program.code else GOAL_CODE
        yield Proposal(f"lower {which} again from task.yaml", fresh)


def replace_line(source: str, line: int, old: str, new: str) -> str | None:
    """`source` with the word `old` replaced in one line; None where it is not there."""
    lines = source.splitlines(keepends=True)
    if not 0 < line <= len(lines):
        return None
    changed = _whole_word(lines[line - 1], old, new)
    if changed is None:
        return None
    return "".join([*lines[: line - 1], changed, *lines[line:]])


def _whole_word(text: str, old: str, new: str) -> str | None:
    at = 0
    while (at := text.find(old, at)) >= 0:
        end = at + len(old)
        around = text[at - 1 : at] + text[end : end + 1]
        if not any(char.isalnum() or char == "_" for char in around):
            return text[:at] + new + text[end:]
        at = end
    return None


def method_lines(source: str, name: str) -> tuple[int, int] | None:
    """First and last line (counted from 1) of a method of the file's class; None where there is none."""
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError, RecursionError):
        return None
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef) and node.name == name:
            return node.lineno, node.end_lineno or node.lineno
    return None


def with_method(source: str, fresh: str, name: str) -> str | None:
    """`source` with the method `name` as `fresh` has it; None where either lacks it."""
    here, there = method_lines(source, name), method_lines(fresh, name)
    if here is None or there is None:
        return None
    lines, new = source.splitlines(keepends=True), fresh.splitlines(keepends=True)
    return "".join([*lines[: here[0] - 1], *new[there[0] - 1 : there[1]], *lines[here[1] :]])
