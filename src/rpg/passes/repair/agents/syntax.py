"""SyntaxFixAgent: files that do not parse."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass

from rpg.core.diagnostics import Diagnostic
from rpg.ir.artifact import FailureClass
from rpg.passes.repair.record import Case, Proposal, Tools
from rpg.passes.repair.sources import regenerated, sources, with_source

PAIRS = {"(": ")", "[": "]", "{": "}"}
OPENERS = ("def ", "class ", "if ", "for ", "elif ", "else")


@dataclass(frozen=True)
class SyntaxFixAgent:
    """Mends the line at fault where that makes the file parse, else lowers the schema again."""

    name: str = "SyntaxFixAgent"
    handles: FailureClass = "syntax"

    def propose(self, case: Case, failures: tuple[Diagnostic, ...], tools: Tools) -> Iterator[Proposal]:
        """Line patches first, so that what somebody wrote by hand is kept."""
        program, patched = case.program, []
        for failure in failures:
            filename, line = failure.facts.get("file"), failure.facts.get("line")
            if filename in sources(program) and isinstance(line, int):
                fixed = patch(sources(program)[filename], line)
                if fixed is not None:
                    program = with_source(program, filename, fixed)
                    patched.append(f"{filename} line {line}")
        if patched:
            yield Proposal(f"correct the syntax of {', '.join(patched)}", program)
        yield from regenerated(case.program, tools)


def patch(source: str, line: int) -> str | None:
    """`source` with one line near `line` mended so that it parses; None where no small change does."""
    lines = source.expandtabs(4).splitlines()
    for number in (line - 1, line - 2):
        if not 0 <= number < len(lines):
            continue
        for candidate in _candidates(lines[number]):
            fixed = "\n".join([*lines[:number], candidate, *lines[number + 1 :]]) + "\n"
            if _parses(fixed):
                return fixed
    return None


def _candidates(line: str) -> Iterator[str]:
    yield line
    text = line.rstrip()
    if text.lstrip().startswith(OPENERS) and not text.endswith(":"):
        yield text + ":"
    yield text + _missing(text)
    for quote in "\"'":
        if text.count(quote) % 2:
            yield text + quote + _missing(text + quote)
            for bracket in ")]":
                if text.endswith(bracket):
                    yield text[: -len(bracket)] + quote + bracket
    if text[-1:] in ")]},;:":
        yield text[:-1]


def _missing(text: str) -> str:
    """The closing brackets that `text` lacks."""
    open_ones: list[str] = []
    for char in text:
        if char in PAIRS:
            open_ones.append(PAIRS[char])
        elif open_ones and char == open_ones[-1]:
            open_ones.pop()
    return "".join(reversed(open_ones))


def _parses(source: str) -> bool:
    try:
        ast.parse(source)
    except (SyntaxError, ValueError, RecursionError):
        return False
    return True
