"""Two numbers of blocks compared: one after another, at least so many of the ones and fewer of the others."""

from __future__ import annotations

from rpg.ir import goal as g
from rpg.ir import relations as r
from rpg.ir.node import EACH
from rpg.ir.walk import names as names_in
from rpg.language.grammar.clauses.numbers_compared import SOME_OF_THEM
from rpg.language.meaning import Clause, Coord, In, Loc, Manner, Meaning, Noun, Traits
from rpg.passes.schema.resolve.clauses.spec import Spec
from rpg.passes.schema.resolve.goals.logic import conj, disj
from rpg.passes.schema.resolve.things.refer import refer
from rpg.passes.schema.resolve.things.things import matching
from rpg.passes.schema.resolve.things.world import Scene, Scope, refuse

Goals = list[g.Goal]
Side = tuple[tuple[str, ...], g.Goal]
"""Blocks, and what is counted of them."""


def compared_numbers(clause: Clause, spec: Spec, scene: Scene, scope: Scope) -> Goals:
    """The numbers that go together, any of them; two that are equal are not both none, or nothing was to be done."""
    if len(spec.manners) != 1:
        raise refuse("misplaced", "what else is told of the blocks has no place here", clause.span, "use two sentences")
    (how,), spec.manners, spec.places = [*spec.manners], [], []
    lots = clause.theme.items if isinstance(clause.theme, Coord) else (clause.theme,)
    spots = [_there(x, scene, scope) for x in clause.adjuncts if x is not how]
    names = [_blocks(lot, scene) for lot in lots]
    one, other = (names[0], spots[0]), (names[-1], spots[-1])
    if clause.negated or scope.start or one == other or (len(names) > 1 and not {*names[0]}.isdisjoint(names[1])):
        raise refuse("ambiguous", "it is not clear which two numbers are compared", clause.span,
                     "say for example 'exactly two of the three red blocks'")  # fmt: skip
    exact = bool(how.value) or how.kind == "twice"
    whole = names[0] == names[-1] and (exact or _all_placed(names[0], scene))
    parted = _parted(how, one, other) if whole else []
    if parted and exact and clause.lemma == SOME_OF_THEM and not _all_placed(names[0], scene):
        raise refuse("ambiguous", "is each of them to be in one place or the other, or only some of them?", clause.span,
                     f"say 'all {len(names[0])} of them', or how many are where")  # fmt: skip
    if parted and exact:
        scene.assume("all blocks that are there are in one of the two places")
    ways = parted or _ways(how, one, other)
    pairs = [conj(goals, clause.span) for goals in ways]
    if not pairs:
        raise refuse("count-mismatch", "there are not enough blocks for that", clause.span, "say how many there are")
    return [disj(pairs, clause.span)]


def _all_placed(names: tuple[str, ...], scene: Scene) -> bool:
    """Whether it was said where each of them is to be: "spread the seven blocks over the two mats"."""
    placed = {name for goals in scene.goals.values() for goal in goals for name in names_in(goal)}
    return placed.issuperset(names)


def _parted(how: Manner, one: Side, other: Side) -> list[list[g.Goal]]:
    """Pairs of numbers that make up all of the blocks, each of which would do."""
    many, by = len(one[0]), int(how.value) if isinstance(how.value, float) else 0
    return [
        [_so_many(one, n, n), _so_many(other, many - n, many - n)]
        for n in range(many + 1)
        if _compares(how.kind, by, n, many - n)
    ]


def _compares(kind: str, by: int, many: int, others: int) -> bool:
    """Whether two numbers compare as it is said."""
    if kind == "fewer":
        many, others = others, many
    if kind in ("more", "fewer"):
        return many - others == by if by else many > others
    if kind == "at least":
        return many >= others > 0
    return many == others * (2 if kind == "twice" else 1) > 0


def _ways(how: Manner, one: Side, other: Side) -> list[list[g.Goal]]:
    """Pairs of numbers, each of which would do."""
    by = int(how.value) if isinstance(how.value, float) else 0
    if how.kind == "fewer":
        one, other = other, one
    many, others = len(one[0]), len(other[0])
    if one[0] == other[0]:  # no block is in both places
        times = 2 if how.kind == "twice" else 1
        others = (many - (by or int(how.kind in ("more", "fewer")))) // (times + 1)
    if by:
        return [[_so_many(one, n + by, n + by), _so_many(other, n, n)] for n in range(min(many - by, others) + 1)]
    if how.kind in ("more", "fewer"):
        return [[_so_many(one, n + 1, None), *_at_most(other, n)] for n in range(min(many - 1, others) + 1)]
    if how.kind == "at least":
        return [[_so_many(one, n, None), *_at_most(other, n)] for n in range(1, min(many, others) + 1)]
    times = 2 if how.kind == "twice" else 1
    return [
        [_so_many(one, n * times, n * times), _so_many(other, n, n)]
        for n in range(1, min(many // times, others) + 1)
    ]  # fmt: skip


def _at_most(side: Side, high: int) -> list[g.Goal]:
    """Nothing where there are no more."""
    return [_so_many(side, 0, high)] if high < len(side[0]) else []


def _so_many(side: Side, low: int, high: int | None) -> g.Goal:
    names, there = side
    return g.Count(over=names, at_least=low, at_most=high, goal=there)


def _there(spot: Meaning, scene: Scene, scope: Scope) -> g.Goal:
    """That a block is at a place."""
    if isinstance(spot, In):
        if spot.region.startswith(("each", "opposite", "other")):
            raise refuse("misplaced", "this is no one place where blocks are counted", spot.span, "name one half")
        return r.InRegion(a=(EACH,), region=spot.region, span=spot.span)  # type: ignore[arg-type]
    assert isinstance(spot, Loc) and spot.landmark is not None
    mark = refer(spot.landmark, scene, Scope(role="landmark", rel="on", like_patch=True))
    if not mark.patch or len(mark.names) != 1:
        raise refuse("misplaced", "blocks are counted on one patch", spot.span, "name one patch")
    return r.OnPatch(a=(EACH,), patch=mark.names[0], span=spot.span)


def _blocks(lot: Meaning | None, scene: Scene) -> tuple[str, ...]:
    """Those that are compared: all such blocks that there are."""
    marks, span = (lot.traits, lot.span) if isinstance(lot, Noun) else (Traits(), (0, 0))
    there = matching(marks, scene, False)
    if len(there) < 1 or any(t.elastic is not None for t in there):
        raise refuse("ambiguous", "it is not said how many such blocks there are", span,
                     "say how many there are in a sentence of its own")  # fmt: skip
    names = tuple(t.name for t in there)
    scene.used.update(names)
    scene.surveyed.append((marks, names, span))
    return names
