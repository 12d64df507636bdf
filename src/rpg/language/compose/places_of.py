"""The places of a figure: its ends, corners, middle, top, rows and layers; counted as `Figure` says."""

from __future__ import annotations

from math import isqrt
from typing import NamedTuple

from rpg.language.compose.scene import Figure, Unclear

_ENDS = {
    "tower": ("bottom", "top"), "column": ("near", "far"),
    **dict.fromkeys(("row", "line", "word", "equation"), ("left", "right")),
}  # fmt: skip
"""The ends of what is one block wide, from the first place to the last."""
_AXES = {"left": (0, min), "right": (0, max), "far": (1, min), "near": (1, max), "top": (2, max), "bottom": (2, min)}
_LINES = frozenset({"row", "column", "layer", "side", "step"})
DRAWN: dict[str, dict[str, tuple[int, ...]]] = {
    "L": {"corner": (0,)}, "V": {"point": (0,), "corner": (0,), "end": (-2, -1)}, "T": {"bottom": (-1,)},
    "U": {"corner": (0, 1), "end": (-2, -1), "point": (-2, -1)},
}  # fmt: skip
"""Letters that lie in any way, their parts by places in the order in which they are drawn."""


class _Cell(NamedTuple):
    """Where a block of a figure is, from the left, from the far side, and up."""

    x: float
    y: float
    z: float = 0


def columns(figure: Figure) -> int:
    """How many columns a grid or a wall has."""
    return figure.size[0] if len(figure.size) > 1 else 0


def steps(many: int) -> int:
    """Of how many steps a staircase, or of how many layers a pyramid, of so many blocks is; 0 if it cannot be."""
    found = (isqrt(8 * many + 1) - 1) // 2
    return found if found * (found + 1) == 2 * many else 0


def places(figure: Figure, ranks: tuple[str, ...], nth: int = 0, count: int = 0) -> list[int]:
    """The numbers of the places that words such as "left end" or "far right corner" stand for; so many, if `count` is
    told, or any number of them, where it is -1.

    Raises Unclear where the figure has no such places.
    """
    many, said = len(figure.blocks), set(ranks)
    if len(said) == 1 and 1 < count < many and not nth and (some := _several(figure, said, count)):
        return some
    if figure.kind in _ENDS:
        return _one_line(many, said, nth, *_ENDS[figure.kind])
    if figure.kind in DRAWN:
        found = DRAWN[figure.kind].get(next(iter(said)) if len(said) == 1 else "", ())
        if not found or nth:
            raise Unclear
        return [n % many for n in found]
    if figure.kind == "staircase":
        return _step(steps(many), said, nth)
    cells = _cells(figure)
    if not cells:
        raise Unclear
    return _of_cells(figure, cells, said, nth, count)


def line_of(figure: Figure, unit: str, ids: list[int]) -> Figure:
    """A row, a column or a layer of a figure, as a figure of its own of which parts may be told."""
    upright = figure.kind in {"wall", "pyramid", "staircase"}
    kind = {"column": "tower" if upright else "column", "step": "tower"}.get(unit, "row")
    size: tuple[int, ...] = ()
    if unit == "layer" and len(figure.size) == 3:
        kind, size = "grid", figure.size[:2]
    if kind in {"tower", "column"} and figure.kind != "staircase":
        ids = ids[::-1]
    return Figure(kind, ids, size, told=True, sided=True, stage=figure.stage)


