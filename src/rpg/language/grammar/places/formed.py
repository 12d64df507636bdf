"""Blocks somewhere that form a line there: "three white blocks in a row on it"."""

from __future__ import annotations

from rpg.language.grammar.core import Parser, Results
from rpg.language.meaning import Meaning, Noun, Structure

_SHAPES = {"in a row": "row", "in a line": "line", "stacked": "stack", "in a stack": "stack", "in a tower": "stack",
           "stacked up": "stack", "lined up": "line", "piled up": "stack", "in one row": "row"}  # fmt: skip


def formed(p: Parser, k: int, theme: Meaning) -> Results[Structure]:
    """ "(a mat with) three white blocks in a row (on it)": a row of them."""
    counted = isinstance(theme, Noun) and theme.head != "patch" and theme.amount is not None and theme.amount.low > 1
    for phrase, end in p.standing(k, _SHAPES) if counted else ():
        yield Structure(kind=_SHAPES[phrase], members=theme, span=(theme.span[0], p.span(k, end)[1])), end
