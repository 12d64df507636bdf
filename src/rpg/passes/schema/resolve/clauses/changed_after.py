""" "Build a tower of red, blue and green, then swap the top two": what is built first is changed in a later step."""

from __future__ import annotations

from collections.abc import Sequence

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir import structures as s
from rpg.ir.node import members
from rpg.ir.schema import EXCHANGED_LATER
from rpg.language.meaning import (
    Absolute,
    At,
    Chain,
    Clause,
    Coord,
    Into,
    Loc,
    Meaning,
    Noun,
    OrderBy,
    Structure,
    Toward,
    parts_of,
    replace,
)
from rpg.passes.schema.resolve.goals.conflicts import required
from rpg.passes.schema.resolve.things.world import Scene

_LINES = frozenset({"row", "line", "stack", "column"})
_CHANGING = frozenset({"swap", "reverse"})
"""What changes the order of a line, whichever it is."""


def in_their_order(links: Sequence[str], chains: tuple[Chain, ...]) -> tuple[Chain, ...]:
    """The sentences; a line whose order is changed in the next step has its blocks in the order of their names."""
    found: list[Chain] = []
    for n, chain in enumerate(chains):
        clauses = list(chain.clauses)
        for k, clause in enumerate(clauses):
            after = (chain.links[k + 1], clauses[k + 1]) if k + 1 < len(clauses) else None
            if after is None and n + 1 < len(chains):
                after = links[n + 1], chains[n + 1].clauses[0]
            if after is not None and after[0] == "then" and getattr(after[1], "verb", "") in _CHANGING:
                clauses[k] = _as_named(clause)
        found.append(replace(chain, clauses=tuple(clauses)) if tuple(clauses) != chain.clauses else chain)
    return tuple(found)


def _as_named(clause: Meaning) -> Meaning:
    """A clause that builds a line of blocks that it lists, and tells no order of them."""
    if not isinstance(clause, Clause) or clause.mode == "start" or clause.negated or clause.theme is None:
        return clause
    shapes = [x for x in parts_of(clause) if isinstance(x, Structure)]
    told = [x for x in parts_of(clause) if isinstance(x, OrderBy | Toward | At | Absolute)]
    stacked = (clause.verb == "stack" or clause.lemma == "line") and not any(
        isinstance(x, Loc | Into) for x in clause.adjuncts
    )
    plain = len(shapes) == 1 and shapes[0].kind in _LINES and not shapes[0].plural
    blocks = shapes[0].members if plain and clause.theme is shapes[0] else clause.theme
    if told or not (plain or (stacked and not shapes)) or not _listed(blocks):
        return clause
    return replace(clause, adjuncts=(*clause.adjuncts, OrderBy(by="given", span=clause.theme.span)))


def _listed(blocks: Meaning | None) -> bool:
    """Whether several blocks are named one by one."""
    if isinstance(blocks, Coord):
        return blocks.op == "and" and all(
            isinstance(x, Noun) and x.amount in (None, (1, 1, False)) for x in blocks.items
        )
    return isinstance(blocks, Noun) and len({*blocks.traits.colors, *blocks.traits.labels}) > 1


def exchanged_in_line(goals: list[g.Goal], scene: Scene) -> list[g.Goal]:
    """Stages, with a swap of two blocks of the line that the stage before it builds told as that line."""
    found: list[g.Goal] = []
    for goal in goals:
        before = [x for x in required(found[-1]) if isinstance(x, s.Row | s.Stack | r.On)] if found else []
        if isinstance(goal, r.Swapped) and len(before) == 1 and (other := _exchanged(before[0], goal)) is not None:
            scene.assume(EXCHANGED_LATER)
            goal = other
        found.append(goal)
    return found


def _exchanged(told: g.Goal, swap: r.Swapped) -> g.Goal | None:
    """A line, or one block on another, with two blocks in each other's places."""
    one, two = (*members(swap.a),), (*members(swap.b),)
    if len(one) != 1 or len(two) != 1:
        return None
    if isinstance(told, r.On):
        pair = {told.a, told.b} == {one, two}
        return told.model_copy(update={"a": told.b, "b": told.a, "span": swap.span}) if pair else None
    if not isinstance(told, s.Row | s.Stack) or told.order.by != "given" or not {*one, *two} <= {*told.blocks}:
        return None
    other = {one[0]: two[0], two[0]: one[0]}
    ranks = tuple(tuple(other.get(name, name) for name in rank) for rank in told.order.ranks)
    blocks = tuple(other.get(name, name) for name in told.blocks)
    order = told.order.model_copy(update={"ranks": ranks})
    return told.model_copy(update={"blocks": blocks, "order": order, "span": swap.span})
