"""A sentence as it was typed, beside the task that came of its text: what is said of a line is looked for in both."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from rpg.core.diagnostics import Refusal
from rpg.ir.assets import Block
from rpg.ir.goal import Goal, Not
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Row, Stack
from rpg.ir.walk import children
from rpg.language.tokens import Token
from rpg.passes.schema.numbers_had import symbols_of
from rpg.passes.schema.resolve.things.world import refuse

Line = Row | Stack


@dataclass(frozen=True)
class Said:
    """A sentence, with its words as one text; `earlier`: those before it; `alone`: it is the only sentence."""

    tokens: Sequence[Token]
    text: str
    earlier: str
    task: TaskSchema
    lines: tuple[Line, ...]
    alone: bool

    def at(self, match: re.Match[str]) -> int:
        """Where the words of a match begin in the instruction."""
        return self.tokens[self.text[: match.start()].count(" ") + match[0].startswith(" ")].span[0]

    def refusal(self, match: re.Match[str], code: str, message: str, hint: str) -> Refusal:
        """A finding about the words of a match."""
        last = self.text[: match.end()].rstrip().count(" ")
        return refuse(code, message, (self.at(match), self.tokens[last].span[1]), hint)

    @property
    def begun(self) -> bool:
        """Whether something is arranged at the start, which may be what the sentence tells of."""
        return bool(self.task.init.arranged)

    def blocks(self, line: Line) -> list[Block]:
        """The blocks of a line."""
        return [block for block in self.task.blocks if block.name in line.blocks]

    def shows(self, label: str, color: str | None = None) -> bool:
        """Whether some block shows a symbol, on a body of some colour."""
        return any(label in symbols_of(block) and color in (None, block.color) for block in self.task.blocks)


def asked(goal: Goal) -> Iterator[Goal]:
    """What is asked for, and not denied."""
    yield goal
    for part in () if isinstance(goal, Not) else children(goal):
        yield from asked(part)


def lines_of(goal: Goal) -> tuple[Line, ...]:
    """The rows, columns and towers that are asked for."""
    return tuple(part for part in asked(goal) if isinstance(part, Row | Stack))
