"""Diagnostics as people read them: the message, the instruction with the words that matter underlined, the hint."""

from __future__ import annotations

import unicodedata
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from rich.cells import cell_len
from rich.text import Text

if TYPE_CHECKING:
    from rich.console import Console

    from rpg.core.diagnostics import Diagnostic

STYLES = {"error": "bold red", "warning": "bold yellow", "note": "bold cyan"}
MARGIN = "  │ "
LONGEST = 8
"""How many lines with something underlined are shown of an instruction."""
CONTEXT = 1
"""How many lines of a long instruction are shown around a line with something underlined."""


@dataclass(frozen=True)
class Mark:
    """Characters [start, end) of the instruction, what to say about them, and how to draw the line below them."""

    start: int
    end: int
    text: str
    sign: str
    style: str


@dataclass(frozen=True)
class Line:
    """Characters [start, end) of the instruction, as they fit on one line of the terminal."""

    start: int
    end: int


def print_diagnostics(console: Console, diagnostics: Iterable[Diagnostic], instruction: str) -> None:
    """Print diagnostics about `instruction`, a blank line between them."""
    for index, diagnostic in enumerate(diagnostics):
        if index:
            console.print()
        for line in diagnostic_lines(diagnostic, instruction, console.width):
            console.print(line, soft_wrap=True)


def diagnostic_lines(diagnostic: Diagnostic, instruction: str, width: int = 80) -> Iterator[Text]:
    """One diagnostic, line by line; no quoted line is wider than `width` cells."""
    style = STYLES[diagnostic.severity]
    header = Text.assemble((f"{diagnostic.severity}[{diagnostic.code}]", style), (f": {diagnostic.message}", "bold"))
    yield header
    marks = _marks(diagnostic, len(instruction), style)
    if marks and instruction.strip():
        yield from quoted(instruction, marks, width)
    if diagnostic.hint:
        yield Text.assemble("  = ", ("hint", "bold green"), f": {diagnostic.hint}")


def _marks(diagnostic: Diagnostic, length: int, style: str) -> list[Mark]:
    marks = []
    if diagnostic.span is not None:
        marks.append(Mark(*_inside(diagnostic.span, length), "", "^", style))
    for label in diagnostic.labels:
        start, end = _inside(label.span, length)
        same = next((mark for mark in marks if (mark.start, mark.end) == (start, end)), None)
        if same is None:
            marks.append(Mark(start, end, label.text, "-", "bold blue"))
        elif not same.text:
            marks[marks.index(same)] = Mark(start, end, label.text, same.sign, same.style)
    return marks


def _inside(span: tuple[int, int], length: int) -> tuple[int, int]:
    start = min(max(span[0], 0), length)
    return start, min(max(span[1], start), length)


def quoted(instruction: str, marks: list[Mark], width: int) -> Iterator[Text]:
    """The lines of `instruction` that have marks, and their neighbours, with the marks below them."""
    shown = "".join(map(_visible, instruction))
    lines = list(wrapped(shown, max(20, width - len(MARGIN)) - 1))  # room for a mark behind the last character
    marked = {number for number, line in enumerate(lines) if _on(line, marks, line == lines[-1])}
    marked = set(sorted(marked)[:LONGEST])
    near = {at for number in marked for at in range(number - CONTEXT, number + CONTEXT + 1)}
    skipped = False
    for number, line in enumerate(lines):
        if number not in near:
            skipped = True
            continue
        if skipped:
            yield Text(MARGIN + "…", "dim")
            skipped = False
        yield Text.assemble((MARGIN, "blue"), shown[line.start : line.end].rstrip() or " ")
        if number in marked:
            yield from _below(shown, line, _on(line, marks, line == lines[-1]))
    if skipped:
        yield Text(MARGIN + "…", "dim")


def _visible(char: str) -> str:
    """A stand-in of one cell for what a terminal would obey or leave out."""
    if char in "\n\r\t\v\f":
        return " "
    return "�" if unicodedata.category(char) in ("Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp") else char


def wrapped(text: str, width: int) -> Iterator[Line]:
    """`text` broken into lines of at most `width` cells, after a space where there is one."""
    start = 0
    while start < len(text):
        end, cells, after_space = start, 0, 0
        while end < len(text):
            cells += cell_len(text[end])
            if cells > width:
                break
            end += 1
            if text[end - 1] == " ":
                after_space = end
        if end < len(text) and after_space > start:
            end = after_space
        end = max(end, start + 1)
        yield Line(start, end)
        start = end


def _on(line: Line, marks: list[Mark], last: bool) -> list[Mark]:
    """The marks that touch `line`; a mark at the very end of the text belongs to the last line."""
    return [m for m in marks if (m.start < line.end or last) and max(m.end, m.start + 1) > line.start]


@dataclass(frozen=True)
class Placed:
    """A mark on one line of the terminal: its first cell, and how many it takes."""

    column: int
    cells: int
    mark: Mark

    @property
    def end(self) -> int:
        return self.column + self.cells


def _below(shown: str, line: Line, marks: list[Mark]) -> Iterator[Text]:
    """The underlines of `line` and what is said about them: the rightmost beside its line, the others beneath."""
    if not marks:
        return
    placed = sorted((_place(shown, line, mark) for mark in marks), key=lambda at: (at.column, at.end))
    said = [at for at in placed if at.mark.text and (at.mark.end <= line.end or line.end == len(shown))]
    row = _underlines(placed)
    if said and said[-1].end == max(at.end for at in placed):
        row.append(f" {said[-1].mark.text}", said[-1].mark.style)
        said.pop()
    yield row
    while said:
        row = Text(MARGIN, "blue")
        for at in said[:-1]:
            row.append(" " * (at.column - row.cell_len + len(MARGIN)))
            row.append("│", at.mark.style)
        row.append(" " * (said[-1].column - row.cell_len + len(MARGIN)))
        row.append(said[-1].mark.text, said[-1].mark.style)
        yield row
        said.pop()


def _place(shown: str, line: Line, mark: Mark) -> Placed:
    start, end = max(mark.start, line.start), min(mark.end, line.end)
    return Placed(cell_len(shown[line.start : start]), max(1, cell_len(shown[start:end].rstrip())), mark)


def _underlines(placed: list[Placed]) -> Text:
    """One row of signs; where marks overlap, the main one is seen."""
    cells: list[tuple[str, str]] = [(" ", "")] * max(at.end for at in placed)
    for at in sorted(placed, key=lambda at: at.mark.sign == "^"):
        cells[at.column : at.end] = [(at.mark.sign, at.mark.style)] * at.cells
    return Text.assemble((MARGIN, "blue"), *cells)
