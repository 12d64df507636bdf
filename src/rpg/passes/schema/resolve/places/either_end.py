""" "Red at one end", "A at the left end and B at the other one", "red and blue at the ends": ends that have no name."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import product

from rpg.core.diagnostics import Span
from rpg.ir import goal as g
from rpg.ir import structures as s
from rpg.ir.walk import transform
from rpg.language.meaning import At, Meaning, Places, replace
from rpg.passes.schema.resolve.goals.logic import disj
from rpg.passes.schema.resolve.orders.agreeing import OPPOSITE
from rpg.passes.schema.resolve.things.world import Ref, refuse

Line = s.Stack | s.Row
Loose = tuple[Ref, At, Span]


def at_an_end(place: At | Places) -> bool:
    """Whether a place is one of the two ends, and it is not said which."""
    if isinstance(place, At):
        return place.side in ("end", "ends")
    return place.side == "ends" and place.several == 1


def ends_named(places: Sequence[At | Places], first: str) -> tuple[list[str], bool]:
    """The ends of those places that are at an end without a name, and whether all may be the other way round as well.

    `first`: the side that the line begins at. The other end is the one where no other block is said to be.
    """
    open_ = [place for place in places if at_an_end(place)]
    told = [place for place in places if not at_an_end(place)]
    taken = {place.side for place in told if place.side in (first, OPPOSITE[first]) and place.index in (None, 1)}
    if not open_:
        return [], False
    if len(open_) + len(taken) > 2:
        raise refuse("contradiction", "a line has two ends, and more blocks are said to be there", open_[0].span,
                     "name one block for each end")  # fmt: skip
    if not all(place.side in ("middle", "rest") or place.side in taken for place in told):
        raise refuse("ambiguous", "it is not clear which end this is", open_[0].span,
                     f"say '{first}' or '{OPPOSITE[first]}'")  # fmt: skip
    ends = [side for side in (first, OPPOSITE[first]) if side not in taken]
    return ends[: len(open_)], not taken


def each_at_its_end(loose: list[Loose], first: str) -> tuple[list[Loose], bool]:
    """Blocks and their places in a line, each at an end that has a name; and whether the line may be turned round."""
    both = next(((ref, at_) for ref, at_, _ in loose if at_.side == "ends" and len(ref.names) != 2), None)
    if both is not None:
        raise refuse("count-mismatch", "a line has two ends", both[1].span, "name two blocks, or say 'at one end'")
    single = [
        (Ref(names=(name,)) if at_an_end(at_) else ref, at_, span)
        for ref, at_, span in loose
        for name in (ref.names if at_an_end(at_) else ref.names[:1])
    ]
    sides, free = ends_named([at_ for _, at_, _ in single], first)
    named = iter(sides)
    return [(r, replace(a, side=next(named)) if at_an_end(a) else a, span) for r, a, span in single], free


def one_of_them(
    goal: g.Goal,
    loose: list[tuple[Ref, Meaning, Span]],
    lines: list[Line],
    placed: Callable[[Line, list[tuple[Ref, Meaning, Span]]], g.Goal],
) -> g.Goal:
    """ "Red or blue is at the left end": the line with one of them there, or with the other one.

    `placed`: a line with blocks at places of it.
    """
    names = {name for ref, _, _ in loose for name in ref.names}
    line = next((node for node in lines if names <= {*node.blocks}), None)
    chosen = [[(part, at_, span) for part in (ref.parts if ref.op != "and" else (ref,))] for ref, at_, span in loose]
    if line is None:
        raise refuse("ambiguous", "it is not clear which block is meant", loose[0][2], "name one block")
    found = disj([placed(line, list(told)) for told in product(*chosen)], loose[0][2])
    return transform(goal, lambda node: found if node == line else node)
