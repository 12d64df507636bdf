"""A task as an edit sees it: the lines of blocks and the figures that its goal builds, and what was mentioned last."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

from rpg.blocks.predicates.order import SORTED, sort_key
from rpg.blocks.state import World
from rpg.blocks.traits import Traits
from rpg.ir import goal as g
from rpg.ir.edits import Path
from rpg.ir.node import Highest, Lowest
from rpg.ir.order import Order
from rpg.ir.relations import On
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Cells, Equation, Figure, Grid, GroupBy, Pyramid, Row, Spells, Stack, Staircase, Towers
from rpg.ir.walk import children

LineKind = Literal["tower", "row", "column"]
BEGINS: dict[LineKind, str] = {"tower": "bottom", "row": "left", "column": "front"}
"""The side from which the members of a line are listed."""
ENDS: dict[str, str] = {
    "bottom": "top",
    "left": "right",
    "front": "back",
    "top": "bottom",
    "right": "left",
    "back": "front",
}
STEPS: dict[str, tuple[LineKind, bool]] = {
    "left_of": ("row", True),
    "right_of": ("row", False),
    "in_front_of": ("column", True),
    "behind": ("column", False),
}
"""Relations that order blocks along a line: its kind, and whether `a` comes before `b`."""


@dataclass(frozen=True)
class Line:
    """Blocks one after the other, listed from the bottom, the left or the front.

    `ordered`: the goal says which block is where. `node` and `path`: the structure that asks for the line; None where
    a chain of relations does.
    """

    kind: LineKind
    members: tuple[str, ...]
    ordered: bool
    node: g.Goal | None = None
    path: Path = ()


@dataclass(frozen=True)
class Shape:
    """A structure that is no line: its node, its place in the goal and its blocks."""

    node: g.Goal
    path: Path
    members: tuple[str, ...]


class View:
    """A schema with what an edit may speak of. `focus`: objects mentioned or added last, latest last."""

    def __init__(self, schema: TaskSchema, focus: Sequence[str] = ()) -> None:
        self.schema = schema
        self.world = World(schema.assets)
        known = set(self.world.assets)
        self.focus = tuple(name for name in focus if name in known)

    @cached_property
    def atoms(self) -> tuple[tuple[Path, g.Goal], ...]:
        """The atoms that must hold (not those of alternatives, negations or counts) with their places."""
        return tuple(_required(self.schema.goal, ()))

    @cached_property
    def lines(self) -> tuple[Line, ...]:
        """Towers, rows and columns, in order of reading; structures before chains of relations."""
        found = [line for path, atom in self.atoms for line in self._line(path, atom)]
        for chain in (*self._towers(found), *self._rows()):
            found = [line for line in found if not set(line.members) <= set(chain.members) or line.node is not None]
            if not any(set(chain.members) <= set(line.members) for line in found):
                found.append(chain)
        return tuple(found)

    @cached_property
    def figures(self) -> tuple[Shape, ...]:
        """Structures that are no lines."""
        kinds = (Cells, Towers, GroupBy)
        return tuple(Shape(atom, path, members_of(atom)) for path, atom in self.atoms if isinstance(atom, kinds))

    @property
    def idle(self) -> tuple[str, ...]:
        """Blocks that the goal says nothing of: distractors."""
        from rpg.ir.walk import names

        mentioned = set(names(self.schema.goal))
        return tuple(name for name in self.world.blocks if name not in mentioned)

    @property
    def busy(self) -> tuple[str, ...]:
        """Blocks that the goal speaks of."""
        idle = set(self.idle)
        return tuple(name for name in self.world.blocks if name not in idle)

    def line_of(self, names: Sequence[str]) -> Line | None:
        """The line that has all of `names`."""
        return next((line for line in self.lines if set(names) <= set(line.members)), None)

    def main_line(self) -> Line | None:
        """The line an edit means when it names none: that of the last mentioned block, else the only or last one."""
        for name in reversed(self.focus):
            if line := self.line_of((name,)):
                return line
        return self.lines[-1] if self.lines else None

    def main_figure(self) -> Shape | None:
        for name in reversed(self.focus):
            for figure in self.figures:
                if name in figure.members:
                    return figure
        return self.figures[-1] if self.figures else None

    def _line(self, path: Path, atom: g.Goal) -> Iterator[Line]:
        match atom:
            case Stack() | Row():
                kind: LineKind = "tower" if isinstance(atom, Stack) else "column" if atom.axis == "x" else "row"
                members = self.sequence(atom.blocks, atom.order, kind)
                yield Line(kind, members or atom.blocks, members is not None, atom, path)
            case Spells():
                members = self._spelt(atom)
                kind = "row" if atom.along == "row" else "tower"
                yield Line(kind, members or atom.blocks, members is not None, atom, path)
            case Equation():
                yield Line("row" if atom.along == "row" else "tower", atom.blocks, False, atom, path)

    def sequence(self, blocks: Sequence[str], order: Order, kind: LineKind) -> tuple[str, ...] | None:
        """`blocks` from where lines of that kind begin, as `order` wants them; None where it leaves a choice."""
        begin = BEGINS[kind]
        if order.by == "given":
            if any(len(self._looks(rank)) > 1 for rank in order.ranks):
                return None
            listed = [name for rank in order.ranks for name in rank]
            if set(listed) != set(blocks):
                return None
        elif order.by in SORTED:
            traits = Traits(self.world)
            keyed = [(sort_key(order, name, traits), name) for name in blocks]
            if any(value is None for value, _ in keyed):
                return None
            listed = [name for _, name in sorted(keyed, key=lambda item: item[0], reverse=order.descending)]  # type: ignore[arg-type, return-value]
        elif len(self._looks(blocks)) == 1:
            listed = list(blocks)
        else:
            return None
        return tuple(reversed(listed) if (order.first or begin) == ENDS[begin] else listed)

    def _looks(self, names: Sequence[str]) -> set[tuple[str, ...]]:
        return {self.world.look[name] for name in names if name in self.world.look}

    def _spelt(self, atom: Spells) -> tuple[str, ...] | None:
        """The blocks of a word in reading order, listed from the left or the bottom."""
        traits, left, listed = Traits(self.world), list(atom.blocks), []
        for letter in atom.word:
            name = next((n for n in left if traits.symbol(n) == letter), None)
            if name is None:
                return None
            left.remove(name)
            listed.append(name)
        backwards = atom.reverse != (atom.along == "stack")
        return tuple(reversed(listed) if backwards else listed) if not left else None

    def _towers(self, lines: Sequence[Line]) -> Iterator[Line]:
        """Chains of "a on b", grown on top of towers that the goal names whole."""
        above: dict[str, list[str]] = {}
        below: dict[str, str] = {}
        for _, atom in self.atoms:
            if isinstance(atom, On):
                upper, lower = (self._one(atom.a, "bottom", lines), self._one(atom.b, "top", lines))
                if upper and lower and lower in self.world.blocks:
                    above.setdefault(lower, []).append(upper)
                    below[upper] = lower
        stacked = {line.members[0]: line for line in lines if line.kind == "tower" and line.ordered}
        tops = {line.members[-1] for line in stacked.values()}
        inside = {name for line in stacked.values() for name in line.members}
        for first in self.world.blocks:
            begins = first in stacked if first in inside else first in above
            if first in below or not begins:
                continue
            members = list(stacked[first].members) if first in stacked else [first]
            while len(above.get(members[-1], ())) == 1 and (members[-1] in tops or members[-1] not in inside):
                upper = above[members[-1]][0]
                members += stacked[upper].members if upper in stacked else [upper]
            if len(members) > (len(stacked[first].members) if first in stacked else 1):
                yield Line("tower", tuple(members), True)

    def _one(self, operand: object, end: str, lines: Sequence[Line]) -> str | None:
        """The block an operand stands for, where it can be told."""
        if isinstance(operand, Highest | Lowest):
            names = operand.highest if isinstance(operand, Highest) else operand.lowest
            line = next((line for line in lines if set(names) <= set(line.members) and line.ordered), None)
            return None if line is None else line.members[-1 if isinstance(operand, Highest) else 0]
        return _single(operand)

    def _rows(self) -> Iterator[Line]:
        """Chains of "a left of b" and the like."""
        kinds: tuple[LineKind, ...] = ("row", "column")
        for kind in kinds:
            after: dict[str, list[str]] = {}
            before: dict[str, list[str]] = {}
            for _, atom in self.atoms:
                step = STEPS.get(atom.kind)
                a, b = _single(getattr(atom, "a", ())), _single(getattr(atom, "b", ()))
                if step is None or step[0] != kind or a is None or b is None:
                    continue
                first, second = (a, b) if step[1] else (b, a)
                after.setdefault(first, []).append(second)
                before.setdefault(second, []).append(first)
            for first in self.world.blocks:
                if first in before or first not in after:
                    continue
                members = [first]
                while len(after.get(members[-1], ())) == 1 and len(before.get(after[members[-1]][0], ())) == 1:
                    members.append(after[members[-1]][0])
                yield Line(kind, tuple(members), True)


def members_of(node: g.Goal) -> tuple[str, ...]:
    """The blocks of a structure."""
    if isinstance(node, GroupBy):
        return tuple(name for group in node.groups for name in group)
    return tuple(getattr(node, "blocks", ()))


def _single(operand: object) -> str | None:
    """The name in an operand of one name."""
    return str(operand[0]) if isinstance(operand, tuple) and len(operand) == 1 else None


def _required(goal: g.Goal, path: Path) -> Iterator[tuple[Path, g.Goal]]:
    if isinstance(goal, g.All | g.Sequence | g.Always):
        for index, child in enumerate(children(goal)):
            yield from _required(child, (*path, index))
    elif not children(goal):
        yield path, goal


NOUNS: dict[type[g.Goal], str] = {
    Stack: "tower", Towers: "towers", Row: "row", Grid: "grid", Pyramid: "pyramid", Staircase: "staircase",
    Figure: "figure", GroupBy: "groups", Spells: "word", Equation: "equation",
}  # fmt: skip
"""What a structure is called in a message."""