def _several(figure: Figure, said: set[str], count: int) -> list[int]:
    """ "the two upper ones", "the three middle ones"."""
    ends = _ENDS.get(figure.kind)
    many = len(figure.blocks)
    if ends is None:
        return []
    if said == {"middle"}:
        return list(range((many - count) // 2, (many + count) // 2)) if (many - count) % 2 == 0 else []
    if said == {ends[0]}:
        return list(range(count))
    return list(range(many - count, many)) if said == {ends[1]} else []


def _one_line(many: int, said: set[str], nth: int, first: str, last: str) -> list[int]:
    """Of what stands in one line, counted from the first end."""
    ends = said & {first, last}
    rest = said - {first, last, "end"}
    if nth:
        if rest or len(ends) != 1 or nth > many:
            raise Unclear
        return [nth - 1] if ends == {first} else [many - nth]
    if rest == {"middle"} and not ends:
        if many % 2 == 0:
            raise Unclear
        return [many // 2]
    if rest == {"alternate"} and not ends and many % 2 == 0:  # of five they are two or three
        return list(range(0, many, 2))
    if rest == {"outer"} or (said == {"end"}):
        return [0, many - 1]
    if rest or len(ends) != 1:
        raise Unclear
    return [0] if ends == {first} else [many - 1]


def _step(many: int, said: set[str], nth: int) -> list[int]:
    """The blocks of a step, from the table up; steps are counted from the lowest."""
    rest = said - {"step", "end"}
    if "step" not in said and rest != {"top"}:
        raise Unclear
    if rest == {"middle"} and many % 2 and not nth:
        at = many // 2
    elif nth and rest <= {"bottom", "top"} and nth <= many and rest:
        at = nth - 1 if rest == {"bottom"} else many - nth
    elif not nth and rest & {"short", "bottom"} and len(rest) == 1:
        at = 0
    elif not nth and rest & {"tall", "top"} and len(rest) == 1:
        at = many - 1
    elif not nth and not rest:
        return [k * (k + 3) // 2 for k in range(many)]  # what lies on each step lies on top
    else:
        raise Unclear
    return list(range(at * (at + 1) // 2, (at + 1) * (at + 2) // 2))


def _cells(figure: Figure) -> list[_Cell]:
    """Where the places of a figure are, in the order in which they are counted."""
    many = len(figure.blocks)
    if figure.kind == "plus" and many % 4 == 1:
        arm = many // 4
        far, near = ([_Cell(arm, y) for y in ys] for ys in (range(arm), range(arm + 1, 2 * arm + 1)))
        return [*far, *(_Cell(x, arm) for x in range(2 * arm + 1)), *near]
    if figure.kind == "square" and many % 4 == 0:
        side = many // 4
        edge = {0, side}
        return [_Cell(x, y) for y in range(side + 1) for x in range(side + 1) if x in edge or y in edge]
    if figure.kind == "pyramid" and not figure.size and (high := steps(many)):
        return [_Cell(x - level / 2, 0, high - level) for level in range(1, high + 1) for x in range(1, level + 1)]
    if len(figure.size) == 3:
        wide, deep, high = figure.size
        return [_Cell(x, y, z) for z in reversed(range(high)) for y in range(deep) for x in range(wide)]
    if not (wide := columns(figure)):
        return []
    tall = many // wide
    if figure.kind == "wall":
        return [_Cell(x, 0, z) for z in reversed(range(tall)) for x in range(wide)]
    return [_Cell(x, y) for y in range(tall) for x in range(wide)]


def _of_cells(figure: Figure, cells: list[_Cell], said: set[str], nth: int, count: int) -> list[int]:
    """Of rows, columns and layers: of what stands upright the rows are layers."""
    varied = [axis for axis in range(3) if len({cell[axis] for cell in cells}) > 1]
    sides = {side for side in said & set(_AXES) if _AXES[side][0] in varied}
    units, rest = said & _LINES, said - sides
    if len(units) > 1 or len({_AXES[side][0] for side in sides}) < len(sides):
        raise Unclear
    if units:
        return _whole_line(figure, cells, units.pop(), said - _LINES, nth)
    if nth:
        raise Unclear
    found = [n for n, cell in enumerate(cells) if _at_sides(cells, cell, sides)]
    if said == {"middle"}:
        found = [n for n in found if all(_is_middle(cells, cells[n], axis) for axis in varied)]
    elif rest and figure.kind == "plus" and (rest == {"end"} or (rest == {"arm"} and len(cells) == 5)):
        found = [n for n in found if any(_is_end(cells, cells[n], axis) for axis in varied)]
    elif rest == {"corner"} and figure.kind != "plus":
        found = [n for n in found if all(_is_end(cells, cells[n], axis) for axis in varied)]
        if len(sides) == 2 and len(found) == 2 and len(varied) == 3:  # of a cube, from above
            found = [n for n in found if _at_sides(cells, cells[n], {"top"})]
    elif rest == {"end"} and figure.kind == "wall":  # what lies on the end of a wall lies on top
        found = [n for n in found if _is_end(cells, cells[n], 0) and _at_sides(cells, cells[n], {"top"})]
    elif rest or len(found) not in {1, count if count > 0 else len(found)}:
        raise Unclear  # a whole side
    if not found:
        raise Unclear
    return found


def _whole_line(figure: Figure, cells: list[_Cell], unit: str, said: set[str], nth: int) -> list[int]:
    """ "the far row", "the second column from the left", "the bottom layer", "the left side"."""
    flat = all(cell.z == cells[0].z for cell in cells)
    axes = {"row": 1 if flat else 2, "column": 0, "layer": 2}
    if len(said) != 1 or (unit in {"row", "column"} and not flat and len(figure.size) == 3):
        raise Unclear
    rank = next(iter(said))
    axis = axes.get(unit, _AXES[rank][0] if rank in _AXES else -1)
    at = sorted({cell[axis] for cell in cells})
    if (unit not in {"layer"} and figure.kind in {"plus", "square"}) or (figure.kind == "pyramid" and axis != 2):
        raise Unclear
    if rank == "middle" and not nth and len(at) % 2:
        chosen = at[len(at) // 2]
    elif rank in _AXES and _AXES[rank][0] == axis and max(nth, 1) <= len(at) and len(at) > 1:
        first = _AXES[rank][1] is min
        chosen = at[max(nth, 1) - 1 if first else -max(nth, 1)]
    else:
        raise Unclear
    return [n for n, cell in enumerate(cells) if cell[axis] == chosen]


def _is_end(cells: list[_Cell], cell: _Cell, axis: int) -> bool:
    values = [c[axis] for c in cells]
    return cell[axis] in {min(values), max(values)}


def _is_middle(cells: list[_Cell], cell: _Cell, axis: int) -> bool:
    values = [c[axis] for c in cells]
    return 2 * cell[axis] == min(values) + max(values)


def _at_sides(cells: list[_Cell], cell: _Cell, sides: set[str]) -> bool:
    return all(cell[axis] == end(c[axis] for c in cells) for axis, end in (_AXES[side] for side in sides))
