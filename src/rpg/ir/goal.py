"""Goal expressions: a closed tagged union of atoms and connectives, as plain frozen data.

`GOAL` validates any goal from data. Every node has a `kind`; `rpg.ir.walk` has the folds over them.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, TypeAdapter

from rpg.ir.base import Names, Record
from rpg.ir.node import EACH, Node
from rpg.ir.relations import (
    Above,
    Adjacent,
    Apart,
    Approached,
    Behind,
    Beside,
    Between,
    Clear,
    Closer,
    Distance,
    Empty,
    Equidistant,
    Facing,
    InFrontOf,
    InRegion,
    LeftOf,
    Moved,
    Near,
    On,
    OnPatch,
    OnTable,
    Receded,
    RightOf,
    Shifted,
    Stayed,
    Swapped,
    TookPlace,
    Touching,
    Turned,
)
from rpg.ir.structures import Equation, Figure, Grid, GroupBy, Pyramid, Row, Spells, Stack, Staircase, Towers


class All(Node):
    """Every goal holds."""

    kind: Literal["all"] = "all"
    goals: tuple[Goal, ...]


class Any(Node):
    """At least one goal holds."""

    kind: Literal["any"] = "any"
    goals: tuple[Goal, ...]


class Not(Node):
    """The goal does not hold."""

    kind: Literal["not"] = "not"
    goal: Goal


class Count(Node):
    """`goal`, read with each block of `over` in place of the name `var`, holds for at least / at most so many."""

    kind: Literal["count"] = "count"
    over: Names
    var: str = EACH
    at_least: int = 0
    at_most: int | None = None
    goal: Goal


class Stage(Record):
    """One stage of a sequence. `undone`: a later stage must undo it, so that it need not hold at the end."""

    goal: Goal
    undone: bool = False


class Sequence(Node):
    """The stages are met one after the other; a stage met before the one in front of it fails the episode, unless that
    one cannot be met otherwise: a tower is built from its lower blocks, which are a tower before."""

    kind: Literal["sequence"] = "sequence"
    stages: tuple[Stage, ...]


class Always(Node):
    """The goal holds at every control step from the start on."""

    kind: Literal["always"] = "always"
    goal: Goal


Atom = (
    On | Above | OnTable | Clear | OnPatch | Empty | LeftOf | RightOf | InFrontOf | Behind | Beside | Adjacent
    | Touching | Near | Apart | Distance | Between | Closer | Equidistant | InRegion | Facing
    | Stayed | Moved | Shifted | Approached | Receded | Swapped | TookPlace | Turned
    | Stack | Towers | Row | Grid | Pyramid | Staircase | Figure | GroupBy | Spells | Equation
)  # fmt: skip
Goal = Annotated[Atom | All | Any | Not | Count | Sequence | Always, Field(discriminator="kind")]

for _model in (All, Any, Not, Count, Stage, Sequence, Always):
    _model.model_rebuild()

GOAL: TypeAdapter[Goal] = TypeAdapter(Goal)
