"""One method per structure of the goal language; each judges the state as it is now."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from rpg.blocks.verdict import Verdict
from rpg.env.surface import Atoms, Names
from rpg.ir.node import Axis, Direction, Slope
from rpg.ir.order import Attribute, Order, Pattern
from rpg.ir.structures import Equation, Figure, Grid, GroupBy, Pyramid, Row, Spells, Stack, Staircase, Towers

ANY_ORDER = Order()


class Structures(Atoms):
    """One method per structure of the goal language; each judges the state as it is now."""

    def stack(
        self,
        blocks: Names,
        *,
        order: Order = ANY_ORDER,
        exact: bool = False,
        patch: str | None = None,
        readable: bool = False,
        excused: Names = (),
        raised: bool = False,
    ) -> Verdict:
        """`blocks` form one stack, bottom to top when the order is given; `order.first` is "bottom" unless it says
        "top".

        `exact`: nothing else is in the stack (its top is clear and its foot on the table or the patch). `patch`:
        the lowest block lies on that patch. `readable`: the symbols on the viewer's side read upright, but for
        cubes that are `excused` because another condition turns them in the plane of their face. `raised`: another
        condition puts the stack on a block, so that its foot need not be on the table.
        """
        return self._atom(
            Stack,
            blocks=blocks,
            order=order,
            exact=exact,
            patch=patch,
            readable=readable,
            excused=excused,
            raised=raised,
        )

    def towers(
        self,
        blocks: Names,
        *,
        count: int | None = None,
        heights: Sequence[int] | None = None,
        equal: bool = False,
        each: Attribute | None = None,
        separate: bool = False,
        matching: Names | None = None,
    ) -> Verdict:
        """`blocks` form towers and nothing else: stacks of two or more with clear tops that use every one of them.

        `count` towers; `heights` lists their heights in any order; `equal`: all of one height; `each`: every tower
        agrees in that attribute, and (`separate`) no two towers share its value. `matching`: every tower stands on
        a patch of its blocks' colour.
        """
        return self._atom(
            Towers,
            blocks=blocks,
            count=count,
            heights=heights,
            equal=equal,
            each=each,
            separate=separate,
            matching=matching,
        )

    def row(
        self,
        blocks: Names,
        *,
        axis: Axis | Slope | None = None,
        order: Order = ANY_ORDER,
        readable: bool = False,
        excused: Names = (),
        covered: Names = (),
        touching: bool = False,
        evenly: bool = False,
        spacing: float | None = None,
        gap: float | None = None,
        tolerance: float = 0.01,
        gap_edges: float = 1.5,
        line_edges: float = 0.5,
        even_edges: float = 0.5,
        angle: float = 15.0,
    ) -> Verdict:
        """`blocks` stand in one straight line.

        `axis` "y" lies from left to right, "x" from front to back (a column on the table), "rising" from the near
        left to the far right, "falling" from the far left to the near right, "diagonal" along either, at 45 degrees;
        within `angle` degrees of it. Gaps between neighbours' faces at most `gap_edges`, or `spacing` metres between
        centres, or `gap` metres between faces, each within `tolerance`. `evenly`: gaps within `even_edges` of each
        other. `readable`: symbols on top read upright for the viewer (but for those `excused`), and in the order's
        direction. `covered`: cubes that another condition puts a block on; the others that are read have nothing on
        them.
        """
        return self._atom(
            Row,
            blocks=blocks,
            axis=axis,
            order=order,
            readable=readable,
            excused=excused,
            covered=covered,
            touching=touching,
            evenly=evenly,
            spacing=spacing,
            gap=gap,
            tolerance=tolerance,
            gap_edges=gap_edges,
            line_edges=line_edges,
            even_edges=even_edges,
            angle=angle,
        )

    def grid(
        self,
        blocks: Names,
        rows: int,
        columns: int,
        *,
        pattern: Pattern | None = None,
        readable: bool = False,
        excused: Names = (),
        covered: Names = (),
        fit_edges: float = 0.5,
        pitch_edges: tuple[float, float] = (1.0, 2.0),
        gap: float | None = None,
        tolerance: float = 0.01,
        layers: int = 1,
        axis: Axis | None = None,
    ) -> Verdict:
        """`rows` lie along y, one behind the other along x; `columns` per row; `layers` high. A wall has one row."""
        return self._atom(
            Grid,
            blocks=blocks,
            rows=rows,
            columns=columns,
            pattern=pattern,
            readable=readable,
            excused=excused,
            covered=covered,
            fit_edges=fit_edges,
            pitch_edges=pitch_edges,
            gap=gap,
            tolerance=tolerance,
            layers=layers,
            axis=axis,
        )

    def pyramid(
        self,
        blocks: Names,
        base: tuple[int, int],
        *,
        pattern: Pattern | None = None,
        readable: bool = False,
        excused: Names = (),
        covered: Names = (),
        fit_edges: float = 0.5,
        pitch_edges: tuple[float, float] = (1.0, 2.0),
        gap: float | None = None,
        tolerance: float = 0.01,
    ) -> Verdict:
        """Layers of n, n-1, ... 1 blocks in a line (`base` = [n, 1]), or n x m, (n-1) x (m-1), ....

        `base` = [n, m].
        """
        return self._atom(
            Pyramid,
            blocks=blocks,
            base=base,
            pattern=pattern,
            readable=readable,
            excused=excused,
            covered=covered,
            fit_edges=fit_edges,
            pitch_edges=pitch_edges,
            gap=gap,
            tolerance=tolerance,
        )

    def staircase(
        self,
        blocks: Names,
        steps: int,
        *,
        pattern: Pattern | None = None,
        readable: bool = False,
        excused: Names = (),
        covered: Names = (),
        fit_edges: float = 0.5,
        pitch_edges: tuple[float, float] = (1.0, 2.0),
        gap: float | None = None,
        tolerance: float = 0.01,
        up: Direction | None = None,
    ) -> Verdict:
        """Columns of 1, 2, ... `steps` blocks side by side, going up towards `up` when it is given."""
        return self._atom(
            Staircase,
            blocks=blocks,
            steps=steps,
            pattern=pattern,
            readable=readable,
            excused=excused,
            covered=covered,
            fit_edges=fit_edges,
            pitch_edges=pitch_edges,
            gap=gap,
            tolerance=tolerance,
            up=up,
        )

    def figure(
        self,
        blocks: Names,
        shape: Literal["square", "rectangle", "triangle", "circle", "L", "T", "V", "U", "plus", "X"],
        *,
        pattern: Pattern | None = None,
        readable: bool = False,
        excused: Names = (),
        covered: Names = (),
        fit_edges: float = 0.5,
        pitch_edges: tuple[float, float] = (1.0, 2.0),
        gap: float | None = None,
        tolerance: float = 0.01,
        filled: bool = False,
        sides: tuple[int, int] | None = None,
        pointing: Direction | None = None,
    ) -> Verdict:
        """An outline or filled figure, or a letter shape, of `blocks` flat on the table.

        `sides`: cells along x and y for square, rectangle and plus, the side for triangle, the arms (long, short)
        for L, T, V, U; None takes what fits the number of blocks. `pointing`: where the apex of a triangle or V,
        the foot of an L (its stem behind it), the open side of a U, or the stem of a T points.
        """
        return self._atom(
            Figure,
            blocks=blocks,
            shape=shape,
            pattern=pattern,
            readable=readable,
            excused=excused,
            covered=covered,
            fit_edges=fit_edges,
            pitch_edges=pitch_edges,
            gap=gap,
            tolerance=tolerance,
            filled=filled,
            sides=sides,
            pointing=pointing,
        )

    def group_by(
        self,
        groups: Sequence[Names],
        *,
        by: Attribute | None = None,
        outliers: int = 0,
        inner_edges: float = 2.0,
        outer_edges: float = 1.5,
    ) -> Verdict:
        """`groups` lie apart: members chained by face gaps of at most `inner_edges`, groups at least `outer_edges`
        apart.

        Groups are also farther apart than any gap inside one. `by` is the attribute that tells the groups apart,
        where one does. `outliers`: exactly so many members of each group differ in `by` from the rest of it; the
        groups are then any division of the blocks that fits.
        """
        return self._atom(
            GroupBy, groups=groups, by=by, outliers=outliers, inner_edges=inner_edges, outer_edges=outer_edges
        )

    def spells(
        self,
        blocks: Names,
        word: str,
        *,
        along: Literal["row", "stack"] = "row",
        reverse: bool = False,
        readable: bool = True,
        excused: Names = (),
        covered: Names = (),
        beside: Names = (),
        gap_edges: float = 1.5,
    ) -> Verdict:
        """Cubes among `blocks` spell `word` from readable faces, and nothing else adjoins it.

        `along` "row": left to right on top faces; "stack": down a tower on the viewer's side, top first. `reverse`
        reads from the other end.
        """
        return self._atom(
            Spells,
            blocks=blocks,
            word=word,
            along=along,
            reverse=reverse,
            readable=readable,
            excused=excused,
            covered=covered,
            beside=beside,
            gap_edges=gap_edges,
        )

    def equation(
        self,
        blocks: Names,
        *,
        along: Literal["row", "stack"] = "row",
        longer: bool = False,
        text: str | None = None,
        excused: Names = (),
        covered: Names = (),
        beside: Names = (),
        gap_edges: float = 1.5,
    ) -> Verdict:
        """All of `blocks`, read in a row from left to right (or down a stack), form a true equation.

        `longer`: numbers of several digits are allowed. `text` fixes the equation; None accepts every true one.
        """
        return self._atom(
            Equation,
            blocks=blocks,
            along=along,
            longer=longer,
            text=text,
            excused=excused,
            covered=covered,
            beside=beside,
            gap_edges=gap_edges,
        )
