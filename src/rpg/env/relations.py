"""One method per relation of the goal language; each judges the state as it is now."""

from __future__ import annotations

from typing import Literal

from rpg.blocks.verdict import Verdict
from rpg.env.surface import Atoms, Names, Where
from rpg.ir.assets import Face
from rpg.ir.node import Direction
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
    Region,
    RightOf,
    Shifted,
    Stayed,
    Swapped,
    TookPlace,
    Touching,
    Turned,
)


class Relations(Atoms):
    """One method per relation of the goal language; each judges the state as it is now."""

    def on(
        self,
        a: Where,
        b: Where,
        *,
        gap: float = 0.01,
        offset_edges: float = 0.5,
        slack: float = 0.002,
        tilt: float = 15.0,
    ) -> Verdict:
        """`a` rests directly on `b`."""
        return self._atom(On, a=a, b=b, gap=gap, offset_edges=offset_edges, slack=slack, tilt=tilt)

    def above(self, a: Where, b: Where) -> Verdict:
        """`a` is somewhere above `b` in the same stack."""
        return self._atom(Above, a=a, b=b)

    def on_table(self, a: Where, *, gap: float = 0.01) -> Verdict:
        """Each of `a` rests on the table."""
        return self._atom(OnTable, a=a, gap=gap)

    def clear(self, a: Where) -> Verdict:
        """Nothing rests on any of `a`."""
        return self._atom(Clear, a=a)

    def on_patch(self, a: Where, patch: str) -> Verdict:
        """Each of `a` has its centre inside the outline of `patch`, on the table or on blocks that are."""
        return self._atom(OnPatch, a=a, patch=patch)

    def empty(self, patch: str) -> Verdict:
        """No block's footprint overlaps `patch`."""
        return self._atom(Empty, patch=patch)

    def left_of(
        self,
        a: Where,
        b: Where,
        *,
        somewhere: bool = False,
        directly: bool = False,
        immediate: bool = False,
        min_edges: float = 1.0,
        across_edges: float = 0.5,
        gap_edges: float = 0.5,
    ) -> Verdict:
        """`a` is to the left of `b`, as the viewer sees it."""
        return self._atom(
            LeftOf,
            a=a,
            b=b,
            somewhere=somewhere,
            directly=directly,
            immediate=immediate,
            min_edges=min_edges,
            across_edges=across_edges,
            gap_edges=gap_edges,
        )

    def right_of(
        self,
        a: Where,
        b: Where,
        *,
        somewhere: bool = False,
        directly: bool = False,
        immediate: bool = False,
        min_edges: float = 1.0,
        across_edges: float = 0.5,
        gap_edges: float = 0.5,
    ) -> Verdict:
        """`a` is to the right of `b`, as the viewer sees it."""
        return self._atom(
            RightOf,
            a=a,
            b=b,
            somewhere=somewhere,
            directly=directly,
            immediate=immediate,
            min_edges=min_edges,
            across_edges=across_edges,
            gap_edges=gap_edges,
        )

    def in_front_of(
        self,
        a: Where,
        b: Where,
        *,
        somewhere: bool = False,
        directly: bool = False,
        immediate: bool = False,
        min_edges: float = 1.0,
        across_edges: float = 0.5,
        gap_edges: float = 0.5,
    ) -> Verdict:
        """`a` is in front of `b`, as the viewer sees it."""
        return self._atom(
            InFrontOf,
            a=a,
            b=b,
            somewhere=somewhere,
            directly=directly,
            immediate=immediate,
            min_edges=min_edges,
            across_edges=across_edges,
            gap_edges=gap_edges,
        )

    def behind(
        self,
        a: Where,
        b: Where,
        *,
        somewhere: bool = False,
        directly: bool = False,
        immediate: bool = False,
        min_edges: float = 1.0,
        across_edges: float = 0.5,
        gap_edges: float = 0.5,
    ) -> Verdict:
        """`a` is behind `b`, as the viewer sees it."""
        return self._atom(
            Behind,
            a=a,
            b=b,
            somewhere=somewhere,
            directly=directly,
            immediate=immediate,
            min_edges=min_edges,
            across_edges=across_edges,
            gap_edges=gap_edges,
        )

    def beside(self, a: Where, b: Where, *, gap_edges: float = 1.0) -> Verdict:
        """Both level, the gap between the two footprints at most `gap_edges`.

        For groups, between their nearest members.
        """
        return self._atom(Beside, a=a, b=b, gap_edges=gap_edges)

    def adjacent(self, a: Where, b: Where, *, gap_edges: float = 0.5) -> Verdict:
        """Both level, the gap between the two footprints at most `gap_edges`."""
        return self._atom(Adjacent, a=a, b=b, gap_edges=gap_edges)

    def touching(self, a: Where, b: Where, *, gap: float = 0.002) -> Verdict:
        """The gap between the two bodies is at most `gap`, at any height."""
        return self._atom(Touching, a=a, b=b, gap=gap)

    def near(self, a: Where, b: Where, *, distance: float = 0.1) -> Verdict:
        """Centres at most `distance` apart in the plane; for groups, the nearest members."""
        return self._atom(Near, a=a, b=b, distance=distance)

    def apart(self, a: Where, b: Where, *, distance: float = 0.1) -> Verdict:
        """Centres at least `distance` apart in the plane; for groups, the nearest members."""
        return self._atom(Apart, a=a, b=b, distance=distance)

    def distance(
        self,
        a: Where,
        b: Where,
        *,
        minimum: float | None = None,
        maximum: float | None = None,
        measure: Literal["centres", "faces"] = "centres",
    ) -> Verdict:
        """The distance between `a` and `b` in the plane, between centres or faces, lies in [minimum, maximum]."""
        return self._atom(Distance, a=a, b=b, minimum=minimum, maximum=maximum, measure=measure)

    def between(self, a: Where, b: Where, c: Where, *, within_edges: float = 1.0) -> Verdict:
        """`a` has its foot on the segment from `b` to `c`, inside its ends and within `within_edges` of the line.

        Where the three stand in one tower, `a` is between the other two in height.
        """
        return self._atom(Between, a=a, b=b, c=c, within_edges=within_edges)

    def closer(self, a: Where, b: Where, c: Where, *, by: float = 0.01) -> Verdict:
        """Each of `a` is closer to each of `b` than to any of `c`: in the plane, between centres, by at least `by`."""
        return self._atom(Closer, a=a, b=b, c=c, by=by)

    def equidistant(self, a: Where, b: Where, c: Where, *, tolerance: float = 0.01) -> Verdict:
        """Each of `a` is at the same distance from all of `b` and `c`.

        Between centres in the plane, these differ by at most `tolerance`.
        """
        return self._atom(Equidistant, a=a, b=b, c=c, tolerance=tolerance)

    def in_region(self, a: Where, region: Region) -> Verdict:
        """Each of `a` has its centre in a region of the table, as the viewer names it."""
        return self._atom(InRegion, a=a, region=region)

    def facing(
        self,
        block: str,
        *,
        face: Face | None = None,
        label: str | None = None,
        toward: Literal["up", "down", "left", "right", "front", "back", "viewer"] = "up",
        turn: float | None = None,
        normal_cos: float = 0.97,
        upright_cos: float = 0.94,
    ) -> Verdict:
        """A face of `block` (or every face that shows `label`: any of them will do) points `toward` a direction.

        The glyph on it is turned by `turn` degrees from upright, counter-clockwise as seen by its reader (180:
        upside down); None asks for no turn in the plane. `viewer` is whichever of up and towards the viewer shows
        the face.
        """
        return self._atom(
            Facing,
            block=block,
            face=face,
            label=label,
            toward=toward,
            turn=turn,
            normal_cos=normal_cos,
            upright_cos=upright_cos,
        )

    def stayed(self, a: Where, *, tolerance: float = 0.02) -> Verdict:
        """Each of `a` is within `tolerance` of where the episode found it."""
        return self._atom(Stayed, a=a, tolerance=tolerance)

    def moved(self, a: Where, *, at_least: float = 0.05) -> Verdict:
        """Each of `a` is at least `at_least` from where the episode found it."""
        return self._atom(Moved, a=a, at_least=at_least)

    def shifted(
        self,
        a: Where,
        toward: Direction,
        *,
        at_least: float = 0.05,
        at_most: float | None = None,
        across: float | None = None,
    ) -> Verdict:
        """Each of `a` is on one side of where the episode found it, by at least `at_least` and at most `at_most`.

        It is off the axis by at most `across`; where that is left out, by no more than it went along it.
        """
        return self._atom(Shifted, a=a, toward=toward, at_least=at_least, at_most=at_most, across=across)

    def approached(self, a: Where, b: Where, *, at_least: float = 0.02, at_most: float | None = None) -> Verdict:
        """Each of `a` is closer to each of `b` than at the start: between centres, by at least `at_least`.

        Where `a` and `b` are the same blocks, every two of them are.
        """
        return self._atom(Approached, a=a, b=b, at_least=at_least, at_most=at_most)

    def receded(self, a: Where, b: Where, *, at_least: float = 0.02, at_most: float | None = None) -> Verdict:
        """Each of `a` is farther from each of `b` than at the start: between centres, by at least `at_least`.

        Where `a` and `b` are the same blocks, every two of them are.
        """
        return self._atom(Receded, a=a, b=b, at_least=at_least, at_most=at_most)

    def swapped(self, a: Names, b: Names, *, tolerance: float = 0.03) -> Verdict:
        """`a` and `b` each stand within `tolerance` of where the other started."""
        return self._atom(Swapped, a=a, b=b, tolerance=tolerance)

    def took_place(self, a: Names, b: Names, *, tolerance: float = 0.03) -> Verdict:
        """`a` stand within `tolerance` of where `b` started, one for one."""
        return self._atom(TookPlace, a=a, b=b, tolerance=tolerance)

    def turned(self, block: str, degrees: float, *, either_way: bool = False, tolerance: float = 15.0) -> Verdict:
        """`block` has turned about the vertical by `degrees` since the start.

        Counter-clockwise from above is positive.
        """
        return self._atom(Turned, block=block, degrees=degrees, either_way=either_way, tolerance=tolerance)
