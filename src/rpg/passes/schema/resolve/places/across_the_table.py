"""Halves of the table, and sides that are the table's as those across were told to be."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import members
from rpg.ir.walk import atoms
from rpg.language.meaning import At, In, Meaning
from rpg.passes.schema.resolve.orders.agreeing import OPPOSITE
from rpg.passes.schema.resolve.things.world import Ref

REGION = {"left": "left_half", "right": "right_half", "front": "near_half", "back": "far_half", "middle": "middle"}


def table_sides(places: Sequence[Meaning]) -> list[In]:
    """The sides as those of the table, where all of them can be."""
    plain = [at_ for at_ in places if isinstance(at_, At) and not at_.whole and at_.index is None and not at_.own]
    found = [In(region=REGION[at_.side], span=at_.span) for at_ in plain if at_.side in REGION]
    return found if len(found) == len(places) else []


def across_the_table(loose: Sequence[tuple[Ref, Meaning, Span]], goal: g.Goal) -> bool:
    """ "A tower on the left side of the table and a tower on the right side": the side across of the table, too."""
    sides = {at_.side for _, at_, _ in loose if isinstance(at_, At) and not at_.whole and at_.index is None}
    own = {name for ref, _, _ in loose for name in ref.names}
    across = {REGION[OPPOSITE[side]] for side in sides if side in OPPOSITE and side in REGION}
    halves = [a for a in atoms(goal) if isinstance(a, r.InRegion) and a.region in across]
    return len(loose) == len(across) == 1 and bool(halves) and not any(own & {*members(a.a)} for a in halves)
