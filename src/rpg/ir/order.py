"""How the members of a structure are ordered, and how a pattern colours its cells."""

from __future__ import annotations

from typing import Literal

from rpg.ir.base import Names, Record

Attribute = Literal["color", "kind", "label", "vowel", "parity", "size"]
"""What blocks are told apart by: colour; letter, digit or plain; the symbol; vowel or consonant; odd or even; edge."""

Side = Literal["top", "bottom", "front", "back", "left", "right"]
"""In the order of `assets.Face`: of two unions of the same names `typing` keeps the one that was made first."""


class Order(Record):
    """Which member comes where along a line, a stack or in reading order.

    `by`: "any" asks for nothing; "given" follows `ranks` (each entry a block, or several whose order among themselves
    is free); "label" is alphabetical, "number" numeric, "rainbow" red to pink, "size" by edge; "alternating" lets no
    two neighbours agree in `attribute`, "mirrored" makes the line a palindrome in it, "together" keeps equals adjacent.
    `first` is the side where the sequence begins; without it either end may be the beginning. `descending` turns
    label, number, rainbow and size orders round. `match`: ranks are compared by what a block looks like, or by name
    where other conditions of the goal tell blocks apart that look alike; or "single", ranks of one block by name and
    the others by look.
    """

    by: Literal["any", "given", "label", "number", "rainbow", "size", "alternating", "mirrored", "together"] = "any"
    ranks: tuple[Names, ...] = ()
    attribute: Attribute = "color"
    descending: bool = False
    first: Side | None = None
    match: Literal["look", "name", "single"] = "look"


class Pattern(Record):
    """How the cells of a grid, wall, pyramid or figure are filled.

    "row", "column", "layer": each such line agrees in `attribute`, and no two lines share its value. "checkerboard":
    neighbours along rows and columns differ in two alternating values. "reading": the cells follow `order` in reading
    order (far row first, each left to right; for upright structures top layer first; bottom first if `upward`).
    `own`: they follow it in the order in which the figure is drawn, so that its parts turn with it.
    """

    kind: Literal["row", "column", "layer", "checkerboard", "reading"]
    attribute: Attribute = "color"
    order: Order = Order()
    upward: bool = False
    own: bool = False
