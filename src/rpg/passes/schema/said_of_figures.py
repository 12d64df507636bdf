"""What a figure is not, or is anyway, said behind it: "a triangle, not a line", "no need to touch", "do not mix the
colors", "the result must be true". Each is a pattern of the whole clause, and whether the task says so without it."""

from __future__ import annotations

from rpg.ir.assets import Block
from rpg.ir.node import Node
from rpg.ir.relations import Above, Behind, InFrontOf, LeftOf, On, RightOf, Touching
from rpg.ir.schema import TaskSchema
from rpg.ir.structures import Equation, Figure, Grid, GroupBy, Pyramid, Row, Stack, Staircase, Towers
from rpg.ir.walk import atoms, names
from rpg.passes.schema.said_of_success import Check, Parts

_FIGURES: dict[str, tuple[type[Node], ...]] = {
    **dict.fromkeys(("tower", "stack"), (On, Above, Stack, Towers)),
    **dict.fromkeys(("row", "line", "column"), (Row,)),
    "pyramid": (Pyramid,),
    "wall": (Grid,),
    "circle": (Figure,),
}
_SHAPED = (Row, Grid, Pyramid, Staircase, Figure, Stack, Towers, On, LeftOf, RightOf, InFrontOf, Behind)
"""What has one of these is no other figure: on a mat, or in a corner, they might be a tower as well."""


def _no_such(task: TaskSchema, told: Parts) -> bool:
    """Whether no such figure is asked for, but another one."""
    found = [*atoms(task.goal)]
    shaped = {name for atom in found if isinstance(atom, _SHAPED) for name in names(atom)}
    asked = any(isinstance(atom, _FIGURES[told["figure"] or ""]) for atom in found)
    return not asked and all(asset.name in shaped for asset in task.assets if isinstance(asset, Block))


def _unmixed(task: TaskSchema, told: Parts) -> bool:
    """Whether each figure is of one colour."""
    colors = {asset.name: asset.color for asset in task.assets if isinstance(asset, Block)}
    figures = [atom for atom in atoms(task.goal) if isinstance(atom, Row | Grid | Stack | Towers | GroupBy | Figure)]
    return bool(figures) and all(
        getattr(atom, "each", None) == "color"
        or getattr(atom, "by", None) == "color"
        or len({colors[name] for name in names(atom) if name in colors}) == 1
        for atom in figures
    )


def _true(task: TaskSchema, told: Parts) -> bool:
    return any(isinstance(atom, Equation) for atom in atoms(task.goal))


def _apart(task: TaskSchema, told: Parts) -> bool:
    """Whether nothing has to touch anything."""
    return not any(isinstance(atom, Touching) for atom in atoms(task.goal))


_NAMED = "(?P<figure>tower|stack|row|line|pyramid|wall|circle|column)"
_NEED = "(?:have to|need to|must)"
_TOUCH = "(?:touch|be touching|be in contact)(?: each other| one another| it)?"

SAID_OF_FIGURES: tuple[tuple[str, Check], ...] = (
    (f"no {_NAMED}s?(?: please)?", _no_such),
    (f"(?:it is |they are )?not (?:as )?an? (?:straight )?{_NAMED}(?: please)?", _no_such),
    ("(?:do not|never|without) mix(?:ing)? (?:up )?(?:the |any )?colou?rs|(?:the )?colou?rs not mixed", _unmixed),
    ("(?:the )?(?:result|equation|sum|it) (?:must|should|has to|needs to) be (?:true|right|correct)", _true),
    (f"(?:no need|(?:they |it |the blocks |the cubes )?(?:do|does) not (?:have|need)|not necessary) to {_TOUCH}"
     f"|(?:they )?need not {_TOUCH}|(?:they )?{_NEED} not necessarily {_TOUCH}"
     "|(?:no touching|touching (?:is )?not) (?:needed|necessary|required)", _apart),
)  # fmt: skip
