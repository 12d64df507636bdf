"""The runtime, and the one public surface of tasks: everything that a task's code may import."""

from __future__ import annotations

from rpg.blocks.judgement import Judgement
from rpg.blocks.state import BlockState
from rpg.blocks.verdict import Verdict
from rpg.env.task import BlockTask
from rpg.ir.assets import ColoredCube, Faces, GoalPatch, SemanticCube
from rpg.ir.goal import All, Always, Any, Count, Not, Sequence, Stage
from rpg.ir.node import Highest, Lowest
from rpg.ir.order import Order, Pattern
from rpg.ir.relations import (
    Above,
    Adjacent,
    Apart,
    Behind,
    Beside,
    Between,
    Clear,
    Distance,
    Empty,
    Facing,
    InFrontOf,
    InRegion,
    LeftOf,
    Moved,
    Near,
    On,
    OnPatch,
    OnTable,
    RightOf,
    Stayed,
    Swapped,
    Touching,
    Turned,
)
from rpg.ir.structures import Equation, Figure, Grid, GroupBy, Pyramid, Row, Spells, Stack, Staircase, Towers

__all__ = [
    "Above",
    "Adjacent",
    "All",
    "Always",
    "Any",
    "Apart",
    "Behind",
    "Beside",
    "Between",
    "BlockState",
    "BlockTask",
    "Clear",
    "ColoredCube",
    "Count",
    "Distance",
    "Empty",
    "Equation",
    "Faces",
    "Facing",
    "Figure",
    "GoalPatch",
    "Grid",
    "GroupBy",
    "Highest",
    "InFrontOf",
    "InRegion",
    "Judgement",
    "LeftOf",
    "Lowest",
    "Moved",
    "Near",
    "Not",
    "On",
    "OnPatch",
    "OnTable",
    "Order",
    "Pattern",
    "Pyramid",
    "RightOf",
    "Row",
    "SemanticCube",
    "Sequence",
    "Spells",
    "Stack",
    "Stage",
    "Staircase",
    "Stayed",
    "Swapped",
    "Touching",
    "Towers",
    "Turned",
    "Verdict",
]
